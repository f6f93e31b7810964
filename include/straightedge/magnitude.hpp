// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/image.hpp"
#include "straightedge/status.hpp"

namespace straightedge {

/// How long a gradient is.
enum class GradientNorm : std::uint8_t {
  l1,  ///< |dx| + |dy|: cheap, and up to 1.41 times too long along the diagonals
  l2,  ///< sqrt(dx² + dy²), compared as squares
};

/// The length of each gradient: |dx| + |dy| for L1, dx² + dy² (no root) for L2.
///
/// Sobel values inside Canny stay below 12 240, so squares stay below 2^28.2. Gradients from elsewhere may
/// be any 16-bit numbers: the one sum that leaves 31 bits, (−32768)² + (−32768)², becomes 2^31 − 1.
///
/// Errors, with `magnitude` untouched: `invalid_image`, `size_mismatch`, `invalid_option` (norm).
Status gradient_magnitude(ImageView<const std::int16_t> dx, ImageView<const std::int16_t> dy,
                          GradientNorm norm, ImageView<std::int32_t> magnitude) noexcept;

}  // namespace straightedge
