// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/draw.hpp"

#include <cmath>
#include <limits>

#include "catch.hpp"
#include "random_line_map.hpp"
#include "straightedge/host/map_file.hpp"

using namespace straightedge;

namespace {

const Rgb white{255, 255, 255};
const Rgb black{0, 0, 0};

int changed(const Image<Rgb>& image) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) count += image.at(x, y) != white;
  }
  return count;
}

}  // namespace

TEST_CASE("a stroke along pixel centres covers these pixels alone") {
  Image<Rgb> image({9, 5}, white);
  draw_line(image.view(), {2.5, 2.5}, {6.5, 2.5}, {black, 1, 1});
  for (int x = 0; x < 9; ++x) {
    INFO(x);
    CHECK((image.at(x, 2) == black) == (x >= 2 && x <= 6));
  }
  CHECK(changed(image) == 5);
}

TEST_CASE("a stroke between two rows is shared by them") {
  Image<Rgb> image({9, 6}, white);
  draw_line(image.view(), {0, 3}, {9, 3}, {black, 1, 1});
  CHECK(image.at(4, 2) == image.at(4, 3));
  CHECK(image.at(4, 2).red == 128);
  CHECK(image.at(4, 1) == white);
  CHECK(image.at(4, 4) == white);
}

TEST_CASE("drawing agrees with the distance of every pixel, for all directions and widths") {
  for (int k = 0; k < 48; ++k) {
    Image<Rgb> image({41, 37}, white);
    const double angle = k * pi / 24;
    const Point2 a{20.3, 18.1};
    const Point2 b{a.x + 14 * std::cos(angle), a.y + 14 * std::sin(angle)};
    const double width = 0.5 + k % 5;
    draw_line(image.view(), a, b, {black, width, 1});
    for (int y = 0; y < 37; ++y) {
      for (int x = 0; x < 41; ++x) {
        const double px = x + 0.5 - a.x;
        const double py = y + 0.5 - a.y;
        const double s = std::fmin(14, std::fmax(0, px * std::cos(angle) + py * std::sin(angle)));
        const double distance = std::hypot(px - s * std::cos(angle), py - s * std::sin(angle));
        const double cover = std::fmin(1, std::fmax(0, width / 2 + 0.5 - distance));
        INFO("direction " << k << " pixel " << x << ", " << y);
        REQUIRE(std::abs(image.at(x, y).red - (255 - 255 * cover)) <= 1);
      }
    }
  }
}

TEST_CASE("strokes outside of the picture, endless ones and no numbers are harmless") {
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Image<Rgb> image({8, 8}, white);
  draw_line(image.view(), {-50, -50}, {-9, -20}, {black, 1, 1});
  draw_line(image.view(), {nan, 1}, {3, 3}, {black, 1, 1});
  draw_line(image.view(), {infinity, 1}, {3, 3}, {black, 1, 1});
  draw_line(image.view(), {-1e308, 1}, {1e308, 3}, {black, 1, 1});
  draw_line(image.view(), {1, 1}, {5, 5}, {black, -3, 1});
  draw_line(image.view(), {1, 1}, {5, 5}, {black, nan, 1});
  draw_line({}, {1, 1}, {5, 5}, {black, 1, 1});
  CHECK(changed(image) == 0);
  draw_line(image.view(), {-1e6, 4.5}, {1e6, 4.5}, {black, 1, 1});
  CHECK(changed(image) == 8);
  draw_line(image.view(), {4, 4}, {4, 4}, {black, 1e300, 1});
  CHECK(changed(image) == 64);
}

TEST_CASE("a map is drawn where its lines are, y upwards, in pixels and in metres alike") {
  const Image<std::uint8_t> picture({640, 400}, 255);
  const auto drawn = draw_line_map(picture, small_line_map());
  REQUIRE(drawn);
  const Rgb ground = drawn->at(5, 5);
  CHECK(drawn->at(340, 200) != ground);  // the face x = 20 from y = -60 to 80
  CHECK(drawn->at(340, 125) != ground);
  CHECK(drawn->at(340, 115) == ground);
  CHECK(drawn->at(340, 265) == ground);
  CHECK(drawn->at(300, 98) != ground);  // the wall y = 101.25
  CHECK(drawn->at(300, 302) == ground);

  LineMap turned = small_line_map();
  turned.image->placement = {0.25, 3, -4, 1};
  const auto in_metres = draw_line_map(picture, *to_metres(turned));
  REQUIRE(in_metres);
  int different = 0;
  for (int y = 0; y < 400; ++y) {
    for (int x = 0; x < 640; ++x)
      different += std::abs(in_metres->at(x, y).green - drawn->at(x, y).green) > 1;
  }
  CHECK(different == 0);
}

TEST_CASE("a picture of another size is refused") {
  const Image<std::uint8_t> picture({64, 40});
  CHECK_FALSE(draw_line_map(picture, small_line_map()));
  CHECK_FALSE(draw_line_map(GrayView{}, small_line_map()));
  CHECK_FALSE(draw_line_map(picture, LineMap{}));
}
