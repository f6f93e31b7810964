// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/triangulate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "map/border_chain.hpp"
#include "map/ear_clipping.hpp"
#include "map/hole_bridges.hpp"
#include "map/touching_corners.hpp"

namespace straightedge {
namespace {

struct FlatPoint {
  double x = 0, y = 0;
};

/// Drops the coordinate that the normal is longest in, and keeps the sense of rotation.
class View {
 public:
  explicit View(const Vector3& normal) {
    const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
    dropped_ = z >= x && z >= y ? 2 : y >= x ? 1 : 0;
    const double along = dropped_ == 2 ? normal.z : dropped_ == 1 ? normal.y : normal.x;
    mirrored_ = along < 0;
  }
  FlatPoint operator()(const Vector3& p) const {
    const FlatPoint flat = dropped_ == 2   ? FlatPoint{p.x, p.y}
                           : dropped_ == 1 ? FlatPoint{p.z, p.x}
                                           : FlatPoint{p.y, p.z};
    return mirrored_ ? FlatPoint{flat.y, flat.x} : flat;
  }

 private:
  int dropped_ = 2;
  bool mirrored_ = false;
};

/// To whole numbers from 0 to 2^29. The scale is a power of two, so that points that lie on a grid come to
/// lie on one.
class Steps {
 public:
  Steps(std::span<const MapPolygon> polygons, const View& view) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    low_ = {infinity, infinity};
    FlatPoint high{-infinity, -infinity};
    for (const MapPolygon& polygon : polygons) {
      for (const Vector3& point : polygon.points) {
        const FlatPoint p = view(point);
        valid_ = valid_ && std::isfinite(p.x) && std::isfinite(p.y);
        low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
      }
    }
    const double size = std::max(high.x - low_.x, high.y - low_.y);
    valid_ = valid_ && size > 0 && std::isfinite(size);
    if (!valid_) return;
    int exponent = 0;
    (void)std::frexp(size, &exponent);  // size < 2^exponent
    shift_ = 29 - exponent;
  }
  bool valid() const { return valid_; }
  GridPoint operator()(const FlatPoint& p) const { return {step(p.x - low_.x), step(p.y - low_.y)}; }

 private:
  std::int64_t step(double offset) const {
    return static_cast<std::int64_t>(std::floor(std::ldexp(offset, shift_) + 0.5));
  }
  FlatPoint low_;
  int shift_ = 0;
  bool valid_ = true;
};

/// Adds one closed border, turned to the sense that its kind asks for.
void add_border(Borders& borders, std::vector<Corner> ring, bool hole) {
  while (ring.size() > 1 && ring.back().at == ring.front().at) ring.pop_back();
  if (ring.size() < 3) return;
  double area = 0;
  for (std::size_t i = 2; i < ring.size(); ++i) {
    area += static_cast<double>(turn(ring[0].at, ring[i - 1].at, ring[i].at));
  }
  if ((area < 0) != hole) std::reverse(ring.begin(), ring.end());
  const auto first = static_cast<std::uint32_t>(borders.corners.size());
  const auto last = first + static_cast<std::uint32_t>(ring.size()) - 1;
  borders.corners.insert(borders.corners.end(), ring.begin(), ring.end());
  for (std::uint32_t corner = first; corner < last; ++corner) borders.link(corner, corner + 1);
  borders.link(last, first);
}

Borders borders_of(std::span<const MapPolygon> polygons, const View& view, const Steps& steps) {
  Borders borders;
  std::uint32_t point = 0;
  for (const MapPolygon& polygon : polygons) {
    std::vector<Corner> ring;
    for (const Vector3& p : polygon.points) {
      const GridPoint at = steps(view(p));
      if (ring.empty() || ring.back().at != at) ring.push_back({at, point, 0, 0});
      ++point;
    }
    add_border(borders, std::move(ring), polygon.hole);
  }
  return borders;
}

}  // namespace

std::vector<Triangle> triangulate(std::span<const MapPolygon> polygons, const Vector3& normal) {
  const View view(normal);
  const Steps steps(polygons, view);
  std::vector<Triangle> triangles;
  if (!steps.valid()) return triangles;
  Borders borders = borders_of(polygons, view, steps);                                   // Step 1
  separate_touching(borders);                                                            // Step 2
  bridge_holes(borders);                                                                 // Step 3
  for (const std::uint32_t outer : borders.outer) clip_ears(borders, outer, triangles);  // Step 4
  return triangles;
}

}  // namespace straightedge
