// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "plane_surfaces.hpp"

#include <algorithm>

#include "inverse_noise.hpp"

namespace straightedge::detail {
namespace {

// One true pair in a hundred lies further apart (chi-square, 3 degrees of freedom).
constexpr double chi_square_gate = 11.34;
// Two planes that share the cells of one surface part them by the sign of their noise, and so lie about one
// standard deviation apart; real ones so near cannot be told apart. Root mean square over the smaller one.
constexpr double floor_deviations = 1.5;
// Standard deviation of the bend: the radius of a wall in the picture of a common sensor. Half a Kinect's
// picture sags by some three deviations of its noise then.
constexpr double usual_radius_m = 40;

}  // namespace

PlaneSurfaces::PlaneSurfaces(Size picture, const PinholeCamera& camera,
                             const FramePlanesOptions& options) noexcept
    : u0_(picture.width / 2.0),
      v0_(picture.height / 2.0),
      scale_(std::max(picture.width, picture.height) / 2.0),
      focal_square_(camera.fx * camera.fx),
      options_(options) {}

void PlaneSurfaces::sum(const DepthCells& cells, std::span<const std::uint16_t> cell_labels,
                        std::span<QuadraticSums> sums) const noexcept {
  std::fill(sums.begin(), sums.end(), QuadraticSums{});
  const std::span<const InverseDepthMoments> all = cells.level(0);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (cell_labels[i] == 0) continue;
    const InverseDepthMoments& m = all[i];
    sums[cell_labels[i] - 1U].add((m.u / m.n - u0_) / scale_, (m.v / m.n - v0_) / scale_, m.q / m.n, m.n);
  }
}

double PlaneSurfaces::ridge(double variance) const noexcept {
  // A radius r is a second derivative 1/(r f²) per pixel², twice the coefficient per scaled unit².
  const double usual = scale_ * scale_ / (2 * usual_radius_m * focal_square_);
  return variance * options_.noise_pixels / (usual * usual);
}

bool PlaneSurfaces::fit(const QuadraticSums& sums, BentPlane& surface, double& squares) const noexcept {
  if (!(sums.n > 0)) return false;
  const double noise = inverse_noise(options_.gate, sums.right[0] / sums.n);
  QuadraticFit found;
  if (!fit_quadratic(sums, ridge(noise * noise), found)) return false;
  const auto& c = found.coefficients;
  const double a = c[1] / scale_, b = c[2] / scale_, square = scale_ * scale_;
  surface = {{a, b, c[0] - a * u0_ - b * v0_}, c[3] / square, c[4] / square, c[5] / square, u0_, v0_};
  squares = found.squares;
  return true;
}

bool PlaneSurfaces::are_one(const QuadraticSums& a, double squares_a, const QuadraticSums& b,
                            double squares_b, BentPlane& surface, double& squares) const noexcept {
  QuadraticSums both = a;
  both.add(b);
  if (!fit(both, surface, squares)) return false;
  const double noise = inverse_noise(options_.gate, both.right[0] / both.n);
  const double cost = (squares - squares_a - squares_b) / (noise * noise);
  const double floor = floor_deviations * floor_deviations * a.n * b.n / both.n;
  return cost < chi_square_gate * options_.noise_pixels + floor;
}

}  // namespace straightedge::detail
