// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "hough_testing.hpp"
#include "straightedge/hough_standard.hpp"

using namespace straightedge;
using test::EdgeImage;

namespace {

struct Counts {
  std::uint64_t votes = 0, lines = 0, removals = 0;
  std::uint64_t stop_after = ~std::uint64_t{0};

  static bool count(void* user, const HoughEvent& event) {
    Counts& counts = *static_cast<Counts*>(user);
    if (event.step == HoughStep::vote) ++counts.votes;
    if (event.step == HoughStep::line) ++counts.lines;
    if (event.step == HoughStep::removal) ++counts.removals;
    return counts.votes + counts.lines + counts.removals < counts.stop_after;
  }
};

struct Run {
  HoughOptions options;
  std::vector<std::byte> memory;
  HoughLines lines;
  std::vector<HoughPeak> peaks = std::vector<HoughPeak>(1000);
  std::vector<HoughSegment> segments = std::vector<HoughSegment>(1000);

  Run(Size size, const HoughOptions& chosen)
      : options(chosen), memory(HoughLines::workspace_bytes(size, chosen)) {
    REQUIRE(HoughLines::prepare(lines, size, options, memory) == Status::ok);
  }
  HoughResult operator()(const EdgeImage& image, Counts& counts) {
    return lines.run(image, peaks, segments, {Counts::count, &counts});
  }
};

EdgeImage two_lines() {
  EdgeImage image({120, 90});
  test::draw(image, 10, 40, 110, 40);
  test::draw(image, 20, 80, 100, 60);
  return image;
}

}  // namespace

TEST_CASE("the trace sees every vote, line and removal") {
  const EdgeImage image = two_lines();
  for (const auto method : {HoughMethod::standard, HoughMethod::progressive, HoughMethod::randomized}) {
    HoughOptions options;
    options.method = method;
    Run run(image.size(), options);
    Counts counts;
    const HoughResult result = run(image, counts);
    INFO(static_cast<int>(method));
    CHECK(result.status == Status::ok);
    CHECK(counts.lines == (method == HoughMethod::progressive ? result.segments : result.peaks));
    std::uint64_t pixels = 0;
    for (std::uint32_t i = 0; i < result.segments; ++i)
      pixels += static_cast<std::uint64_t>(run.segments[i].pixels);
    CHECK(counts.removals >= pixels);
    CHECK(counts.votes > 0);
    std::uint64_t left = 0;
    for (int y = 0; y < 90; ++y)
      for (int x = 0; x < 120; ++x) left += run.lines.remaining().at(x, y) ? 1 : 0;
    CHECK(left + counts.removals == result.edge_pixels);
  }
}

TEST_CASE("a trace can stop a run at any event; what was found stays") {
  const EdgeImage image = two_lines();
  for (const auto method : {HoughMethod::standard, HoughMethod::progressive, HoughMethod::randomized}) {
    HoughOptions options;
    options.method = method;
    Run run(image.size(), options);
    Counts all;
    static_cast<void>(run(image, all));
    const std::uint64_t events = all.votes + all.lines + all.removals;
    for (std::uint64_t stop = 1; stop < events; stop += 1 + events / 50) {
      Counts counts;
      counts.stop_after = stop;
      const HoughResult result = run(image, counts);
      REQUIRE(result.status == Status::cancelled);
      REQUIRE(counts.votes + counts.lines + counts.removals == stop);
    }
  }
}

TEST_CASE("the accumulator shows the votes of the standard method about the first pixel") {
  EdgeImage image({50, 40});
  image.at(30, 10) = 1;
  HoughOptions options;
  options.method = HoughMethod::standard;
  Run run(image.size(), options);
  Counts counts;
  static_cast<void>(run(image, counts));
  const auto cells = run.lines.accumulator();
  REQUIRE(cells.height == 180);
  REQUIRE(cells.width == 181);
  for (int n = 0; n < 180; ++n) {
    const double theta = n * pi / 180;
    const double rho = 30 * std::cos(theta) + 10 * std::sin(theta);
    for (int r = 0; r < 181; ++r) {
      if (cells.at(r, n) != 0) REQUIRE(std::fabs(r - 90 - rho) < 0.501);
    }
  }
}

TEST_CASE("the accumulator shows the votes of the randomized method about the centre") {
  EdgeImage image({101, 81});
  test::draw(image, 20, 40, 80, 40);  // through the centre (50, 40)
  HoughOptions options;
  options.method = HoughMethod::randomized;
  options.pair_threshold = 1'000'000;
  options.max_draws = 5000;
  Run run(image.size(), options);
  Counts counts;
  const HoughResult result = run(image, counts);
  CHECK(result.peaks == 0);
  CHECK(result.draws == 5000);
  CHECK_FALSE(result.confident);
  const auto cells = run.lines.accumulator();
  std::uint64_t sum = 0;
  for (int n = 0; n < cells.height; ++n)
    for (int r = 0; r < cells.width; ++r) sum += static_cast<std::uint64_t>(cells.at(r, n));
  CHECK(sum == counts.votes);
  CHECK(static_cast<std::uint64_t>(cells.at((cells.width - 1) / 2, 90)) == sum);
}

TEST_CASE("the stages of the standard method can be called alone") {
  const EdgeImage image = two_lines();
  HoughOptions options;
  options.method = HoughMethod::standard;
  const HoughGrid grid = hough_grid(image.size(), options);
  std::vector<std::byte> bytes(HoughLines::workspace_bytes(image.size(), options));
  Arena arena(bytes);
  std::vector<HoughPeak> peaks(100);
  HoughJob job;
  job.edges = image;
  job.options = options;
  job.grid = grid;
  job.memory = HoughMemory::take(arena, image.size(), options, grid);
  job.peaks = peaks;
  REQUIRE(vote_standard(job));
  CHECK(job.result.edge_pixels == 182);
  REQUIRE(find_standard_peaks(job));
  CHECK(job.result.peaks >= 2);
  CHECK(peaks[0].votes == 101);
}

TEST_CASE("pairs at theta 0 and at theta pi vote in one cell") {
  EdgeImage image({101, 81});
  test::draw(image, 20, 5, 20, 75);  // 30 left of the centre
  HoughOptions options;
  options.method = HoughMethod::randomized;
  options.pair_threshold = 1'000'000;
  options.max_draws = 1000;
  Run run(image.size(), options);
  Counts counts;
  static_cast<void>(run(image, counts));
  const auto cells = run.lines.accumulator();
  CHECK(counts.votes > 100);
  CHECK(static_cast<std::uint64_t>(cells.at((cells.width - 1) / 2 - 30, 0)) == counts.votes);
}

TEST_CASE("pairs whose gradients do not fit their line do not vote") {
  EdgeImage image({101, 81});
  test::draw(image, 20, 5, 20, 75);
  HoughOptions options;
  options.method = HoughMethod::randomized;
  options.gradient_window = 0.3;
  options.max_draws = 1000;
  Run run(image.size(), options);
  for (const double direction : {0.0, 1.0}) {
    const test::ConstantGradient gradient(image.size(), direction);
    Counts counts;
    const HoughResult result =
        run.lines.run(image, gradient.view(), run.peaks, run.segments, {Counts::count, &counts});
    CHECK(result.status == Status::ok);
    CHECK((counts.votes > 0) == (direction == 0.0));
  }
}
