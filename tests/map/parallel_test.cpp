// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/parallel.hpp"

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "support/catch.hpp"

namespace {

using namespace straightedge;

TEST_CASE("every index is worked on once, by a thread of the pool", "[parallel]") {
  for (const unsigned threads : {1U, 2U, 3U, 8U}) {
    ThreadPool pool(threads);
    CHECK(pool.threads() == threads);
    for (const std::size_t count : {0U, 1U, 2U, 7U, 1000U}) {
      std::vector<std::atomic<int>> calls(count);
      std::atomic<bool> known_thread = true;
      pool.for_each_index(count, [&](std::size_t i, unsigned thread) {
        ++calls[i];
        if (thread >= threads) known_thread = false;
      });
      CHECK(known_thread);
      for (const auto& c : calls) CHECK(c == 1);
    }
  }
}

TEST_CASE("one thread takes the indices in order, on the caller's own", "[parallel]") {
  std::vector<std::size_t> order;
  const auto caller = std::this_thread::get_id();
  for_each_index(5, 1, [&](std::size_t i, unsigned) {
    order.push_back(i);
    CHECK(std::this_thread::get_id() == caller);
  });
  CHECK(order == std::vector<std::size_t>{0, 1, 2, 3, 4});
}

TEST_CASE("two threads work at the same time, and an index may wait for one before it", "[parallel]") {
  std::atomic<bool> first_is_done = false;
  std::atomic<unsigned> second = 0;
  for_each_index(2, 2, [&](std::size_t i, unsigned thread) {
    if (i == 0) {
      while (second == 0) std::this_thread::yield();
      first_is_done = true;
    } else {
      second = thread + 1;
      while (!first_is_done) std::this_thread::yield();
    }
  });
  CHECK(first_is_done);
}

TEST_CASE("what is thrown leaves the call; the lowest index decides; the pool goes on", "[parallel]") {
  for (const unsigned threads : {1U, 2U, 8U}) {
    ThreadPool pool(threads);
    for (int round = 0; round < 20; ++round) {
      std::atomic<std::size_t> begun = 0;
      std::string thrown;
      try {
        pool.for_each_index(10000, [&](std::size_t i, unsigned) {
          ++begun;
          if (i == 20) std::this_thread::sleep_for(std::chrono::milliseconds(1));
          if (i >= 20) throw std::runtime_error(std::to_string(i));
        });
      } catch (const std::runtime_error& e) {
        thrown = e.what();
      }
      CHECK(thrown == "20");
      CHECK(begun <= 21 + threads);
      std::atomic<std::size_t> sum = 0;
      pool.for_each_index(100, [&](std::size_t i, unsigned) { sum += i; });
      CHECK(sum == 4950);
    }
  }
}

TEST_CASE("without a number of threads there is one for each processor", "[parallel]") {
  CHECK(processors() >= 1);
  CHECK(ThreadPool().threads() == processors());
}

}  // namespace
