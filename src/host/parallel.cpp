// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace straightedge {
namespace {

/// The indices of one call and what became of them.
struct Job {
  const ThreadPool::Work& work;
  const std::size_t count;
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::size_t failed = 0;
  std::exception_ptr failure;

  void take_part(unsigned thread) {
    for (;;) {
      const std::size_t index = next.fetch_add(1);
      if (index >= count) return;
      try {
        work(index, thread);
      } catch (...) {
        fail(index);
      }
    }
  }

 private:
  void fail(std::size_t index) {
    next.store(count);
    const std::lock_guard lock(mutex);
    if (failure && failed < index) return;
    failed = index;
    failure = std::current_exception();
  }
};

}  // namespace

unsigned processors() noexcept {
  return std::max(1U, std::thread::hardware_concurrency());
}

struct ThreadPool::Team {
  std::mutex mutex;
  std::condition_variable begins, ends;
  Job* job = nullptr;  // null: nothing that one could still join
  std::atomic<std::uint64_t> jobs = 0;
  std::atomic<unsigned> busy = 0;
  std::atomic<bool> over = false;
  std::vector<std::thread> threads;

  void serve(unsigned thread) {
    std::uint64_t seen = 0;
    for (;;) {
      look_for([&] { return jobs.load(std::memory_order_relaxed) != seen || over; });
      std::unique_lock lock(mutex);
      begins.wait(lock, [&] { return over || (job != nullptr && jobs != seen); });
      if (over) return;
      seen = jobs;
      Job& mine = *job;
      ++busy;
      lock.unlock();
      mine.take_part(thread);
      lock.lock();
      if (--busy == 0) ends.notify_all();
    }
  }

  void open(Job& opened) {
    const std::lock_guard lock(mutex);
    job = &opened;
    ++jobs;
    begins.notify_all();
  }

  // A thread that wakes too late is not waited for.
  void close() {
    {
      const std::lock_guard lock(mutex);
      job = nullptr;
    }
    look_for([this] { return busy.load(std::memory_order_relaxed) == 0; });
    std::unique_lock lock(mutex);
    ends.wait(lock, [this] { return busy == 0; });
  }

 private:
  // A tenth of a millisecond before a thread goes to sleep: to wake it takes as long as a stripe of a small picture,
  // and work that comes in steps has the next one ready at once.
  template <class Done>
  static void look_for(Done done) {
    constexpr int times = 5000;
    for (int i = 0; i < times && !done(); ++i) rest_a_little();
  }
  static void rest_a_little() {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    __asm__ volatile("yield");
#endif
  }
};

ThreadPool::ThreadPool(unsigned threads) : team_(std::make_unique<Team>()) {
  if (threads == 0) threads = processors();
  team_->threads.reserve(threads - 1);
  try {
    for (unsigned t = 1; t < threads; ++t)
      team_->threads.emplace_back([team = team_.get(), t] { team->serve(t); });
  } catch (const std::system_error&) {
    // The caller's thread does what the missing ones would have done.
  }
}

ThreadPool::~ThreadPool() {
  {
    const std::lock_guard lock(team_->mutex);
    team_->over = true;
  }
  team_->begins.notify_all();
  for (std::thread& thread : team_->threads) thread.join();
}

unsigned ThreadPool::threads() const noexcept {
  return static_cast<unsigned>(team_->threads.size()) + 1;
}

void ThreadPool::for_each_index(std::size_t count, const Work& work) {
  Job job{.work = work, .count = count, .next = 0, .mutex = {}, .failed = 0, .failure = {}};
  const bool alone = count < 2 || team_->threads.empty();
  if (!alone) team_->open(job);
  job.take_part(0);
  if (!alone) team_->close();
  if (job.failure) std::rethrow_exception(job.failure);
}

void for_each_index(std::size_t count, unsigned threads, const ThreadPool::Work& work) {
  if (threads == 0) threads = processors();
  ThreadPool pool(static_cast<unsigned>(std::clamp<std::size_t>(count, 1, threads)));
  pool.for_each_index(count, work);
}

}  // namespace straightedge
