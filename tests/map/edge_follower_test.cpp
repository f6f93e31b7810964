// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/edge_follower.hpp"

#include <cmath>
#include <vector>

#include "straightedge/host/kernels.hpp"
#include "straightedge/random.hpp"
#include "support/catch.hpp"
#include "support/drawing.hpp"
#include "support/edge_scene.hpp"

using namespace straightedge;

namespace {

constexpr Size size{200, 160};

EdgeBits bits_of(GrayView mask) {
  EdgeBits bits;
  bits.reset(mask.size());
  for (int y = 0; y < mask.height; ++y)
    for (int x = 0; x < mask.width; ++x)
      if (mask.at(x, y) != 0) bits.set(x, y);
  return bits;
}

int count(const EdgeBits& bits) {
  int set = 0;
  for (int y = 0; y < bits.size().height; ++y)
    for (int x = 0; x < bits.size().width; ++x) set += bits.contains(x, y) ? 1 : 0;
  return set;
}

std::vector<WallLine> follow(const support::EdgeScene& scene, EdgeBits& bits,
                             const FollowOptions& options = {}) {
  return EdgeFollower().run(bits, scene.field(), options, *best_kernels().picture_rows);
}

}  // namespace

TEST_CASE("both faces of a bar at any angle are followed from end to end, once") {
  for (int degrees = 0; degrees < 180; degrees += 7) {
    const double angle = degrees * 3.141592653589793 / 180, dx = std::cos(angle), dy = std::sin(angle);
    support::Canvas canvas(size, 254);
    canvas.paint_bar({100.3 - 60 * dx, 80.1 - 60 * dy}, {100.3 + 60 * dx, 80.1 + 60 * dy}, 8);
    const support::EdgeScene scene(canvas.picture());
    EdgeBits bits = bits_of(scene.mask);
    int faces = 0;
    INFO(degrees << " degrees");
    for (const WallLine& line : follow(scene, bits)) {
      if (line.length() < 20) continue;  // the bar's ends
      ++faces;
      CHECK(line.length() == Approx(120).margin(8));
      CHECK(std::fabs(line.nx * dx + line.ny * dy) < 2e-3);
      // The bar's middle lies half its width from the face, on the dark side.
      CHECK(line.across(100.3 - 0.5, 80.1 - 0.5) == Approx(-4).margin(0.1));
    }
    CHECK(faces == 2);
  }
}

TEST_CASE("long faces that climb by two in one, or one in two, are not missed") {
  for (const double slope : {2.0, 0.5, -0.5, -2.0}) {
    for (int x = 0; x < 5; ++x) {
      const double size = std::sqrt(1 + slope * slope), dx = 1 / size, dy = slope / size;
      support::Canvas canvas(Size{200, 160}, 254);
      canvas.paint_bar({98.0 + x - 50 * dx, 80 - 50 * dy}, {98.0 + x + 50 * dx, 80 + 50 * dy}, 7);
      const support::EdgeScene scene(canvas.picture());
      EdgeBits bits = bits_of(scene.mask);
      int faces = 0;
      for (const WallLine& line : follow(scene, bits)) faces += line.length() > 85 ? 1 : 0;
      INFO("slope " << slope << ", at " << x);
      CHECK(faces == 2);
    }
  }
}

TEST_CASE("a bent wall becomes a line on each side of the bend") {
  support::Canvas canvas(size, 254);
  canvas.paint_bar({10, 60}, {110, 60}, 8);
  canvas.paint_bar({110, 60}, {190, 64}, 8);  // nearly three degrees
  const support::EdgeScene scene(canvas.picture());
  EdgeBits bits = bits_of(scene.mask);
  int flat = 0, slanted = 0;
  for (const WallLine& line : follow(scene, bits)) {
    if (line.length() < 40) continue;
    const double slope = -line.nx / line.ny;
    flat += std::fabs(slope) < 0.01 ? 1 : 0;
    slanted += std::fabs(slope - 0.05) < 0.01 ? 1 : 0;
  }
  CHECK(flat == 2);
  CHECK(slanted == 2);
}

TEST_CASE("edges lie where the field of positions says") {
  for (const double move : {-0.4, 0.0, 0.3}) {
    support::Canvas canvas(size, 254), moved(size, 254);
    canvas.paint_box(60, 40, 140, 120);
    moved.paint_box(60 + move, 40, 140 + move, 120);
    const support::EdgeScene scene(canvas.picture()), positions(moved.picture());
    const GradientField without_magnitude{positions.field().x, positions.field().y, {}};
    int upright = 0;
    for (const GradientField& of_positions : {positions.field(), without_magnitude}) {
      EdgeBits bits = bits_of(scene.mask);
      for (const WallLine& line :
           EdgeFollower().run(bits, {scene.field(), of_positions}, {}, *best_kernels().picture_rows)) {
        if (std::fabs(line.ny) > 0.1 || line.length() < 40) continue;
        ++upright;
        const double left = 59.5 + move, right = 139.5 + move;  // between the pixels
        CHECK(line.fit.centroid_x == Approx(line.nx < 0 ? left : right).margin(0.08));
      }
    }
    CHECK(upright == 4);
  }
}

