// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <optional>
#include <string>
#include <utility>

#include "draw_plan.hpp"
#include "straightedge/host/image_file.hpp"
#include "straightedge/host/ros_map.hpp"

using namespace straightedge;

namespace {

Image<std::uint8_t> fixture(const std::string& name) {
  auto image = read_gray_image(std::string(STRAIGHTEDGE_FIXTURES) + "/" + name);
  REQUIRE(static_cast<bool>(image));
  return *image;
}

struct ShippedMap {
  Image<std::uint8_t> picture;
  RosMeaning meaning;
};

ShippedMap shipped_map(const std::string& name) {
  const auto ros = read_ros_map(std::string(STRAIGHTEDGE_FIXTURES) + "/maps/" + name + "/map.yaml");
  REQUIRE(static_cast<bool>(ros));
  auto picture = read_gray_image(ros->image);
  REQUIRE(static_cast<bool>(picture));
  return {std::move(*picture), ros->meaning};
}

}  // namespace

TEST_CASE("the shipped maps become line maps that keep every rule, with and without their thresholds") {
  for (const char* name : {"mrpt", "mrpt_corridor"}) {
    CAPTURE(name);
    const auto [picture, meaning] = shipped_map(name);
    LineMapOptions options;
    CHECK(plan::build(picture, options).map.lines.size() >= 8);
    options.meaning = meaning;
    const LineMapResult result = plan::build(picture, options);
    CHECK(result.map.lines.size() >= 8);
    CHECK(result.report.picture == PictureKind::map);
    REQUIRE(result.map.image.has_value());
    CHECK(result.map.image->meaning == options.meaning);
  }
}

TEST_CASE("of the ragged walls in maps by laser as much is followed as votes find") {
  for (const char* name : {"mrpt_corridor", "mrpt_malaga"}) {
    CAPTURE(name);
    const auto [picture, meaning] = shipped_map(name);
    const auto length = [&picture = picture, &meaning = meaning](const std::optional<HoughOptions>& hough) {
      double sum = 0;
      const LineMap map = plan::build(picture, {.hough = hough, .meaning = meaning}).map;
      for (const plan::Found& found : plan::found_in(map)) sum += found.wall.length();
      return sum;
    };
    CHECK(length({}) > length(line_map_hough));
  }
}

TEST_CASE("photos become line maps without widths") {
  for (const char* name : {"images/left01.jpg", "images/building.jpg"}) {
    CAPTURE(name);
    const LineMapResult result = plan::build(fixture(name));
    CHECK(result.report.picture == PictureKind::photo);
    CHECK(result.map.lines.size() >= 20);
    for (const MapLine& line : result.map.lines) CHECK_FALSE(line.width.has_value());
  }
}
