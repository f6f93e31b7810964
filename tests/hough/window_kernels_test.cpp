// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <limits>

#include "hough/gradient_window.hpp"
#include "hough_testing.hpp"
#include "kernel_tables.hpp"
#include "plain_progressive.hpp"

using namespace straightedge;
using test::EdgeImage;

namespace {

/// Where angle_window says that the window of one pixel begins.
std::uint16_t first_of(std::int16_t dx, std::int16_t dy, const HoughOptions& options) {
  if (dx == 0 && dy == 0) return hough_no_direction;
  HoughJob job;
  job.gradients = {{&dx, {1, 1}}, {&dy, {1, 1}}};
  job.options = options;
  job.grid = hough_grid({1, 1}, options);
  return static_cast<std::uint16_t>(hough::angle_window(job, 0, 0).first);
}

/// Small ones, as axes, diagonals and their neighbours are, and large ones.
std::int16_t some_derivative(Pcg32& random) {
  constexpr std::array<std::int16_t, 8> special{0, 1, -1, 2, -255, 1020, 32767, -32768};
  if (random.below(2) == 0) return special[random.below(special.size())];
  return static_cast<std::int16_t>(static_cast<int>(random.below(65536)) - 32768);
}

/// A small accumulator, and windows in which a batch votes.
struct Votes {
  static constexpr std::int32_t angles = 37, reach = 200;
  static constexpr std::size_t cells = static_cast<std::size_t>(angles) * reach;
  std::vector<float> cosines, sines;
  std::vector<std::uint32_t> offsets;
  HoughBatch batch;
  std::vector<std::uint16_t> firsts;
  std::int32_t window;

  Votes(std::uint64_t seed, std::int32_t window_angles) : window(window_angles) {
    Pcg32 random(seed);
    for (std::int32_t n = 0; n < angles + window + static_cast<std::int32_t>(hough_rows_more); ++n) {
      const double theta = pi * (n % angles) / angles;
      cosines.push_back(static_cast<float>(std::cos(theta)));
      sines.push_back(static_cast<float>(std::sin(theta)));
      offsets.push_back(static_cast<std::uint32_t>((n % angles) * reach + reach / 2) - 0x4B400000U);
    }
    batch.count = static_cast<std::int32_t>(random.below(hough_batch_room + 1));
    for (std::int32_t i = 0; i < batch.count; ++i) {
      batch.x[i] = static_cast<float>(random.below(40));
      batch.y[i] = static_cast<float>(random.below(40));
      firsts.push_back(random.below(9) == 0 ? hough_no_direction
                                            : static_cast<std::uint16_t>(random.below(angles)));
    }
  }
  HoughRows rows() const { return {cosines.data(), sines.data(), offsets.data(), angles, window}; }

  template <class Visit>
  void for_cells(std::int32_t i, const Visit& visit) const {
    const bool all = firsts[static_cast<std::size_t>(i)] == hough_no_direction;
    const std::int32_t first = all ? 0 : firsts[static_cast<std::size_t>(i)];
    for (std::int32_t k = 0; k < (all ? angles : window); ++k) {
      const std::int32_t n = (first + k) % angles;
      const auto row = static_cast<std::size_t>(n);
      const float distance = batch.x[i] * cosines[row] + batch.y[i] * sines[row];
      visit(n, static_cast<std::size_t>(n * reach + reach / 2 + static_cast<int>(std::nearbyint(distance))));
    }
  }
};

/// Lets the batch vote from number `from` on, as the kernels should.
template <class Cell>
std::int32_t cast_plainly(const Votes& votes, std::vector<Cell>& cells, std::int32_t from,
                          std::int32_t threshold, HoughCandidate& seen) {
  for (std::int32_t i = from; i < votes.batch.count; ++i) {
    HoughCandidate most{threshold - 1, -1};
    votes.for_cells(i, [&](std::int32_t n, std::size_t cell) {
      ++cells[cell];
      if (cells[cell] > most.votes) most = {cells[cell], n};
    });
    if (most.angle < 0) continue;
    seen = most;
    return i;
  }
  return votes.batch.count;
}

template <class Cell>
void require_equal_votes(const HoughCellKernels<Cell>& kernels, std::uint64_t seed, Cell start) {
  const Votes votes(seed, 1 + static_cast<std::int32_t>(seed % 36));
  const auto threshold = start + 1 + static_cast<std::int32_t>(seed % 9);
  std::vector<Cell> cells(Votes::cells, start), expected = cells;
  INFO("seed " << seed);
  for (std::int32_t from = 0; from < votes.batch.count;) {
    HoughCandidate seen, wanted;
    const std::int32_t at = kernels.cast_in_windows(cells.data(), votes.rows(), votes.batch,
                                                    votes.firsts.data(), from, threshold, seen);
    REQUIRE(at == cast_plainly(votes, expected, from, threshold, wanted));
    REQUIRE(seen.votes == wanted.votes);
    REQUIRE(seen.angle == wanted.angle);
    REQUIRE(cells == expected);
    from = at + 1;
  }
  kernels.take_off_in_windows(cells.data(), votes.rows(), votes.batch, votes.firsts.data());
  REQUIRE(cells == std::vector<Cell>(Votes::cells, start));
}

/// Boxes one within the other, each side's gradient across it, give or take a little.
struct Boxes {
  EdgeImage edges;
  test::ConstantGradient gradient;

