// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "straightedge/depth_cells.hpp"

namespace straightedge {

/// The cells of a frame of 1/z (depth_cells.hpp), with the memory that they are in.
class FrameCells {
 public:
  explicit FrameCells(ImageView<const float> inverse_depth, int finest = 0,
                      const DepthKernels& kernels = plain_depth_kernels) {
    Arena counted = Arena::measure();
    cells_.take(counted, inverse_depth.size(), finest);
    memory_.resize(counted.used());
    Arena arena(memory_);
    cells_.take(arena, inverse_depth.size(), finest);
    cells_.build(inverse_depth, kernels);
  }

  const DepthCells& view() const noexcept { return cells_; }

 private:
  std::vector<std::byte> memory_;
  DepthCells cells_;
};

}  // namespace straightedge
