// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/hough_plane_peaks.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "plane_scene.hpp"
#include "support/catch.hpp"

using namespace straightedge;

namespace {

struct Prepared {
  explicit Prepared(const HoughAccumulatorOptions& options) {
    Arena counted = Arena::measure();
    HoughAccumulator().take(counted, options);
    memory.resize(counted.used());
    Arena arena(memory);
    accumulator.take(arena, options);
    accumulator.fill(options.cells);
  }
  std::vector<HoughPlanePeak> peaks(std::uint32_t least = 1, std::size_t room = 10'000) const {
    std::vector<HoughPlanePeak> found(room);
    std::uint32_t count = 0;
    const Status status = find_plane_peaks(accumulator, accumulator.votes(), least, found, count);
    CHECK((status == Status::ok || (status == Status::output_full && count == room)));
    found.resize(count);
    return found;
  }

  std::vector<std::byte> memory;
  HoughAccumulator accumulator;
};

}  // namespace

TEST_CASE("no votes, no peaks") {
  const Prepared p({HoughCells::ball, 12, 5});
  CHECK(p.peaks(0).empty());
  CHECK(p.peaks(1).empty());
}

TEST_CASE("one vote anywhere is one peak, at the poles, at the seam and at distance 0 too") {
  for (const HoughCells kind : {HoughCells::array, HoughCells::ball}) {
    Prepared p({kind, 12, 4});
    for (std::int32_t direction = 0; direction < p.accumulator.directions().size(); ++direction) {
      for (std::int32_t k = 0; k < 4; ++k) {
        p.accumulator.clear(1);
        p.accumulator.votes(direction, k) = 5;
        const auto peaks = p.peaks();
        REQUIRE(peaks.size() == 1);
        CHECK(peaks[0] == HoughPlanePeak{direction, k, 5});
      }
    }
  }
}

TEST_CASE("a plane through the origin is one peak, though n and -n both have votes") {
  Prepared p({HoughCells::ball, 12, 4});
  const std::int32_t n = 40, opposite = p.accumulator.directions().antipode(n);
  p.accumulator.votes(n, 0) = 9;
  p.accumulator.votes(opposite, 0) = 9;
  auto peaks = p.peaks();
  REQUIRE(peaks.size() == 1);
  CHECK(peaks[0].direction == std::min(n, opposite));
  p.accumulator.votes(opposite, 0) = 10;
  peaks = p.peaks();
  REQUIRE(peaks.size() == 1);
  CHECK(peaks[0].direction == opposite);
  // One cell farther they are two planes, on two sides of the origin.
  p.accumulator.clear(1);
  p.accumulator.votes(n, 1) = 9;
  p.accumulator.votes(opposite, 1) = 9;
  CHECK(p.peaks().size() == 2);
}

TEST_CASE("of equal neighbours the first is the peak; a plateau has one") {
  Prepared p({HoughCells::ball, 12, 4});
  std::int32_t second = 0;
  p.accumulator.directions().for_neighbours(50,
                                            [&](std::int32_t other) { second = std::max(second, other); });
  p.accumulator.votes(50, 2) = 3;
  p.accumulator.votes(second, 3) = 3;
  REQUIRE(p.peaks().size() == 1);
  CHECK(p.peaks()[0] == HoughPlanePeak{50, 2, 3});
}

TEST_CASE("peaks agree with every cell compared to every other") {
  const std::uint64_t seed = 31;
  Pcg32 random(seed);
  for (const HoughCells kind : {HoughCells::array, HoughCells::ball}) {
    Prepared p({kind, 9, 5});
    HoughAccumulator& a = p.accumulator;
    for (int turn = 0; turn < 10; ++turn) {
      a.clear(1);
      for (std::int32_t n = 0; n < a.directions().size(); ++n) {
        for (std::int32_t k = 0; k < 5; ++k) a.votes(n, k) = random.below(turn % 2 == 0 ? 4 : 1000);
      }
      std::vector<HoughPlanePeak> expected;
      for (std::int32_t n = 0; n < a.directions().size(); ++n) {
        for (std::int32_t k = 0; k < 5; ++k) {
          bool highest = a.votes(n, k) >= 2;
          a.directions().for_neighbours(n, [&](std::int32_t m) {
            for (std::int32_t j = 0; j < 5; ++j) {
              const std::int32_t opposite = a.directions().antipode(m);
              const bool near = j >= k - 1 && j <= k + 1;
              if (near && std::pair(m, j) != std::pair(n, k)) {
                const bool before = std::pair(m, j) < std::pair(n, k);
                highest =
                    highest && (a.votes(m, j) < a.votes(n, k) || (a.votes(m, j) == a.votes(n, k) && !before));
              }
              if (k == 0 && j == 0 && opposite != n) {
                const bool before = opposite < n;
                highest = highest && (a.votes(opposite, 0) < a.votes(n, 0) ||
                                      (a.votes(opposite, 0) == a.votes(n, 0) && !before));
              }
            }
          });
          if (highest) expected.push_back({n, k, a.votes(n, k)});
        }
      }
      std::stable_sort(expected.begin(), expected.end(),
                       [](const auto& x, const auto& y) { return x.votes > y.votes; });
      INFO("seed " << seed << " turn " << turn << " kind " << static_cast<int>(kind));
      CHECK(p.peaks(2) == expected);
      REQUIRE(expected.size() > 1);
      expected.resize(expected.size() / 2);
      CHECK(p.peaks(2, expected.size()) == expected);
    }
  }
}

TEST_CASE("low-pass: an even plain stays even, a single vote spreads and stays the peak") {
  for (const HoughCells kind : {HoughCells::array, HoughCells::ball}) {
    Prepared p({kind, 12, 6});
    HoughAccumulator& a = p.accumulator;
    std::vector<std::uint32_t> smooth(a.votes().size());
    for (std::int32_t n = 0; n < a.directions().size(); ++n) {
      for (std::int32_t k = 0; k < 6; ++k) a.votes(n, k) = 100;
    }
    REQUIRE(low_pass_votes(a, smooth) == Status::ok);
    for (std::int32_t k = 0; k < 5; ++k) CHECK(smooth[static_cast<std::size_t>(30 * 6 + k)] == 800);

    a.clear(1);
    a.votes(7, 0) = 600;
    REQUIRE(low_pass_votes(a, smooth) == Status::ok);
    std::array<HoughPlanePeak, 3> peaks;
    std::uint32_t count = 0;
    REQUIRE(find_plane_peaks(a, smooth, 1, peaks, count) == Status::ok);
    REQUIRE(count == 1);
    CHECK(peaks[0] == HoughPlanePeak{7, 0, 1200});
    CHECK(smooth[static_cast<std::size_t>(a.directions().antipode(7) * 6)] == 600);
    a.votes(7, 0) = 4'000'000'000;
    REQUIRE(low_pass_votes(a, smooth) == Status::ok);
    CHECK(smooth[7 * 6] == 4'294'967'295);
  }
}

TEST_CASE("values of another size are refused") {
  const Prepared p({HoughCells::ball, 12, 6});
  std::vector<std::uint32_t> few(10);
  std::uint32_t count = 1;
  CHECK(low_pass_votes(p.accumulator, few) == Status::size_mismatch);
  CHECK(find_plane_peaks(p.accumulator, few, 1, {}, count) == Status::size_mismatch);
  CHECK(count == 0);
}
