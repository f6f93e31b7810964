// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "straightedge/octree.hpp"
#include "straightedge/random.hpp"
#include "support/catch.hpp"

namespace test {

using straightedge::Vector3;

struct Point {
  float x, y, z;
};
using Points = std::vector<Point>;

inline straightedge::PointsView view(const Points& points) {
  straightedge::PointsView v;
  if (points.empty()) return v;
  v.x = &points[0].x;
  v.y = &points[0].y;
  v.z = &points[0].z;
  v.count = points.size();
  v.stride = sizeof(Point);
  return v;
}

inline Vector3 position(const Point& p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
}

/// A number in [-1, 1].
inline float unit(straightedge::Pcg32& random) {
  return static_cast<float>(random.below(2'000'001)) / 1e6F - 1;
}
inline Point in_box(straightedge::Pcg32& random, float half) {
  return {half * unit(random), half * unit(random), half * unit(random)};
}

/// Clouds that differ in what is hard about them.
inline const std::vector<std::string> kinds = {"random",     "clusters", "plane",      "duplicates",
                                               "line",       "borders",  "single",     "far",
                                               "not finite", "huge",     "wide apart", "tiny"};

inline Points cloud(const std::string& kind, std::size_t count, straightedge::Pcg32& random) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  Points points;
  if (kind == "single") count = 1;
  for (std::size_t i = 0; i < count; ++i) {
    Point p = in_box(random, 2);
    const auto step = static_cast<float>(i);
    if (kind == "clusters") {
      const Point d = in_box(random, 0.05F);
      const auto c = static_cast<float>(i % 5);
      p = {c * c * 0.3F + d.x, 1 - c + d.y, c * 0.1F + d.z};
    } else if (kind == "plane") {
      p.z = 0.5F;
    } else if (kind == "duplicates" && i >= 7) {
      p = points[random.below(7)];
    } else if (kind == "line") {
      p = {0.01F * step, 0.02F * step, -0.01F * step};
    } else if (kind == "borders") {
      const auto eighth = [&] { return static_cast<float>(random.below(33)) / 8 - 2; };
      p = {eighth(), eighth(), eighth()};
    } else if (kind == "far") {
      p = {p.x + 1000, p.y - 1000, p.z + 1000};
    } else if (kind == "not finite" && i % 4 < 3) {
      (i % 4 == 0   ? p.x
       : i % 4 == 1 ? p.y
                    : p.z) = i % 3 == 0   ? std::numeric_limits<float>::quiet_NaN()
                             : i % 3 == 1 ? infinity
                                          : -infinity;
    } else if (kind == "huge" && i % 2 == 0) {
      p = {p.x * 1e30F, p.y * 1e10F, p.z * 3e7F};
    } else if (kind == "wide apart") {
      p = in_box(random, 50'000);
    } else if (kind == "tiny") {
      p = in_box(random, 1e-22F);  // their squares are too small for floats
    }
    points.push_back(p);
  }
  return points;
}

/// A prepared octree with pattern bytes on both sides of its workspace.
class Tree {
 public:
  explicit Tree(std::size_t capacity, straightedge::OctreeOptions options = {.grid = {.leaf_m = 0.125}})
      : bytes_(margin + straightedge::Octree::workspace_bytes(static_cast<std::uint32_t>(capacity), options) +
                   margin,
               pattern) {
    REQUIRE(bytes_.size() > 2 * margin);
    const std::span<std::byte> inner = std::span(bytes_).subspan(margin, bytes_.size() - 2 * margin);
    REQUIRE(straightedge::Octree::prepare(octree, static_cast<std::uint32_t>(capacity), options, inner) ==
            straightedge::Status::ok);
  }
  Tree(const Tree&) = delete;
  Tree& operator=(const Tree&) = delete;
  ~Tree() { CHECK(guards_intact()); }

  straightedge::Octree octree;

  bool guards_intact() const {
    for (std::size_t i = 0; i < margin; ++i)
      if (bytes_[i] != pattern || bytes_[bytes_.size() - 1 - i] != pattern) return false;
    return true;
  }

 private:
  static constexpr std::size_t margin = 192;
  static constexpr std::byte pattern{0xA5};
  std::vector<std::byte> bytes_;
};

/// Those that an octree with this grid keeps.
inline std::vector<std::uint32_t> kept(const Points& points, const straightedge::OctreeGrid& grid) {
  std::vector<std::uint32_t> indices;
  straightedge::MortonCell cell;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if (grid.cell_of(position(points[i]), cell)) indices.push_back(i);
  return indices;
}

/// Every node's code, level, points and extent, in order.
inline bool same_nodes(const straightedge::OctreeNodes& a, const straightedge::OctreeNodes& b) {
  if (a.size() != b.size() || a.leaves() != b.leaves() || a.points() != b.points()) return false;
  for (std::uint32_t i = 0; i < a.size(); ++i)
    if (a[i].key != b[i].key || a[i].first != b[i].first || a[i].next != b[i].next) return false;
  return true;
}

}  // namespace test
