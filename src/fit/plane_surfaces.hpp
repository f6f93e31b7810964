// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "cell_tables.hpp"
#include "straightedge/depth_cells.hpp"
#include "straightedge/detail/quadratic_surface.hpp"
#include "straightedge/frame_planes.hpp"

namespace straightedge::detail {

/// Samples are taken about the picture's middle, in halves of its width.
constexpr double scale_of(Size picture) noexcept {
  return (picture.width > picture.height ? picture.width : picture.height) / 2.0;
}

/// Step 4 of frame_planes.hpp.
///
/// Real sensors picture a wall slightly bent, so that its halves fit two planes better than one. Each plane
/// therefore is a quadratic surface whose bend is held back by a prior (a ridge): a wall may sag by a few
/// deviations of the noise over the whole picture, and a small face stays flat.
class PlaneSurfaces {
 public:
  PlaneSurfaces(Size picture, const PinholeCamera& camera, const FramePlanesOptions& options) noexcept;

  /// Adds the smallest cells that are fresh to the sums of their planes; they are fresh no more.
  void add_fresh(const DepthCells& cells, std::span<std::uint16_t> cell_labels,
                 std::span<QuadraticSums> sums) const noexcept;
  /// The surface of the sums, in the units of these. False when there are too few cells.
  bool solve(const QuadraticSums& sums, QuadraticFit& found) const noexcept;
  /// The same as a surface of the picture, and its squared residuals.
  bool fit(const QuadraticSums& sums, BentPlane& surface, double& squares) const noexcept;
  /// Whether two planes cannot be one, of which the first has that fit: a quick answer for nearly all.
  bool are_far(const QuadraticSums& a, const QuadraticFit& fit_of_a, const QuadraticSums& b) const noexcept;
  /// Whether two planes, each with its own surface, are one: what it costs, in squared residuals, that both
  /// have one instead. `contacts` are those of the two, looked at only where they matter. The common surface
  /// and its squares are written if they are.
  bool are_one(const QuadraticSums& a, const QuadraticSums& b, double squares_apart, Contacts& contacts,
               BentPlane& surface, double& squares) const noexcept;

 private:
  void add(const DepthCell& cell, QuadraticSums& sums) const noexcept;
  double allowed(const QuadraticSums& a, const QuadraticSums& b, double floor) const noexcept;

  double u0_, v0_, scale_, inverse_scale_;
  double focal_square_;
  const FramePlanesOptions& options_;
};

}  // namespace straightedge::detail
