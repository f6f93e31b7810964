// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "inputs.hpp"

#include <array>
#include <limits>

#include "memory.hpp"
#include "straightedge/random.hpp"

namespace same_bits {
namespace {

using straightedge::GrayView;
using straightedge::ImageView;
using straightedge::Pcg32;
using straightedge::PointsView;
using straightedge::Size;

constexpr std::ptrdiff_t picture_stride = 171;
constexpr std::ptrdiff_t color_stride = 251;
constexpr std::ptrdiff_t depth_columns = 137;
constexpr std::ptrdiff_t depth_stride = depth_columns * std::ptrdiff_t{sizeof(std::uint16_t)};
constexpr straightedge::PinholeCamera camera{110, 110, 65, 48};

template <class T, std::ptrdiff_t columns, int height>
using Rows = std::array<T, static_cast<std::size_t>(columns) * height>;

struct Point {
  float x, y, z, beside[2];
};

SAME_BITS_LARGE std::array<std::byte, most_workspace> memory;
SAME_BITS_LARGE Rows<std::uint8_t, picture_stride, picture_size.height> picture_rows, noise_rows, blank_rows;
SAME_BITS_LARGE Rows<std::uint8_t, color_stride, color_size.height> color_rows;
SAME_BITS_LARGE Rows<std::uint16_t, depth_columns, depth_size.height> depth_rows, blank_depth_rows;
SAME_BITS_LARGE std::array<Point, room_points> room;
SAME_BITS_LARGE std::array<Point, seen_points> seen;

int gray_of_ground(int x, int y) noexcept {
  return 70 + x / 5 + y / 9;
}

/// Bars are what lies near the line a x + b y = c.
int gray_at(int x, int y) noexcept {
  int gray = gray_of_ground(x, y);
  if (x >= 14 && x < 52 && y >= 17 && y < 48) gray = 190;
  if (x >= 25 && x < 40 && y >= 25 && y < 39) gray = 40;
  if (x >= 96 && x < 141 && y >= 70 && y < 107) gray = 25;
  const auto bar = [&](int a, int b, int c, int width, int value) {
    const int off = a * x + b * y - c;
    if (off <= width && off >= -width) gray = value;
  };
  bar(3, 5, 470, 9, 225);
  bar(-2, 7, 90, 12, 15);
  bar(11, -4, 1180, 17, 160);
  return gray;
}

void draw_pictures() noexcept {
  Pcg32 random(11);
  for (int y = 0; y < picture_size.height; ++y) {
    for (int x = 0; x < picture_size.width; ++x) {
      const auto at = static_cast<std::size_t>(y * picture_stride + x);
      const int noise = static_cast<int>(random.below(7) + random.below(7)) - 6;
      picture_rows[at] = static_cast<std::uint8_t>(gray_at(x, y) + noise);
      noise_rows[at] = random.below(3) == 0 ? 255 : 0;
      blank_rows[at] = 128;
    }
  }
  for (auto& byte : color_rows) byte = static_cast<std::uint8_t>(random.below(256));
}

/// 1/z in units of 2^-20 per metre.
int inverse_depth_at(int u, int v) noexcept {
  const int x = u - 65, y = v - 48;
  int q = 349525 + 260 * x + 31 * y;                               // back wall
  if (const int floor = 7943 * y - 150 * x; floor > q) q = floor;  // 1.2 m below
  if (const int wall = -6808 * x; wall > q) q = wall;              // 1.4 m to the left
  if (u >= 72 && u < 98 && v >= 41 && v < 77) q = 655360 + 1900 * x;
  if (u >= 98 && u < 112 && v >= 41 && v < 77) q = 655360 + 1900 * 33 - 9500 * (x - 33);
  if (const int r2 = (u - 38) * (u - 38) + (v - 24) * (v - 24); r2 < 196) q = 560000 + 700 * (196 - r2);
  return q;
}

void draw_depth() noexcept {
  constexpr int step = 2988;
  Pcg32 random(12);
  const ImageView<std::uint16_t> raw(depth_rows.data(), depth_size, depth_stride);
  const ImageView<std::uint16_t> blank(blank_depth_rows.data(), depth_size, depth_stride);
  for (int v = 0; v < depth_size.height; ++v) {
    for (int u = 0; u < depth_size.width; ++u) {
      int q = inverse_depth_at(u, v) - 3984;
      for (int i = 0; i < 4; ++i) q += static_cast<int>(random.below(1993));
      q = (q + step / 2) / step * step;
      const auto millimetres = (std::uint64_t{1000} << 20U) / static_cast<std::uint64_t>(q);
      raw.at(u, v) = u < depth_size.width - 3 ? static_cast<std::uint16_t>(millimetres) : 0;
      blank.at(u, v) = 0;
    }
  }
  for (int hole = 0; hole < 60; ++hole) {
    const auto u = static_cast<int>(random.below(128)), v = static_cast<int>(random.below(94));
    for (int i = 0; i < 9; ++i) raw.at(u + i % 3, v + i / 3) = 0;
  }
}

/// Coordinates are 1024ths of a metre.
Point point(int x, int y, int z) noexcept {
  return {static_cast<float>(x) / 1024, static_cast<float>(y) / 1024, static_cast<float>(z) / 1024, {}};
}

void make_room_cloud() noexcept {
  constexpr float infinite = std::numeric_limits<float>::infinity();
  Pcg32 random(13);
  const auto below = [&](std::uint32_t bound) { return static_cast<int>(random.below(bound)); };
  for (std::size_t i = 0; i < room.size(); ++i) {
    const int a = below(4096), b = below(3072), noise = below(13) - 6, part = below(10);
    room[i] = point(a, below(4096), b);
    if (part < 4) room[i] = point(a, b + 300, noise);
    if (part >= 4 && part < 7) room[i] = point(noise, a, b);
    if (part == 7 || part == 8) room[i] = point(a, a / 3 + 800 + noise, b);
    if (i % 97 == 5) room[i].y = i % 2 == 0 ? infinite : -infinite;
  }
}

void make_seen_cloud() noexcept {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const straightedge::DepthView depth = depth_picture();
  std::size_t i = 0;
  for (int v = 0; v < depth_size.height; v += 3) {
    for (int u = 0; u < depth_size.width; u += 3) {
      const int z = depth.raw.at(u, v) * 1024 / 1000;
      seen[i] = point((u - 65) * z / 110, (v - 48) * z / 110, z);
      if (z == 0) seen[i].x = nan;
      ++i;
    }
  }
}

template <std::size_t n>
PointsView view(const std::array<Point, n>& points) noexcept {
  return {&points[0].x, &points[0].y, &points[0].z, n, sizeof(Point), 0};
}

}  // namespace

void make_inputs() noexcept {
  draw_pictures();
  draw_depth();
  make_room_cloud();
  make_seen_cloud();
}

std::span<std::byte> workspace() noexcept {
  memory.fill(sizeof(void*) == 4 ? std::byte{0xFF} : std::byte{0});
  return memory;
}

GrayView picture() noexcept {
  return {picture_rows.data(), picture_size, picture_stride};
}
GrayView noise_picture() noexcept {
  return {noise_rows.data(), picture_size, picture_stride};
}
GrayView blank_picture() noexcept {
  return {blank_rows.data(), picture_size, picture_stride};
}
straightedge::ColorView color_picture(straightedge::PixelFormat format) noexcept {
  return {color_rows.data(), color_size.width, color_size.height, color_stride, format};
}
straightedge::DepthView depth_picture() noexcept {
  return {{depth_rows.data(), depth_size, depth_stride}, 0.001, camera};
}
straightedge::DepthView blank_depth() noexcept {
  return {{blank_depth_rows.data(), depth_size, depth_stride}, 0.001, camera};
}
PointsView room_cloud() noexcept {
  return view(room);
}
PointsView seen_cloud() noexcept {
  PointsView points = view(seen);
  points.width = 44;
  return points;
}

}  // namespace same_bits
