// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/export.hpp"

#include <cmath>

#include "map/furniture.hpp"
#include "stage_lines.hpp"
#include "straightedge/host/map_file.hpp"
#include "straightedge/trigonometry.hpp"
#include "support/drawing.hpp"

using namespace straightedge;

namespace {

constexpr Size size{200, 100};

Picture blank() {
  return understand_picture(Image<std::uint8_t>(size, 255), PictureKind::map, {});
}

void check_rules(const std::vector<MapLine>& lines) {
  LineMap map;
  map.image = MapImage{.file = {}, .size = size, .placement = {}, .meaning = {}};
  map.lines = lines;
  CHECK(check_line_map(map).empty());
}

}  // namespace

TEST_CASE("columns and rows become the frame of the image's centre, y up") {
  // Row 29 is v = 29.5, so 20.5 above the centre; columns 20 to 80 are u = 20.5 to 80.5.
  const auto lines = to_map_lines({stage::face({20, 29}, {80, 29})}, {{0}}, blank(), blank().gray.size());
  REQUIRE(lines.size() == 1);
  CHECK(lines[0].rho == Approx(20.5).epsilon(1e-12));
  CHECK(lines[0].theta == Approx(pi / 2).epsilon(1e-12));
  REQUIRE(lines[0].segments.size() == 1);
  const MapSegment& segment = lines[0].segments[0];
  CHECK(segment.x0 == Approx(-19.5));  // ordered along (−sin theta, cos theta)
  CHECK(segment.x1 == Approx(-79.5));
  CHECK(segment.y0 == Approx(20.5));
  CHECK(segment.y1 == Approx(20.5));
  CHECK_FALSE(lines[0].width.has_value());
  REQUIRE(lines[0].covariance.has_value());
  CHECK(lines[0].covariance->at_x == Approx(-49.5));
  CHECK(lines[0].covariance->at_y == Approx(20.5));
  check_rules(lines);
}

TEST_CASE("lines all round the centre keep the rules and their free side") {
  for (int i = 0; i < 24; ++i) {
    for (const double aside : {30.0, 5.0, 0.0, -5.0, -30.0}) {
      CAPTURE(i, aside);
      const double c = std::cos(i * 15 * degree), s = std::sin(i * 15 * degree);
      const Point2 foot{99.5 - aside * s, 49.5 + aside * c};
      WallLine line = stage::face({foot.x - 30 * c, foot.y - 30 * s}, {foot.x + 30 * c, foot.y + 30 * s});
      line.free_plus = true;
      const auto lines = to_map_lines({line}, {{0}}, blank(), blank().gray.size());
      REQUIRE(lines.size() == 1);
      check_rules(lines);
      const Point2 light = centre_from_image({foot.x + 0.5 + 4 * line.nx, foot.y + 0.5 + 4 * line.ny}, size);
      const bool plus = signed_distance(light, lines[0].rho, lines[0].theta) > 0;
      CHECK(lines[0].free == (plus ? FreeSide::plus : FreeSide::minus));
      CHECK(lines[0].rho == Approx(std::fabs(aside)).margin(1e-9));
    }
  }
}

TEST_CASE("the segments of one line add up; ids count through the map") {
  WallLine a = stage::axis({20, 30}, {60, 30}, 2), b = stage::axis({140, 30}, {80, 30}, 3);
  a.free_plus = true;  // above
  b.free_plus = true;  // below, for it runs the other way
  const WallLine other = stage::face({20, 70}, {90, 70});
  const auto lines = to_map_lines({a, other, b}, {{0, 2}, {1}}, blank(), blank().gray.size());
  REQUIRE(lines.size() == 2);
  CHECK(lines[0].id == 0);
  CHECK(lines[1].id == 1);
  REQUIRE(lines[0].segments.size() == 2);
  CHECK(lines[0].segments[0].id == 0);
  CHECK(lines[0].segments[1].id == 1);
  CHECK(lines[1].segments.at(0).id == 2);
  CHECK(lines[0].votes == a.votes + b.votes);
  CHECK(lines[0].count == 2U);
  REQUIRE(lines[0].width.has_value());
  CHECK(*lines[0].width == Approx((2 * 40 + 3 * 60) / 100.0));
  CHECK(lines[0].free == FreeSide::both);
  CHECK(lines[1].free == FreeSide::unknown);
  CHECK(lines[0].segments[0].pixels == a.pixels);
  check_rules(lines);
}

TEST_CASE("faces of small things that stand alone are furniture") {
  support::Canvas canvas(size);
  canvas.paint_box(20, 20, 36, 32);
  canvas.paint_box(80, 20, 180, 32);
  canvas.paint_bar({20, 70}, {36, 70}, 2);
  const WallLine box = stage::face({20, 19.5}, {35, 19.5});
  const WallLine wall = stage::face({80, 19.5}, {179, 19.5});
  const WallLine short_piece_of_wall = stage::face({80, 19.5}, {95, 19.5});
  const WallLine dash = stage::axis({20, 69.5}, {35, 69.5});
  Image<std::uint8_t> marks;
  std::vector<WallLine> lines{box, wall, short_piece_of_wall, dash};
  CHECK(drop_furniture(lines, canvas.picture(), 26, 3.6, marks) == 1);
  CHECK(lines.size() == 3);
  for (const WallLine& line : lines) CHECK((line.axis || line.x_at(line.begin) > 70));
  lines = {box};
  CHECK(drop_furniture(lines, canvas.picture(), 10, 3.6, marks) == 0);
  lines = {};
  CHECK(drop_furniture(lines, canvas.picture(), 26, 3.6, marks) == 0);
}

TEST_CASE("a line that takes other moments keeps its ends where they are, moved onto it") {
  WallLine line = stage::face({20, 30}, {60, 30});
  const WallLine before = line;
  line.adopt(line.moments, line.origin_x, line.origin_y);
  stage::check_ends(line, stage::begin_of(before), stage::end_of(before), 1e-9);
  const WallLine longer = stage::face({10, 31}, {150, 31});
  line.adopt(longer.moments, longer.origin_x, longer.origin_y);
  stage::check_ends(line, {20, 31}, {60, 31}, 1e-9);
  CHECK(line.nx * before.nx + line.ny * before.ny == Approx(1));
}