TEST_CASE("pixels that edges took are gone, all others stay") {
  support::Canvas canvas(size, 254);
  canvas.paint_box(30, 30, 130, 110);
  canvas.paint_bar({20, 150}, {180, 120}, 6);
  const support::EdgeScene scene(canvas.picture());
  const EdgeBits before = bits_of(scene.mask);
  EdgeBits after = before;
  const auto lines = follow(scene, after);
  CHECK(lines.size() >= 6);
  std::uint32_t carried = 0;
  for (const WallLine& line : lines) carried += line.pixels;
  int taken = 0;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      CHECK((before.contains(x, y) || !after.contains(x, y)));
      if (!before.contains(x, y) || after.contains(x, y)) continue;
      ++taken;
      bool near_line = false;
      for (const WallLine& line : lines) near_line = near_line || std::fabs(line.across(x, y)) < 3;
      CHECK(near_line);
    }
  }
  CHECK(static_cast<int>(carried) <= taken);
  CHECK(taken > 0.9 * count(before));
}

TEST_CASE("a hole is bridged up to max_gap, and a longer one ends the edge") {
  support::Canvas canvas(size, 254);
  canvas.paint_box(20, 60, 180, 100);
  const support::EdgeScene scene(canvas.picture());
  for (const int hole : {6, 12}) {
    EdgeBits bits = bits_of(scene.mask);
    for (int x = 100; x < 100 + hole; ++x)
      for (int y = 50; y < 70; ++y) bits.clear(x, y);
    int pieces = 0;
    for (const WallLine& line : follow(scene, bits, {.max_gap = 8}))
      pieces += line.ny < -0.9 && line.length() > 30 ? 1 : 0;
    INFO("hole of " << hole);
    CHECK(pieces == (hole <= 8 ? 1 : 2));
  }
}

TEST_CASE("what is shorter than asked for is no edge, and keeps its pixels") {
  support::Canvas canvas(size, 254);
  canvas.paint_box(90, 70, 112, 88);
  const support::EdgeScene scene(canvas.picture());
  EdgeBits bits = bits_of(scene.mask);
  const int before = count(bits);
  CHECK(follow(scene, bits, {.min_length = 40}).empty());
  CHECK(count(bits) == before);
  CHECK(follow(scene, bits, {.min_length = 9}).size() == 4);
  CHECK(count(bits) < before / 2);
}

TEST_CASE("lone pixels with gradients of chance make no edge") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Pcg32 random(seed);
    Image<std::int16_t> dx(size), dy(size);
    EdgeBits bits;
    bits.reset(size);
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        dx.at(x, y) = static_cast<std::int16_t>(static_cast<int>(random.below(801)) - 400);
        dy.at(x, y) = static_cast<std::int16_t>(static_cast<int>(random.below(801)) - 400);
        if (random.below(8) == 0) bits.set(x, y);
      }
    }
    INFO("seed " << seed);
    CHECK(EdgeFollower().run(bits, GradientField{dx, dy, {}}, {}, *best_kernels().picture_rows).size() <= 1);
  }
}

TEST_CASE("every set of kernels follows to the same bits, and so does a follower that is used again") {
  EdgeFollower again;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Pcg32 random(seed);
    support::Canvas canvas(size, 240);
    for (int i = 0; i < 6; ++i) {
      const auto at = [&](double most) { return support::uniform(random, 0, most); };
      canvas.paint_bar({at(200), at(160)}, {at(200), at(160)}, 1 + at(9));
    }
    const support::EdgeScene scene(canvas.picture());
    EdgeBits plain = bits_of(scene.mask);
    const auto expected = EdgeFollower().run(plain, scene.field(), {}, plain_picture_row_kernels);
    for (const KernelSet& kernels : kernel_sets()) {
      EdgeBits bits = bits_of(scene.mask);
      const auto lines = again.run(bits, scene.field(), {}, *kernels.picture_rows);
      INFO("seed " << seed << ", " << kernels.name);
      REQUIRE(lines.size() == expected.size());
      for (std::size_t i = 0; i < lines.size(); ++i) {
        CHECK(lines[i].fit.theta == expected[i].fit.theta);
        CHECK(lines[i].fit.centroid_x == expected[i].fit.centroid_x);
        CHECK(lines[i].begin == expected[i].begin);
        CHECK(lines[i].end == expected[i].end);
      }
    }
  }
}

TEST_CASE("pictures of a few pixels have no edges, and do no harm") {
  for (int width = 1; width <= 9; ++width) {
    for (int height = 1; height <= 9; ++height) {
      Image<std::int16_t> dx({width, height}), dy({width, height});
      EdgeBits bits;
      bits.reset({width, height});
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
          dx.at(x, y) = 300;
          bits.set(x, y);
        }
      }
      CHECK(EdgeFollower().run(bits, GradientField{dx, dy, {}}, {}, *best_kernels().picture_rows).empty());
    }
  }
}

TEST_CASE("parts of rows and columns have the edge pixels that lie there") {
  EdgeBits bits;
  const Size narrow{131, 70};
  bits.reset(narrow);
  Pcg32 random(3);
  for (int i = 0; i < 3000; ++i) {
    const auto x = static_cast<std::int32_t>(random.below(131)),
               y = static_cast<std::int32_t>(random.below(70));
    i % 4 == 0 ? bits.clear(x, y) : bits.set(x, y);
  }
  for (const bool steep : {true, false}) {
    const BitLinesView lines = bits.lines(steep);
    for (std::int32_t from = -62; from < bits.places(steep); ++from) {
      for (const std::int32_t count : {1, 7, 63}) {
        const std::int32_t k = from & 31;
        std::uint64_t expected = 0;
        for (std::int32_t i = 0; i < count; ++i) {
          const std::int32_t place = from + i;
          if (place < 0 || place >= bits.places(steep)) continue;
          const bool is_edge = steep ? bits.contains(place, k) : bits.contains(k, place);
          expected |= std::uint64_t{is_edge ? 1U : 0U} << i;
        }
        REQUIRE(EdgeBits::part(lines.line(k), from, count) == expected);
      }
    }
  }
}
