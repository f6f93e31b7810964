// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "../support/golden_hough.hpp"
#include "kernel_tables.hpp"
#include "plain_progressive.hpp"

using namespace straightedge;
using test::EdgeImage;

namespace {

struct CompactRun {
  std::vector<std::byte> memory;
  HoughLines lines;
  HoughResult result;
  std::vector<HoughSegment> segments;

  CompactRun(GrayView edges, const HoughOptions& options, GradientView gradients = {})
      : memory(HoughLines::workspace_bytes(edges.size(), options)), segments(100'000) {
    REQUIRE(HoughLines::prepare(lines, edges.size(), options, memory) == Status::ok);
    result = lines.run(edges, gradients, {}, segments);
    segments.resize(result.segments);
  }
};

/// Segments in order, pixels that are left and every cell.
void require_equal(const CompactRun& compact, const test::PlainProgressive& plain) {
  REQUIRE(compact.result.status == Status::ok);
  REQUIRE(compact.result.edge_pixels == plain.edge_pixels);
  REQUIRE(compact.segments == plain.segments);
  const HoughVotesView votes = compact.lines.accumulator();
  bool same = static_cast<std::size_t>(votes.height) == plain.cells.size();
  for (std::int32_t n = 0; n < votes.height; ++n)
    for (std::int32_t r = 0; r < votes.width; ++r)
      same = same && votes.at(r, n) == plain.cells[static_cast<std::size_t>(n)][static_cast<std::size_t>(r)];
  REQUIRE(same);
  for (std::size_t y = 0; y < plain.state.size(); ++y)
    for (std::size_t x = 0; x < plain.state[y].size(); ++x)
      same = same && compact.lines.remaining().at(static_cast<std::int32_t>(x),
                                                  static_cast<std::int32_t>(y)) == (plain.state[y][x] != 0);
  REQUIRE(same);
}

/// One pixel after the other, and many together with each table that this machine can run.
std::vector<const HoughKernels*> kernels_here() {
  std::vector<const HoughKernels*> tables = test::kernel_tables();
  tables.insert(tables.begin(), nullptr);
  return tables;
}

/// With room for every pixel and with room for just as many as there are.
void require_equal(GrayView edges, HoughOptions options, GradientView gradients = {}) {
  const test::PlainProgressive plain(edges, options, gradients);
  const std::uint32_t asked = options.max_edge_pixels;
  for (const HoughKernels* kernels : kernels_here()) {
    options.kernels = kernels;
    options.max_edge_pixels = asked;
    require_equal(CompactRun(edges, options, gradients), plain);
    options.max_edge_pixels = plain.edge_pixels;
    require_equal(CompactRun(edges, options, gradients), plain);
  }
}

HoughOptions short_lines(HoughGenerator generator) {
  return {.threshold = 8, .min_length = 8, .max_gap = 3, .generator = generator};
}

}  // namespace

