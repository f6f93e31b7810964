// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "plane_surfaces.hpp"

#include <algorithm>
#include <array>

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

void PlaneSurfaces::add(const InverseDepthMoments& cell, QuadraticSums& sums) const noexcept {
  sums.add((cell.u / cell.n - u0_) / scale_, (cell.v / cell.n - v0_) / scale_, cell.q / cell.n, cell.n);
}

void PlaneSurfaces::sum(const DepthCells& cells, std::span<const std::uint16_t> cell_labels,
                        std::span<QuadraticSums> sums) const noexcept {
  std::fill(sums.begin(), sums.end(), QuadraticSums{});
  const Size fine = cells.size(0), coarse = cells.size(1);
  for (std::int32_t y = 0; y < coarse.height; ++y) {
    for (std::int32_t x = 0; x < coarse.width; ++x) {
      // Four cells of one plane count as one: there are far fewer of those.
      std::array<std::size_t, 4> place{};
      std::size_t count = 0;
      for (std::int32_t j = 2 * y; j < std::min(2 * y + 2, fine.height); ++j) {
        for (std::int32_t i = 2 * x; i < std::min(2 * x + 2, fine.width); ++i) {
          place[count++] = static_cast<std::size_t>(j) * static_cast<std::size_t>(fine.width) +
                           static_cast<std::size_t>(i);
        }
      }
      const std::uint16_t first = cell_labels[place[0]];
      bool same = true;
      for (std::size_t k = 1; k < count; ++k) same = same && cell_labels[place[k]] == first;
      if (same && first != 0) {
        add(cells.level(1)[static_cast<std::size_t>(y) * static_cast<std::size_t>(coarse.width) +
                           static_cast<std::size_t>(x)],
            sums[first - 1U]);
        continue;
      }
      for (std::size_t k = 0; k < count; ++k) {
        const std::uint16_t label = cell_labels[place[k]];
        if (label != 0) add(cells.level(0)[place[k]], sums[label - 1U]);
      }
    }
  }
}

bool PlaneSurfaces::fit(const QuadraticSums& sums, QuadraticFit& fit) const noexcept {
  if (!(sums.n > 0)) return false;
  const double noise = options_.gate.inverse_noise(sums.right[0] / sums.n);
  // A radius r is a second derivative 1/(r f²) per pixel², twice the coefficient per scaled unit².
  const double usual = scale_ * scale_ / (2 * usual_radius_m * focal_square_);
  return fit_quadratic(sums, noise * noise * options_.noise_pixels / (usual * usual), fit);
}

bool PlaneSurfaces::fit(const QuadraticSums& sums, BentPlane& surface) const noexcept {
  QuadraticFit found;
  if (!fit(sums, found)) return false;
  const auto& c = found.coefficients;
  const double a = c[1] / scale_, b = c[2] / scale_, square = scale_ * scale_;
  surface = {{a, b, c[0] - a * u0_ - b * v0_}, c[3] / square, c[4] / square, c[5] / square, u0_, v0_};
  return true;
}

bool PlaneSurfaces::are_one(const QuadraticSums& a, const QuadraticSums& b, std::uint32_t touching,
                            BentPlane& surface) const noexcept {
  QuadraticSums both = a;
  both.add(b);
  QuadraticFit fit_a, fit_b, fit_both;
  if (!fit(a, fit_a) || !fit(b, fit_b) || !fit(both, fit_both)) return false;
  const double noise = options_.gate.inverse_noise(both.right[0] / both.n);
  const double cost = (fit_both.squares - fit_a.squares - fit_b.squares) / (noise * noise);
  const double cells = std::min(a.n, b.n) / (DepthCells::side * DepthCells::side);
  const bool mixed = touching >= contacts_of_mixed * cells;
  const double floor = mixed ? floor_when_mixed : touching > 0 ? floor_when_touching : floor_when_apart;
  return cost < chi_square_gate * options_.noise_pixels + floor * floor * a.n * b.n / both.n &&
         fit(both, surface);
}

}  // namespace straightedge::detail
