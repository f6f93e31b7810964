// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/walls.hpp"

#include <cmath>

#include "stage_lines.hpp"
#include "support/drawing.hpp"

using namespace straightedge;
using stage::face;

namespace {

constexpr Size size{140, 100};

/// A black bar along v = 50 and its two faces, as far apart as blur would move them.
struct Bar {
  support::Canvas canvas{size};
  std::vector<WallLine> faces;

  explicit Bar(double width, double apart) {
    canvas.paint_bar({20, 50}, {120, 50}, width);
    faces = {face({19.5, 49.5 - apart / 2}, {119.5, 49.5 - apart / 2}),
             face({119.5, 49.5 + apart / 2}, {19.5, 49.5 + apart / 2})};
  }
  std::uint32_t join(double max_width) {
    return join_thin_walls(faces, LineSampler(canvas.picture()), max_width);
  }
};

}  // namespace

TEST_CASE("the two faces of a thin wall become its axis, its width told by its darkness") {
  for (const double width : {1.0, 1.7, 2.5, 3.4}) {
    for (const double blur : {0.0, 0.4, 0.9}) {
      CAPTURE(width, blur);
      Bar bar(width, width + blur);
      CHECK(bar.join(3.6) == 1);
      REQUIRE(bar.faces.size() == 1);
      const WallLine& axis = bar.faces[0];
      CHECK(axis.axis);
      CHECK(axis.width == Approx(width).margin(0.05));
      CHECK(axis.fit.centroid_y == Approx(49.5).margin(1e-6));
      CHECK(std::fabs(axis.ny) == Approx(1).margin(1e-9));
      CHECK(axis.length() == Approx(100).margin(1e-6));
      CHECK(axis.pixels == 202);
      CHECK(axis.count == 2);
    }
  }
}

TEST_CASE("a wall wider than the limit keeps its faces") {
  Bar bar(6, 6);
  CHECK(bar.join(3.6) == 0);
  REQUIRE(bar.faces.size() == 2);
  CHECK_FALSE(bar.faces[0].axis);
  CHECK_FALSE(bar.faces[1].axis);
  CHECK(Bar(6, 6).join(7) == 1);
}

TEST_CASE("a light gap, one side alone and faces that look the same way are no thin wall") {
  const Image<std::uint8_t> white(size, 255);
  const WallLine upper = face({20, 48}, {120, 48});
  const std::vector<std::vector<WallLine>> cases{
      {face({120, 48}, {20, 48}), face({20, 50}, {120, 50})},  // light between them
      {upper},
      {upper, face({20, 50}, {120, 50})},
      {upper, face({120, 70}, {20, 70})},
      {upper, face({60, 50}, {60, 90})},
      {face({20, 48}, {60, 48}), face({120, 50}, {70, 50})},  // not beside one another
  };
  for (std::size_t i = 0; i < cases.size(); ++i) {
    CAPTURE(i);
    std::vector<WallLine> lines = cases[i];
    CHECK(join_thin_walls(lines, LineSampler(white), 3.6) == 0);
    CHECK(lines.size() == cases[i].size());
  }
}

TEST_CASE("a long face takes all the pieces that lie opposite to it") {
  Bar bar(2.4, 2.6);
  const double v = 49.5 + 1.3;
  bar.faces = {bar.faces[0], face({55, v}, {19.5, v}), face({119.5, v}, {60, v})};
  CHECK(bar.join(3.6) == 1);
  REQUIRE(bar.faces.size() == 1);
  CHECK(bar.faces[0].count == 3);
  CHECK(bar.faces[0].fit.centroid_y == Approx(49.5).margin(0.02));
}

TEST_CASE("nothing joins to nothing") {
  std::vector<WallLine> none;
  CHECK(join_thin_walls(none, LineSampler(Image<std::uint8_t>(size, 255)), 3.6) == 0);
}