TEST_CASE("room for 8000 edge pixels at 320x240 takes less than 130 KB") {
  constexpr HoughOptions options{.theta_step = 2 * degree, .max_edge_pixels = 8000};
  constexpr HoughOptions as_opencv{
      .theta_step = 2 * degree, .max_edge_pixels = 8000, .generator = HoughGenerator::opencv};
  static_assert(HoughLines::workspace_bytes({320, 240}, options) <= 90'000);
  static_assert(HoughLines::workspace_bytes({320, 240}, as_opencv) <= 130'000);
  static_assert(HoughLines::workspace_bytes({160, 120}, options) <= 60'000);
  CHECK(HoughLines::workspace_bytes({320, 240}, options) > 8000 * sizeof(PixelPlace));
}

TEST_CASE("the figures of the page") {
  const auto kilobytes = [](Size size, std::uint32_t room, HoughGenerator generator) {
    const HoughOptions options{.theta_step = 2 * degree, .max_edge_pixels = room, .generator = generator};
    return (HoughLines::workspace_bytes(size, options) + 500) / 1000;
  };
  const Size sizes[] = {{160, 120}, {320, 240}, {640, 480}};
  const std::size_t own[] = {55, 86, 177}, as_opencv[] = {72, 119, 243}, any[] = {100, 361, 1373};
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(kilobytes(sizes[i], 8000, HoughGenerator::pcg32) == own[i]);
    CHECK(kilobytes(sizes[i], 8000, HoughGenerator::opencv) == as_opencv[i]);
    CHECK(kilobytes(sizes[i], 0, HoughGenerator::pcg32) == any[i]);
  }
}

TEST_CASE("few bytes give the segments, votes and pixels of many") {
  const double rho_steps[] = {1, 0.3, 2.5, 11};
  const double theta_steps[] = {degree, 2 * degree, 0.013, 0.5};
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Pcg32 random(seed, 3);
    const Size size{1 + static_cast<int>(random.below(90)), 1 + static_cast<int>(random.below(90))};
    EdgeImage image = test::noise(size, 0.02 * random.below(20), seed);
    for (int i = 0; i < 3; ++i)
      test::draw(image, static_cast<int>(random.below(90)), static_cast<int>(random.below(90)),
                 static_cast<int>(random.below(90)), static_cast<int>(random.below(90)));
    HoughOptions options = short_lines(seed % 2 == 0 ? HoughGenerator::opencv : HoughGenerator::pcg32);
    options.rho_step = rho_steps[random.below(4)];
    options.theta_step = theta_steps[random.below(4)];
    options.threshold = 1 + static_cast<int>(random.below(20));
    options.max_gap = random.below(60) / 10.0;
    options.seed = seed;
    INFO("seed " << seed << ": " << size.width << "x" << size.height);
    require_equal(image, options);
  }
}

TEST_CASE("the same on the golden pictures") {
  const auto golden = test::read_golden_hough(STRAIGHTEDGE_FIXTURES "/golden/hough/hough.golden");
  REQUIRE(golden.good);
  std::size_t segments = 0;
  for (std::size_t i = 0; i < golden.images.size(); i += 2) {
    INFO(golden.images[i].name);
    HoughOptions options = short_lines(i % 4 == 0 ? HoughGenerator::opencv : HoughGenerator::pcg32);
    options.threshold = 15;
    require_equal(golden.images[i].edges, options);
    segments += hough_lines(golden.images[i].edges, options).segments.size();
  }
  CHECK(segments > 500);
}

TEST_CASE("the same with a gradient window") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    INFO("seed " << seed);
    const EdgeImage image = test::noise({70, 61}, 0.3, seed);
    const test::ConstantGradient gradient(image.size(), 0.55 * static_cast<double>(seed));
    HoughOptions options = short_lines(seed % 2 == 0 ? HoughGenerator::opencv : HoughGenerator::pcg32);
    options.gradient_window = 0.3;
    options.theta_step = 0.02;
    require_equal(image, options, gradient.view());
  }
}

TEST_CASE("the same with gradients of all directions and windows of all widths") {
  const double theta_steps[] = {degree, 0.02, 0.013, 0.5, 2.0};
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    INFO("seed " << seed);
    Pcg32 random(seed, 9);
    const Size size{1 + static_cast<int>(random.below(300)), 1 + static_cast<int>(random.below(20))};
    const EdgeImage image = test::noise(size, 0.3, seed);
    test::ConstantGradient gradient(size, 0);
    for (std::int32_t y = 0; y < size.height; ++y) {
      for (std::int32_t x = 0; x < size.width; ++x) {
        const std::uint32_t most = random.below(3) == 0 ? 3 : random.below(5) == 0 ? 65535 : 2000;
        gradient.dx.at(x, y) = static_cast<std::int16_t>(random.below(most) - most / 2);
        gradient.dy.at(x, y) = static_cast<std::int16_t>(random.below(most) - most / 2);
      }
    }
    HoughOptions options = short_lines(seed % 2 == 0 ? HoughGenerator::opencv : HoughGenerator::pcg32);
    options.gradient_window = pi * random.below(1000) / (seed % 3 == 0 ? 999 : 5000) + 1e-3;
    options.gradient_window = std::min(options.gradient_window, pi);
    options.theta_step = theta_steps[random.below(5)];
    require_equal(image, options, gradient.view());
  }
}