  Boxes(Size size, std::uint64_t seed) : edges(test::noise(size, 0.02, seed)), gradient(size, 0.8) {
    for (int d = 3; 2 * d < std::min(size.width, size.height) - 5; d += 4) {
      const int right = size.width - 1 - d, bottom = size.height - 1 - d;
      for (int x = d; x <= right; ++x) edge(x, d, 0, 400), edge(x, bottom, 0, -400);
      for (int y = d; y <= bottom; ++y) edge(d, y, 400, 0), edge(right, y, -400, 0);
    }
    Pcg32 random(seed);
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x)
        gradient.dx.at(x, y) =
            static_cast<std::int16_t>(gradient.dx.at(x, y) + static_cast<int>(random.below(60)) - 30);
  }
  void edge(int x, int y, int dx, int dy) {
    edges.at(x, y) = 255;
    gradient.dx.at(x, y) = static_cast<std::int16_t>(dx);
    gradient.dy.at(x, y) = static_cast<std::int16_t>(dy);
  }
};

}  // namespace

TEST_CASE("every table of kernels finds where windows begin") {
  for (const double theta_step : {degree, 0.02, 0.013, 0.5, 1.4, 1e-4}) {
    for (const double window : {1e-3, 0.1, 0.5 * theta_step, 0.7, 1.5}) {
      Pcg32 random(7);
      const HoughOptions options{.theta_step = theta_step, .gradient_window = window};
      const HoughGrid grid = hough_grid({1, 1}, options);
      if (hough_window_angles(grid, options) >= grid.half_turn) continue;
      const HoughWindowRule rule{window, static_cast<double>(grid.theta_step), grid.half_turn};
      for (std::int32_t count = 0; count <= 130; ++count) {
        const std::size_t room = static_cast<std::size_t>(count + 15) / 16 * 16;
        std::vector<std::int16_t> dx(room), dy(room);
        std::vector<std::uint16_t> wanted;
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
          dx[i] = some_derivative(random);
          dy[i] = some_derivative(random);
          wanted.push_back(first_of(dx[i], dy[i], options));
        }
        for (const HoughKernels* kernels : test::kernel_tables()) {
          std::vector<std::uint16_t> first(room);
          kernels->first_angles(dx.data(), dy.data(), count, rule, first.data());
          first.resize(static_cast<std::size_t>(count));
          INFO("step " << theta_step << " window " << window << " count " << count);
          REQUIRE(first == wanted);
        }
      }
    }
  }
}

TEST_CASE("every table of kernels casts votes in windows, and takes them off") {
  for (const HoughKernels* kernels : test::kernel_tables()) {
    for (std::uint64_t seed = 1; seed <= 150; ++seed) {
      require_equal_votes<std::uint8_t>(kernels->bytes, seed, 0);
      require_equal_votes<std::int16_t>(kernels->words, seed,
                                        static_cast<std::int16_t>(seed % 2 == 0 ? 400 : -3));
    }
  }
}

TEST_CASE("windows found together give the segments of one after the other") {
  std::size_t found = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    const Boxes boxes({60 + static_cast<int>(seed), 90}, seed);
    constexpr std::int32_t thresholds[] = {1, 6, 12, std::numeric_limits<std::int32_t>::max()};
    for (const std::int32_t threshold : thresholds) {
      HoughOptions options{.threshold = threshold, .min_length = 6, .max_gap = 2, .seed = seed};
      options.generator = seed % 2 == 0 ? HoughGenerator::opencv : HoughGenerator::pcg32;
      options.gradient_window = seed % 3 == 0 ? 0.1 : 0.4;
      const test::PlainProgressive plain(boxes.edges, options, boxes.gradient.view());
      found += plain.segments.size();
      for (const HoughKernels* kernels : test::kernel_tables()) {
        options.kernels = kernels;
        const HoughFound together = hough_lines(boxes.edges, options, boxes.gradient.view());
        INFO("seed " << seed << " threshold " << threshold);
        REQUIRE(together.segments == plain.segments);
      }
    }
  }
  CHECK(found > 2000);
}
