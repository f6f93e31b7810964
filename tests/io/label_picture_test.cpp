// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/label_picture.hpp"

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "catch.hpp"

using namespace straightedge;

namespace {

int difference(Rgb a, Rgb b) {
  return std::abs(a.red - b.red) + std::abs(a.green - b.green) + std::abs(a.blue - b.blue);
}

bool gray(Rgb colour) {
  return colour.red == colour.green && colour.green == colour.blue;
}

}  // namespace

TEST_CASE("the colour of an id never changes") {
  CHECK(plane_colour(0) == Rgb{128, 128, 128});
  CHECK(plane_colour(1) == Rgb{105, 134, 205});
  CHECK(plane_colour(2) == Rgb{126, 185, 45});
}

TEST_CASE("ids near one another in number have colours that differ, and none is taken for gray") {
  for (std::uint32_t id = 1; id <= 3000; ++id) {
    const Rgb colour = plane_colour(id);
    const int strength =
        std::max({colour.red, colour.green, colour.blue}) - std::min({colour.red, colour.green, colour.blue});
    REQUIRE(strength >= 90);
    for (std::uint32_t other = id + 1; other <= id + 7; ++other) {
      INFO(id << " and " << other);
      REQUIRE(difference(colour, plane_colour(other)) >= 40);
    }
  }
}

TEST_CASE("labels have their colours, the rest is black") {
  const std::vector<std::uint16_t> labels{0, 1, 2, 65535, 1, 0};
  const Image<Rgb> picture = label_picture({labels.data(), {3, 2}});
  REQUIRE(picture.size() == Size{3, 2});
  CHECK(picture.at(0, 0) == Rgb{});
  CHECK(picture.at(1, 0) == plane_colour(1));
  CHECK(picture.at(2, 0) == plane_colour(2));
  CHECK(picture.at(0, 1) == plane_colour(65535));
  CHECK(picture.at(1, 1) == plane_colour(1));
}

TEST_CASE("depth is dim gray beside labels and a slight shade on them, darker farther away") {
  const std::vector<std::uint16_t> labels{0, 0, 0, 3, 3, 3};
  const std::vector<std::uint16_t> depth{0, 500, 4000, 0, 500, 4000};
  const Image<Rgb> picture = label_picture({labels.data(), {3, 2}}, {depth.data(), {3, 2}});
  CHECK(picture.at(0, 0) == Rgb{});
  CHECK(picture.at(1, 0) == Rgb{120, 120, 120});
  CHECK(picture.at(2, 0) == Rgb{44, 44, 44});
  CHECK(picture.at(0, 1) == plane_colour(3));
  CHECK(picture.at(1, 1) == plane_colour(3));
  CHECK(picture.at(2, 1).red == plane_colour(3).red * 3 / 4);
  CHECK_FALSE(gray(picture.at(2, 1)));
}

TEST_CASE("rows may have gaps, one depth may fill the picture, and bad views give what the header says") {
  std::vector<std::uint16_t> labels(8, 9);
  labels[4] = 0;
  const ImageView<const std::uint16_t> strided(labels.data(), {2, 2}, 8);
  const std::vector<std::uint16_t> flat(4, 700);
  const Image<Rgb> picture = label_picture(strided, {flat.data(), {2, 2}});
  CHECK(picture.at(0, 1) == Rgb{120, 120, 120});
  CHECK(picture.at(1, 1) == plane_colour(9));
  CHECK(label_picture(strided, {flat.data(), {1, 4}}).at(0, 1) == Rgb{});
  CHECK(label_picture({}).empty());
  CHECK(label_picture({labels.data(), {4, 1}, 2}).empty());
}
