// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// The example that docs/line-map.md works out by hand, done by the library. Whoever changes a number here
// changes it there.
#include <cmath>
#include <cstddef>
#include <vector>

#include "map/line_floor.hpp"
#include "straightedge/canny.hpp"
#include "straightedge/edge_position.hpp"
#include "straightedge/host/image.hpp"
#include "straightedge/host/line_map_builder.hpp"
#include "straightedge/line_fit.hpp"
#include "straightedge/trigonometry.hpp"
#include "support/catch.hpp"

using namespace straightedge;

namespace {

constexpr CannyOptions map_edges{.low = 40, .high = 110};

/// 64 x 48 pixels of white, rows 20 and 21 black from column 12 to 51.
Image<std::uint8_t> thin_wall() {
  Image<std::uint8_t> gray(Size{64, 48});
  for (std::int32_t y = 0; y < 48; ++y) {
    for (std::int32_t x = 0; x < 64; ++x) gray.at(x, y) = (y == 20 || y == 21) && x >= 12 && x < 52 ? 0 : 255;
  }
  return gray;
}

}  // namespace

TEST_CASE("line-map.md: the two edges of a thin wall between the pixels") {
  const Image<std::uint8_t> gray = thin_wall();
  std::vector<std::byte> memory(Canny::workspace_bytes(gray.size(), map_edges));
  Canny canny;
  REQUIRE(Canny::prepare(canny, gray.size(), map_edges, memory) == Status::ok);
  Image<std::uint8_t> edges(gray.size());
  REQUIRE(canny.run(gray, edges.view()).status == Status::ok);
  const std::vector<int> blurred = {246, 221, 173, 126, 126, 173, 221, 246};
  const std::vector<int> magnitude = {132, 292, 380, 188, 188, 380, 292, 132};
  for (std::int32_t k = 0; k < 8; ++k) {
    CHECK(canny.blurred().at(32, 17 + k) == blurred[static_cast<std::size_t>(k)]);
    CHECK(canny.magnitude().at(32, 17 + k) == magnitude[static_cast<std::size_t>(k)]);
    CHECK(edges.at(32, 17 + k) == (k == 2 || k == 5 ? 255 : 0));
  }
  const GradientField field{canny.gradient_x(), canny.gradient_y(), canny.magnitude()};
  const EdgePosition upper = edge_position(field, 32, 19);
  CHECK(upper.x == 32);
  CHECK(upper.y == Approx(19 - 0.5 * (292 - 188) / (2 * 380 - 292 - 188)));
  CHECK(upper.y == Approx(18.814).margin(5e-4));
  CHECK(std::sqrt(upper.variance) == Approx(0.273).margin(5e-4));
  CHECK(edge_position(field, 32, 22).y == Approx(22.186).margin(5e-4));
}

TEST_CASE("line-map.md: the thin wall becomes one axis") {
  const auto found = build_line_map(thin_wall());
  REQUIRE(found);
  CHECK(found->report.picture == PictureKind::map);
  CHECK(found->report.edges == 2);
  CHECK(found->report.walls == 1);
  REQUIRE(found->map.lines.size() == 1);
  const MapLine& line = found->map.lines[0];
  CHECK(line.rho == Approx(3));
  CHECK(line.theta == Approx(pi / 2));
  CHECK(line.width.value() == Approx(2).margin(1e-3));
  CHECK(line.free == FreeSide::both);
  REQUIRE(line.covariance);
  CHECK(std::sqrt(line.covariance->var_offset) == Approx(0.292).margin(5e-4));
  CHECK(std::sqrt(line.covariance->var_theta) == Approx(0.00335).margin(5e-6));
  REQUIRE(line.segments.size() == 1);
  CHECK(line.segments[0].x0 == Approx(19.88).margin(5e-3));
  CHECK(line.segments[0].x1 == Approx(-19.88).margin(5e-3));
  CHECK(line.segments[0].pixels.value() == 76);
}

TEST_CASE("line-map.md: the fit to four points") {
  LineMoments sums;
  sums.add(0, 0);
  sums.add(1, 1);
  sums.add(2, 0);
  sums.add(3, 1);
  LineFit fit;
  REQUIRE(fit_line(sums, fit) == Status::ok);
  CHECK(fit.centroid_x == Approx(1.5));
  CHECK(fit.centroid_y == Approx(0.5));
  // a = 5, b = 1, c = 1: theta = atan2(-2, -4) / 2.
  CHECK(fit.theta * 180 / pi == Approx(-76.72).margin(5e-3));
  CHECK(fit.var_offset == Approx(0.25));
  CHECK(fit.var_theta == Approx(1 / (3 + std::sqrt(5.0))));
  CHECK(fit.residual == Approx(std::sqrt((3 - std::sqrt(5.0)) / 4)));
}

TEST_CASE("line-map.md: the floors") {
  WallLine face, axis;  // upright, of no length: on the grid
  axis.axis = true;
  const auto offset = [](bool crisp, bool noisy, const WallLine& line) {
    Picture picture;
    picture.crisp = crisp;
    picture.noisy = noisy;
    return line_floor(picture, line).offset;
  };
  CHECK(offset(true, false, face) == 0.29);
  CHECK(offset(true, true, axis) == 0.29);
  CHECK(offset(false, false, axis) == 0.2);
  CHECK(offset(false, false, face) == 0.05);
  CHECK(offset(false, true, face) == 0.082);
  Picture picture;
  CHECK(line_floor(picture, face).angle_length == 0.068);
  picture.noisy = true;
  CHECK(line_floor(picture, axis).angle_length == 0.18);
}
