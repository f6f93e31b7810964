// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <vector>

#include "map/bridge.hpp"
#include "map/line_grid.hpp"
#include "map/strokes.hpp"
#include "stage_lines.hpp"
#include "support/drawing.hpp"
#include "support/edge_scene.hpp"

using namespace straightedge;

namespace {

constexpr Size size{160, 100};

/// Two pieces of an axis along v = 50 with a gap from column 70 to 100.
std::vector<WallLine> two_pieces() {
  return {stage::axis({30, 49.5}, {70, 49.5}), stage::axis({100, 49.5}, {140, 49.5})};
}

}  // namespace

TEST_CASE("a gap that shows as much wall as its neighbours is bridged, a door is not") {
  support::Canvas whole(size);
  whole.paint_bar({30, 50}, {140, 50}, 2);
  auto lines = two_pieces();
  CHECK(bridge_pale_gaps(lines, {{0, 1}}, support::EdgeScene(whole.picture()).blurred()) == 1);
  stage::check_ends(lines[0], {30, 49.5}, {140, 49.5}, 0.01);
  CHECK(lines[1].length() == 0);
  CHECK(lines[0].pixels == 82);

  support::Canvas door(size);
  door.paint_bar({30, 50}, {71, 50}, 2);
  door.paint_bar({100, 50}, {140, 50}, 2);
  lines = two_pieces();
  CHECK(bridge_pale_gaps(lines, {{0, 1}}, support::EdgeScene(door.picture()).blurred()) == 0);
  CHECK(lines[1].length() > 39);
}

TEST_CASE("pieces are bridged in whatever order and direction they come; faces are let alone") {
  support::Canvas whole(size);
  whole.paint_bar({30, 50}, {140, 50}, 2);
  const support::EdgeScene scene(whole.picture());
  std::vector<WallLine> turned = {stage::axis({140, 49.5}, {100, 49.5}), stage::axis({70, 49.5}, {30, 49.5})};
  CHECK(bridge_pale_gaps(turned, {{0, 1}}, scene.blurred()) == 1);
  CHECK(std::max(turned[0].length(), turned[1].length()) == Approx(110).margin(0.01));
  std::vector<WallLine> faces = {stage::face({30, 49.5}, {70, 49.5}), stage::face({100, 49.5}, {140, 49.5})};
  CHECK(bridge_pale_gaps(faces, {{0, 1}}, scene.blurred()) == 0);
}

TEST_CASE("a face with a thin wall behind it becomes its axis, one of a thick wall does not") {
  support::Canvas canvas(size);
  canvas.paint_bar({30, 30}, {140, 30}, 2.5);
  canvas.paint_bar({30, 70}, {140, 70}, 8);
  // Faces on the upper edges, the light side up.
  std::vector<WallLine> lines = {stage::face({31, 28.25}, {139, 28.25}),
                                 stage::face({31, 65.5}, {139, 65.5})};
  REQUIRE(lines[0].ny == Approx(-1));
  CHECK(turn_strokes_to_axes(lines, LineSampler(canvas.picture()), 3.6) == 1);
  CHECK(lines[0].axis);
  CHECK(lines[0].width == Approx(2.5).margin(0.15));
  CHECK(stage::begin_of(lines[0]).y == Approx(29.5).margin(0.1));
  CHECK_FALSE(lines[1].axis);
  CHECK(stage::begin_of(lines[1]).y == Approx(65.5).margin(1e-9));
}

TEST_CASE("the grid of lines finds every line that comes near, as comparing each with each does") {
  std::vector<WallLine> lines;
  for (int i = 0; i < 40; ++i) {
    const double x = 37.0 * (i % 8), y = 53.0 * (i / 8);
    lines.push_back(stage::axis({x, y}, {x + 20 + 3.0 * i, y + 40 - 2.0 * i}));
  }
  constexpr double reach = 10;
  LineGrid grid(lines, reach);
  for (const WallLine& line : lines) {
    const std::vector<std::uint32_t>& near = grid.near(line);
    CHECK(std::is_sorted(near.begin(), near.end()));
    for (std::size_t j = 0; j < lines.size(); ++j) {
      bool close = false;
      for (double s = line.begin; s <= line.end && !close; s += 1) {
        for (double t = lines[j].begin; t <= lines[j].end && !close; t += 1) {
          const double dx = line.x_at(s) - lines[j].x_at(t), dy = line.y_at(s) - lines[j].y_at(t);
          close = dx * dx + dy * dy <= reach * reach;
        }
      }
      if (close) CHECK(std::binary_search(near.begin(), near.end(), j));
    }
  }
}
