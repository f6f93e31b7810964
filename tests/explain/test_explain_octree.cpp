// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <vector>

#include "cli/explain_chart.hpp"
#include "cli/explain_colours.hpp"
#include "cli/explain_octree.hpp"
#include "straightedge/random.hpp"
#include "support/catch.hpp"

using namespace straightedge;

namespace {

constexpr Size frame_size{120, 90};
constexpr PinholeCamera camera{100, 100, 59.5, 44.5};

/// Readings at 1 to 4 m anywhere, a tenth of them lost.
Image<std::uint16_t> scattered() {
  Image<std::uint16_t> depth(frame_size);
  Pcg32 random(3, 9);
  for (std::int32_t y = 0; y < frame_size.height; ++y) {
    for (std::int32_t x = 0; x < frame_size.width; ++x) {
      const std::uint32_t chance = random.next();
      if (chance % 10 != 0) depth.at(x, y) = static_cast<std::uint16_t>(1000 + chance / 16 % 3000);
    }
  }
  return depth;
}

std::vector<Vector3> points_of(const DepthView& depth) {
  std::vector<Vector3> points;
  for (std::int32_t y = 0; y < depth.raw.height; ++y) {
    for (std::int32_t x = 0; x < depth.raw.width; ++x) {
      if (depth.raw.at(x, y) == 0) continue;
      points.push_back(depth.raw.at(x, y) * depth.metres_per_unit * depth.camera.ray(x, y));
    }
  }
  return points;
}

std::uint32_t pixels_unlike(const Image<Rgb>& picture, Rgb colour) {
  std::uint32_t count = 0;
  for (std::int32_t y = cli::Chart::top; y < picture.height() - cli::Chart::bottom; ++y) {
    for (std::int32_t x = cli::Chart::left + 1; x < picture.width() - cli::Chart::right; ++x)
      count += picture.at(x, y) == colour ? 0U : 1U;
  }
  return count;
}

}  // namespace

TEST_CASE("the octree that explain draws holds every reading") {
  const Image<std::uint16_t> depth = scattered();
  const DepthView view{depth, 0.001, camera};
  const auto points = points_of(view);
  const cli::OctreeStage stage = cli::build_octree(view);
  REQUIRE(stage.points == points.size());
  for (const int level : {0, 2, 4}) {
    INFO("level " << level);
    const cli::OctreeLevelPicture shown = cli::show_octree_level(stage, level);
    CHECK(shown.side_m == Approx(0.05 * (1 << level)));
    // Every cube with a reading, counted without the tree.
    std::set<std::tuple<double, double, double>> cubes;
    for (const Vector3& point : points) {
      const Vector3 at = stage.octree.grid().in_cells({static_cast<double>(static_cast<float>(point.x)),
                                                       static_cast<double>(static_cast<float>(point.y)),
                                                       static_cast<double>(static_cast<float>(point.z))});
      const double side = 1 << level;
      cubes.insert({std::floor(at.x / side), std::floor(at.y / side), std::floor(at.z / side)});
    }
    CHECK(shown.nodes == cubes.size());
    CHECK(pixels_unlike(shown.picture, cli::paper) > 1000);
  }
}

TEST_CASE("the question that explain draws counts each reading once") {
  const Image<std::uint16_t> depth = scattered();
  const DepthView view{depth, 0.001, camera};
  const auto points = points_of(view);
  const cli::OctreeStage stage = cli::build_octree(view);
  const cli::OctreeQuestionPicture shown = cli::show_octree_question(stage);
  CHECK(shown.passed_points + shown.leaf_points == points.size());
  CHECK(shown.passed_points > points.size() / 2);
  CHECK(shown.passed_nodes < shown.passed_points / 2);
  std::uint32_t inside = 0, unsure = 0;
  for (const Vector3& point : points) {
    const double away = length(point - shown.place);
    inside += away <= shown.radius_m ? 1U : 0U;
    unsure += std::abs(away - shown.radius_m) < 1e-5 ? 1U : 0U;
  }
  CHECK(inside > 20);
  CHECK(shown.found + unsure >= inside);
  CHECK(shown.found <= inside + unsure);
  CHECK(shown.found <= shown.leaf_points);
}

TEST_CASE("an octree of one reading, and of none, can be drawn") {
  Image<std::uint16_t> depth(Size{5, 4});
  const DepthView view{depth, 0.001, {5, 5, 2, 2}};
  CHECK(cli::build_octree(view).points == 0);
  depth.at(3, 1) = 65535;
  const cli::OctreeStage stage = cli::build_octree(view);
  REQUIRE(stage.points == 1);
  CHECK(cli::show_octree_level(stage, 0).nodes == 1);
  CHECK(cli::show_octree_question(stage).found == 1);
}

TEST_CASE("readings a kilometre away and metres that are tiny can be drawn") {
  Image<std::uint16_t> depth = scattered();
  for (const double scale : {1.0, 1e-9, 1e9}) {
    INFO(scale);
    const cli::OctreeStage stage = cli::build_octree({depth, scale, camera});
    REQUIRE(stage.points > 0);
    CHECK(cli::show_octree_level(stage, 4).picture.width() < 1000);
    CHECK(cli::show_octree_question(stage).found > 0);
  }
}