TEST_CASE("cells of one, two and four bytes hold what comes together") {
  struct Case {
    Size size;
    std::int32_t threshold;
    double rho_step;
    HoughGenerator generator;
    std::size_t bytes;
  };
  for (const Case& c :
       {Case{{400, 3}, 255, 1, HoughGenerator::pcg32, 1}, Case{{400, 3}, 256, 1, HoughGenerator::pcg32, 2},
        Case{{40, 20}, 30'000, 100, HoughGenerator::pcg32, 2},
        Case{{300, 200}, 59'000, 1000, HoughGenerator::pcg32, 4},
        Case{{40, 20}, 5, 1, HoughGenerator::opencv, 2},
        Case{{300, 200}, 59'000, 1000, HoughGenerator::opencv, 4}}) {
    HoughOptions options = short_lines(c.generator);
    options.threshold = c.threshold;
    options.rho_step = c.rho_step;
    options.theta_step = 0.1;
    INFO(c.size.width << "x" << c.size.height << " threshold " << c.threshold);
    REQUIRE(hough_cell_bytes(c.size, options) == c.bytes);
    require_equal(EdgeImage(c.size, 255), options);
  }
}

TEST_CASE("a cell never has more votes than its bytes were chosen for") {
  for (const Size size : {Size{50, 40}, Size{1, 90}, Size{90, 1}, Size{33, 80}}) {
    for (const double rho_step : {0.1, 0.7, 1.0, 1.41, 2.0, 3.3, 50.0}) {
      // No cell is emptied, so that each ends with all of its strip.
      HoughOptions options{.rho_step = rho_step, .theta_step = 0.05, .threshold = 1'000'000};
      options.generator = HoughGenerator::opencv;
      const CompactRun full(EdgeImage(size, 1), options);
      const HoughVotesView votes = full.lines.accumulator();
      std::int64_t most = 0;
      for (std::int32_t n = 0; n < votes.height; ++n)
        for (std::int32_t r = 0; r < votes.width; ++r) most = std::max<std::int64_t>(most, votes.at(r, n));
      INFO(size.width << "x" << size.height << " rho_step " << rho_step);
      CHECK(most <= hough_most_votes(size, options));
      if (size.width == 50 && rho_step >= 0.7) CHECK(3 * most >= hough_most_votes(size, options));
    }
  }
}

TEST_CASE("pixels that vote ahead are nowhere to be seen when the output is full") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    EdgeImage image = test::noise({80, 70}, 0.02 * static_cast<double>(1 + seed % 20), seed);
    for (int i = 0; i < 9; ++i) test::draw(image, 2, 5 + 7 * i, 75, 60 - 6 * i);
    HoughOptions options = short_lines(seed % 2 == 0 ? HoughGenerator::opencv : HoughGenerator::pcg32);
    options.seed = seed;
    INFO("seed " << seed);
    const test::ConstantGradient gradient(image.size(), 0.1 * static_cast<double>(seed));
    options.gradient_window = seed % 3 == 0 ? 0.7 : 0;
    std::vector<HoughSegment> segments(static_cast<std::size_t>(seed % 7));
    std::vector<std::byte> memory(HoughLines::workspace_bytes(image.size(), options));
    HoughLines one_by_one;
    REQUIRE(HoughLines::prepare(one_by_one, image.size(), options, memory) == Status::ok);
    const HoughResult expected = one_by_one.run(image, gradient.view(), {}, segments);
    REQUIRE(expected.status == Status::output_full);
    for (const HoughKernels* kernels : kernels_here()) {
      options.kernels = kernels;
      std::vector<HoughSegment> found(segments.size());
      std::vector<std::byte> more(HoughLines::workspace_bytes(image.size(), options));
      HoughLines ahead;
      REQUIRE(HoughLines::prepare(ahead, image.size(), options, more) == Status::ok);
      const HoughResult result = ahead.run(image, gradient.view(), {}, found);
      CHECK(result.status == Status::output_full);
      CHECK(result.draws == expected.draws);
      CHECK(found == segments);
      bool same = true;
      for (std::int32_t n = 0; n < one_by_one.grid().angles; ++n)
        for (std::int32_t r = 0; r < one_by_one.grid().distances; ++r)
          same = same && ahead.accumulator().at(r, n) == one_by_one.accumulator().at(r, n);
      CHECK(same);
    }
  }
}
