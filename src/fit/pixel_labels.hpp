// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "straightedge/depth_cells.hpp"
#include "straightedge/depth_kernels.hpp"
#include "straightedge/detail/quadratic_surface.hpp"
#include "straightedge/plane_gate.hpp"

namespace straightedge::detail {

/// Step 7 of frame_planes.hpp: a label for every pixel from those of the smallest cells.
struct PixelLabeller {
  ImageView<const float> inverse_depth;
  const DepthCells& cells;
  std::span<const std::uint16_t> cell_labels;
  std::span<const BentPlane> planes;
  const PlaneGate& gate;
  const DepthKernels& kernels;
  const DepthSurfaces& surfaces;  ///< room for the planes as the cells see them

  /// `moments`: of each plane's cells, multiplied so that n is the number of its pixels. `states`: room for
  /// a row of cells.
  void label(ImageView<std::uint16_t> labels, std::span<InverseDepthMoments> moments,
             std::span<std::uint16_t> states) const noexcept;
};

}  // namespace straightedge::detail
