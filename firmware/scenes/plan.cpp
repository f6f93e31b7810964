// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "scenes/plan.hpp"

#include <algorithm>
#include <array>

#include "straightedge/random.hpp"

namespace firmware {
namespace {

using straightedge::HoughSegment;
using straightedge::ImageView;
using straightedge::Size;

/// A wall, or a room cut out of one; in hundredths of the picture's sides.
struct Box {
  int left, top, right, bottom;
  bool wall;
};
constexpr std::array<Box, 6> boxes = {{{6, 8, 94, 92, true},
                                       {9, 12, 91, 88, false},
                                       {44, 12, 48, 60, true},
                                       {60, 56, 91, 60, true},
                                       {18, 68, 30, 80, true},
                                       {70, 22, 82, 34, true}}};
constexpr int reach = 2;  // pixels by which a segment may lie beside its face

/// How much of a pixel's side lies between two borders, in hundredths.
int overlap(int pixel, int low, int high, int side) noexcept {
  return std::max(0, std::min(100 * pixel + 100, high * side) - std::max(100 * pixel, low * side));
}

/// The brightness of a pixel in a sharp picture: what it covers of each box.
int gray_at(Size size, int x, int y) noexcept {
  constexpr int wall = 40, floor = 210;
  int gray = floor;
  for (const Box& b : boxes) {
    const int share = overlap(x, b.left, b.right, size.width) * overlap(y, b.top, b.bottom, size.height);
    gray += ((b.wall ? wall : floor) - gray) * share / 10000;
  }
  return gray;
}

bool is_wall(Size size, int x, int y) noexcept {
  return gray_at(size, x, y) < 125;
}

/// Whether wall and floor meet within reach of a pixel.
bool near_face(Size size, int x, int y) noexcept {
  bool wall = false, floor = false;
  for (int j = y - reach; j <= y + reach; ++j) {
    for (int i = x - reach; i <= x + reach; ++i) (is_wall(size, i, j) ? wall : floor) = true;
  }
  return wall && floor;
}

std::int64_t squared(std::int64_t x) noexcept {
  return x * x;
}

/// Whether a pixel lies within reach of a segment.
bool near_segment(const HoughSegment& s, int x, int y) noexcept {
  const std::int64_t dx = s.x1 - s.x0, dy = s.y1 - s.y0, ax = x - s.x0, ay = y - s.y0;
  const std::int64_t length = dx * dx + dy * dy, along = ax * dx + ay * dy;
  if (along <= 0 || length == 0) return ax * ax + ay * ay <= reach * reach;
  if (along >= length) return squared(x - s.x1) + squared(y - s.y1) <= reach * reach;
  return squared(ax * dy - ay * dx) <= reach * reach * length;
}

bool near_any(std::span<const HoughSegment> segments, int x, int y) noexcept {
  for (const HoughSegment& segment : segments) {
    if (near_segment(segment, x, y)) return true;
  }
  return false;
}

std::uint32_t percent(std::uint32_t part, std::uint32_t whole) noexcept {
  return whole == 0 ? 0 : part * 100 / whole;
}

}  // namespace

void draw_plan(ImageView<std::uint8_t> out) noexcept {
  straightedge::Pcg32 random(3);
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x) {
      const std::uint32_t noise = random.below(13);
      out.at(x, y) = static_cast<std::uint8_t>(static_cast<std::uint32_t>(gray_at(out.size(), x, y)) + noise);
    }
  }
}

void draw_plan_edges(ImageView<std::uint8_t> out) noexcept {
  straightedge::Pcg32 random(5);
  const Size size = out.size();
  const auto draw = [&](int x, int y) {
    if (out.contains(x, y)) out.at(x, y) = 255;
  };
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) out.at(x, y) = random.below(200) == 0 ? 255 : 0;
  }
  for (int y = 1; y < size.height; ++y) {
    for (int x = 1; x < size.width; ++x) {
      const bool here = is_wall(size, x, y);
      const std::uint32_t chance = random.below(16);
      if (chance == 0) continue;
      const int aside = chance == 1 ? 1 : 0;
      if (here != is_wall(size, x - 1, y)) draw(x - aside, y);
      if (here != is_wall(size, x, y - 1)) draw(x, y - aside);
    }
  }
}

PlanScore score_plan(Size size, std::span<const HoughSegment> segments) noexcept {
  std::uint32_t faces = 0, found = 0, drawn = 0, right = 0;
  for (int y = 1; y < size.height; ++y) {
    for (int x = 1; x < size.width; ++x) {
      const bool here = is_wall(size, x, y);
      if (here == is_wall(size, x - 1, y) && here == is_wall(size, x, y - 1)) continue;
      ++faces;
      found += near_any(segments, x, y) ? 1U : 0U;
    }
  }
  for (const HoughSegment& s : segments) {
    constexpr int samples = 32;
    for (int i = 0; i <= samples; ++i) {
      ++drawn;
      right +=
          near_face(size, s.x0 + (s.x1 - s.x0) * i / samples, s.y0 + (s.y1 - s.y0) * i / samples) ? 1U : 0U;
    }
  }
  return {percent(found, faces), percent(right, drawn)};
}

}  // namespace firmware
