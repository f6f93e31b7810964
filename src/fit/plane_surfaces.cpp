// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "plane_surfaces.hpp"

#include <algorithm>

#include "cell_labels.hpp"
#include "four_labels.hpp"
#include "label_squares.hpp"

namespace straightedge::detail {
namespace {

// One true pair in a hundred lies further apart (chi-square, 3 degrees of freedom).
constexpr double chi_square_gate = 11.34;
// Nor are planes told apart that lie nearer than this in deviations of the noise, root mean square over the
// smaller one: two planes that share the cells of one surface part them by the sign of their noise. Where
// their cells alternate all over (so many contacts a cell of the smaller one) it takes more; planes that do
// not touch part no surface.
constexpr double floor_when_apart = 0.5;
constexpr double floor_when_touching = 1.5;
constexpr double floor_when_mixed = 2.5;
constexpr double contacts_of_mixed = 0.25;
// So many times the cost that would be allowed leaves no doubt, though bends are held back.
constexpr double surely = 2;
// Standard deviation of the bend: the radius of a wall in the picture of a common sensor. Half a Kinect's
// picture sags by some three deviations of its noise then.
constexpr double usual_radius_m = 40;

constexpr std::uint16_t fresh = CellLabeller::fresh;

/// Readings and means of a cell, and of the one to the right of it if that counts: once or not at all.
DepthCell mean_of(const DepthCell& a, const DepthCell& b, std::uint8_t times) noexcept {
  const float more = b.n * static_cast<float>(times), n = a.n + more, share = more / n;
  return {n, a.u + share * (b.u - a.u), a.v + share * (b.v - a.v), a.q + share * (b.q - a.q)};
}

}  // namespace

PlaneSurfaces::PlaneSurfaces(Size picture, const PinholeCamera& camera,
                             const FramePlanesOptions& options) noexcept
    : u0_(picture.width / 2.0),
      v0_(picture.height / 2.0),
      scale_(scale_of(picture)),
      inverse_scale_(1 / scale_),
      focal_square_(camera.fx * camera.fx),
      options_(options) {}

void PlaneSurfaces::add(const DepthCell& cell, QuadraticSums& sums) const noexcept {
  sums.add(static_cast<double>(cell.u) * inverse_scale_, static_cast<double>(cell.v) * inverse_scale_,
           static_cast<double>(cell.q), static_cast<double>(cell.n));
}

void PlaneSurfaces::add_fresh(const DepthCells& cells, std::span<std::uint16_t> cell_labels,
                              std::span<QuadraticSums> sums) const noexcept {
  // What counts as one has to touch: as one piece it may be taken off the sums again.
  LabelSquares squares(cells, {cell_labels.data(), cells.size(cells.finest())}, fresh, true);
  squares.for_each([&](const LabelSquare& square) noexcept {
    const DepthCell left = cells.at(square.level, square.place),
                    right = cells.at(square.level, square.place + square.second);
    const auto label = static_cast<std::uint16_t>(square.label & ~fresh);
    add(mean_of(left, right, square.second), sums[label - 1U]);
  });
  clear_bits(cell_labels, fresh);
}

bool PlaneSurfaces::solve(const QuadraticSums& sums, QuadraticFit& found) const noexcept {
  if (!(sums.n > 0)) return false;
  const double noise = options_.gate.inverse_noise(sums.right[0] / sums.n);
  // A radius r is a second derivative 1/(r f²) per pixel², twice the coefficient per scaled unit².
  const double usual = scale_ * scale_ / (2 * usual_radius_m * focal_square_);
  return fit_quadratic(sums, noise * noise * options_.noise_pixels / (usual * usual), found);
}

bool PlaneSurfaces::fit(const QuadraticSums& sums, BentPlane& surface, double& squares) const noexcept {
  QuadraticFit found;
  if (!solve(sums, found)) return false;
  const auto& c = found.coefficients;
  const double a = c[1] / scale_, b = c[2] / scale_, square = scale_ * scale_;
  surface = {{a, b, c[0] - a * u0_ - b * v0_}, c[3] / square, c[4] / square, c[5] / square, u0_, v0_};
  squares = found.squares;
  return true;
}

double PlaneSurfaces::allowed(const QuadraticSums& a, const QuadraticSums& b, double floor) const noexcept {
  const double n = a.n + b.n, noise = options_.gate.inverse_noise((a.right[0] + b.right[0]) / n);
  return noise * noise * (chi_square_gate * options_.noise_pixels + floor * floor * a.n * b.n / n);
}

bool PlaneSurfaces::are_far(const QuadraticSums& a, const QuadraticFit& fit_of_a,
                            const QuadraticSums& b) const noexcept {
  return least_cost(fit_of_a, b) > surely * allowed(a, b, floor_when_mixed);
}

bool PlaneSurfaces::are_one(const QuadraticSums& a, const QuadraticSums& b, double squares_apart,
                            Contacts& contacts, BentPlane& surface, double& squares) const noexcept {
  QuadraticSums both = a;
  both.add(b);
  BentPlane common;
  double squares_of_both = 0;
  if (!fit(both, common, squares_of_both)) return false;
  const double cost = squares_of_both - squares_apart;
  if (!(cost < allowed(a, b, floor_when_mixed))) return false;
  const double cells = std::min(a.n, b.n) / (options_.cell * options_.cell);
  const std::uint32_t touching = contacts.of(contacts.i, contacts.j);
  const bool mixed_up = touching >= contacts_of_mixed * cells;
  const double floor = mixed_up ? floor_when_mixed : touching > 0 ? floor_when_touching : floor_when_apart;
  if (!(cost < allowed(a, b, floor))) return false;
  surface = common;
  squares = squares_of_both;
  return true;
}

}  // namespace straightedge::detail
