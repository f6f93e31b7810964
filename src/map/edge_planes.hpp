// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "straightedge/canny.hpp"
#include "straightedge/edge_position.hpp"
#include "straightedge/host/image.hpp"
#include "straightedge/host/kernels.hpp"

namespace straightedge {

/// What Canny leaves behind: edges, and of the stages before them those that a line map reads again.
class EdgePlanes {
 public:
  Image<std::uint8_t> pixels;  ///< 255 on edges
  GrayView blurred;
  ImageView<const std::int16_t> dx, dy;
  CannyResult result;

  /// The results of canny.hpp, bit for bit. Row by row with the kernels given, with automatic thresholds
  /// stage by stage.
  Status detect(GrayView gray, const CannyOptions& options, const KernelSet& kernels);

  /// As Canny's: |dx| + |dy| or dx² + dy².
  void magnitude(GradientNorm norm, Image<std::int32_t>& out) const;

 private:
  void reserve(std::size_t bytes);
  Status by_rows(GrayView gray, const CannyOptions& options, const CannyRowKernels& kernels);
  Status by_stages(GrayView gray, const CannyOptions& options);

  std::unique_ptr<std::byte[]> memory_;
  std::size_t bytes_ = 0;
};

}  // namespace straightedge
