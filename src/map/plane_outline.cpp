// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/plane_outline.hpp"

#include <algorithm>

#include "map/plane_basis.hpp"
#include "map/plane_key.hpp"
#include "map/plane_row.hpp"
#include "map/plane_surface.hpp"

namespace straightedge {
namespace {

constexpr double root_3 = 1.7320508075688772;
// To each side of a bundle: what is left open between two is closed with all narrow gaps.
constexpr double closed_anyway = plane_grid::leaf_m / 4;
constexpr double least_variance = 1e-9;  // m²
constexpr double bundle_side = PlaneRow::side;
constexpr double least_correlation = 0.02;

ExtentPiece covered_by_leaf(const PlaneChart& chart, const PlaneLeaf& leaf) {
  const PlaneLeafSums& s = leaf.sums;
  constexpr double q = plane_grid::quantum_m;
  const double share = 1 / static_cast<double>(s.weight);
  const auto average = [share](std::int64_t sum, double unit) {
    return static_cast<double>(sum) * share * unit;
  };
  const Vector3 mean{average(s.x, q), average(s.y, q), average(s.z, q)};
  const auto spread = [&](std::int64_t sum, double a, double b) { return average(sum, q * q) - a * b; };
  const std::array<double, 6> scatter = {spread(s.xx, mean.x, mean.x), spread(s.xy, mean.x, mean.y),
                                         spread(s.xz, mean.x, mean.z), spread(s.yy, mean.y, mean.y),
                                         spread(s.yz, mean.y, mean.z), spread(s.zz, mean.z, mean.z)};
  const PlanePoint middle =
      chart.on(leaf_centre(morton_decode(leaf.key.leaf)) + mean + Vector3{q / 2, q / 2, q / 2});
  const double spacing = s.spacing == plane_grid::no_spacing ? 0 : s.spacing * q;
  const auto half = [spacing](double deviation) {
    return std::max(root_3 * deviation + spacing / 2, bundle_side * spacing / 2 - closed_anyway);
  };
  const double a = std::max(least_variance, quadratic(scatter, chart.u));
  const double b = std::max(least_variance, quadratic(scatter, chart.v));
  const double ab = bilinear(scatter, chart.u, chart.v);
  const double deviation_a = __builtin_sqrt(a), deviation_b = __builtin_sqrt(b);
  const double wide = half(deviation_a), high = half(deviation_b);
  ExtentPiece piece{middle.a - wide, middle.a + wide, middle.b - high, middle.b + high};
  const double correlation = ab * ab / (a * b);  // squared
  if (correlation < least_correlation) return piece;
  const double left = __builtin_sqrt(std::max(0.0, 1 - correlation));
  piece.oblique = true;
  piece.strips[0] = {ab / b, half(deviation_a * left)};
  piece.strips[1] = {a / ab, half(deviation_b * left) * a / (ab < 0 ? -ab : ab)};
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
