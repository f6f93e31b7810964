// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "pictures.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "straightedge/host/image_file.hpp"

namespace bench {
namespace {

using Gray = straightedge::Image<std::uint8_t>;

std::int32_t mirrored(std::int32_t i, std::int32_t length) {
  const std::int32_t inside = i % (2 * length);
  return inside < length ? inside : 2 * length - 1 - inside;
}

Gray tiled_photo(straightedge::Size size) {
  const auto photo = straightedge::read_gray_image(STRAIGHTEDGE_FIXTURES "/images/building.jpg");
  if (!photo) {
    std::fprintf(stderr, "%s\n", photo.failure().sentence.c_str());
    std::exit(3);
  }
  Gray tiles(size);
  for (std::int32_t y = 0; y < size.height; ++y) {
    for (std::int32_t x = 0; x < size.width; ++x) {
      tiles.at(x, y) = photo->at(mirrored(x, photo->width()), mirrored(y, photo->height()));
    }
  }
  return tiles;
}

void fill(Gray& plan, std::int32_t left, std::int32_t top, std::int32_t right, std::int32_t bottom,
          std::uint8_t value) {
  for (std::int32_t y = std::max(top, 0); y < std::min(bottom, plan.height()); ++y) {
    for (std::int32_t x = std::max(left, 0); x < std::min(right, plan.width()); ++x) plan.at(x, y) = value;
  }
}

Gray drawn_floor_plan(straightedge::Size size) {
  constexpr std::int32_t room_width = 90, room_height = 70, wall = 3, door = 20;
  constexpr std::uint8_t ground = 254, ink = 0;
  Gray plan(size, ground);
  for (std::int32_t top = 10; top + room_height < size.height; top += room_height) {
    for (std::int32_t left = 10; left + room_width < size.width; left += room_width) {
      fill(plan, left, top, left + room_width, top + wall, ink);
      fill(plan, left, top, left + wall, top + room_height, ink);
      fill(plan, left + 30, top, left + 30 + door, top + wall, ground);
    }
  }
  // The wing: walls that rise one row in three columns.
  for (std::int32_t x = 0; x < size.width; ++x) {
    for (std::int32_t y = size.height - 20 - x / 3; y > 0; y -= 4 * room_height) {
      fill(plan, x, y, x + 1, y + wall, ink);
    }
  }
  return plan;
}

}  // namespace

std::string Job::name() const {
  const std::string kind = picture == Picture::photo ? "photo" : "floor_plan";
  return kind + "/" + std::to_string(size.width) + "x" + std::to_string(size.height);
}

Gray make_picture(const Job& job) {
  return job.picture == Picture::photo ? tiled_photo(job.size) : drawn_floor_plan(job.size);
}

}  // namespace bench
