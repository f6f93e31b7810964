// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/plane_outline.hpp"

#include <algorithm>

#include "map/plane_basis.hpp"
#include "map/plane_key.hpp"
#include "map/plane_surface.hpp"

namespace straightedge {
namespace {

constexpr double least_variance = 1e-9;  // m²
constexpr double least_lean = 1e-3;

ExtentPiece covered_by_leaf(const PlaneChart& chart, const PlaneLeaf& leaf) {
  const Surface s = surface_of(leaf, leaf_centre(morton_decode(leaf.key.leaf)));
  const double weight = s.moments.weight;
  const PlanePoint mean = chart.on(s.origin + (1 / weight) * Vector3{s.moments.x, s.moments.y, s.moments.z});
  const auto scatter = scatter_of(s.moments);
  const double spacing = leaf.sums.spacing == plane_grid::no_spacing ? 0 : leaf.sums.spacing;
  const double margin = spacing * plane_grid::quantum_m / 2;
  const double a = std::max(least_variance, quadratic(scatter, chart.u) / weight);
  const double b = std::max(least_variance, quadratic(scatter, chart.v) / weight);
  const double ab = bilinear(scatter, chart.u, chart.v) / weight;
  const auto half = [margin](double variance) {
    return __builtin_sqrt(3 * std::max(0.0, variance)) + margin;
  };
  ExtentPiece piece{mean.a - half(a), mean.a + half(a), mean.b - half(b), mean.b + half(b), {}};
  piece.strips[0] = {ab / b, half(a - ab * ab / b)};
  const double steep = ab / a;
  if (steep > least_lean || steep < -least_lean)
    piece.strips[1] = {1 / steep, half(b - ab * ab / a) / (steep < 0 ? -steep : steep)};
  return piece;
}

}  // namespace

PlaneChart::PlaneChart(const Plane& plane, const Vector3& near) {
  const PlaneBasis basis = plane_basis(plane.normal);
  origin = near - plane.signed_distance(near) * plane.normal;
  u = basis.u;
  v = basis.v;
}

ExtentOptions extent_options(const PlaneMapOptions& options) {
  ExtentOptions extent;
  extent.max_gap = options.max_gap;
  extent.max_hole = options.max_hole;
  extent.min_area = options.min_area;
  return extent;
}

std::vector<ExtentPiece> covered_by(const PlaneChart& chart, std::span<const PlaneLeaf> leaves,
                                    std::span<const std::uint32_t> which) {
  std::vector<ExtentPiece> pieces;
  pieces.reserve(which.size());
  for (const std::uint32_t i : which) pieces.push_back(covered_by_leaf(chart, leaves[i]));
  return pieces;
}

std::vector<MapPolygon> polygons_of(const PlaneChart& chart, std::span<const ExtentLoop> loops) {
  std::vector<MapPolygon> polygons;
  for (const ExtentLoop& loop : loops) {
    MapPolygon polygon;
    polygon.hole = loop.area < 0;
    for (const PlanePoint& p : loop.points) polygon.points.push_back(chart.at(p));
    polygons.push_back(std::move(polygon));
  }
  return polygons;
}

}  // namespace straightedge
