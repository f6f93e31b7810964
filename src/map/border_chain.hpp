// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

namespace straightedge {

/// Coordinates from 0 to 2^29, so that the products below are exact.
struct GridPoint {
  std::int64_t x = 0, y = 0;
  bool operator==(const GridPoint&) const = default;
};

/// Positive when c lies to the left of the way from a to b, 0 on it; twice the area of the triangle.
constexpr std::int64_t turn(const GridPoint& a, const GridPoint& b, const GridPoint& c) noexcept {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// A corner of a closed border that has the area to its left: outer borders run counter-clockwise,
/// holes clockwise.
struct Corner {
  GridPoint at;
  std::uint32_t point = 0;              ///< index of the caller's point
  std::uint32_t before = 0, after = 0;  ///< its neighbours on the border
};

/// Closed borders as rings of corners.
struct Borders {
  std::vector<Corner> corners;
  std::vector<std::uint32_t> outer, holes;  ///< a corner of each; filled by separate_touching

  const GridPoint& at(std::uint32_t corner) const noexcept { return corners[corner].at; }
  const GridPoint& before(std::uint32_t corner) const noexcept { return at(corners[corner].before); }
  const GridPoint& after(std::uint32_t corner) const noexcept { return at(corners[corner].after); }
  std::int64_t turn_at(std::uint32_t corner) const noexcept {
    return turn(before(corner), at(corner), after(corner));
  }
  void link(std::uint32_t first, std::uint32_t second) noexcept {
    corners[first].after = second;
    corners[second].before = first;
  }
};

}  // namespace straightedge
