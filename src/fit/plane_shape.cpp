// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "plane_shape.hpp"

#include <array>

#include "plane_surfaces.hpp"
#include "straightedge/square_root.hpp"

namespace straightedge::detail {
namespace {

// Bend, in standard deviations of one reading, and its significance. True planes of rendered rooms stay below
// both pairs in 98 of 100 cases, strips of balls and pillars above one of them in 9 of 10.
struct BendLimit {
  double bend, significance;
};
constexpr std::array<BendLimit, 2> bend_limits{BendLimit{0.3, 1.2}, BendLimit{0.2, 1.75}};
// Walls bend in the pictures of real sensors, though by far less.
constexpr double largest_radius_m = 0.6;

/// Largest absolute eigenvalue of [2a b; b 2c], the second derivatives of a uu + b uv + c vv.
double largest_curvature(double a, double b, double c) noexcept {
  const double mean = a + c;
  const double spread = square_root((a - c) * (a - c) + b * b);
  return (mean < 0 ? -mean : mean) + spread;
}

}  // namespace

PlaneShape plane_shape(std::uint32_t cells, std::uint32_t solid, const QuadraticSums& sums, Size picture,
                       const FramePlanesOptions& options, const PinholeCamera& camera) noexcept {
  // Step 1.
  if (solid == 0 || 2 * solid < cells) return PlaneShape::stripe;
  if (!options.reject_curved) return PlaneShape::flat;
  // Step 2.
  QuadraticFit fit;
  if (!fit_quadratic(sums, 0, fit)) return PlaneShape::flat;  // too few cells, or all in a row
  const auto& c = fit.coefficients;
  const double curvature = largest_curvature(c[3], c[4], c[5]) / (scale_of(picture) * scale_of(picture));
  // A sphere or cylinder of radius r has second derivative 1/(r f²) in 1/z, at any distance.
  const double focal_square = camera.fx * camera.fx;
  if (!(curvature * focal_square * largest_radius_m > 1)) return PlaneShape::flat;
  const double noise = options.gate.inverse_noise(sums.right[0] / sums.n);
  const double bend = square_root(fit.bend_squares / sums.n) / noise;
  const double significance = bend * square_root(sums.n / (3 * options.noise_pixels));
  for (const BendLimit& limit : bend_limits) {
    if (bend > limit.bend && significance > limit.significance) return PlaneShape::bent;
  }
  return PlaneShape::flat;
}

}  // namespace straightedge::detail
