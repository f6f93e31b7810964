// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "straightedge/image.hpp"
#include "straightedge/status.hpp"

namespace straightedge {

enum class GradientNorm : std::uint8_t {
  l1,  ///< |dx| + |dy|
  l2,  ///< sqrt(dx² + dy²), compared as squares
};

enum class CannyThresholds : std::uint8_t {
  given,      ///< `low` and `high` as they stand
  automatic,  ///< chosen from the image, see below
};

struct CannyOptions {
  double sigma = 1.4;  ///< Gaussian blur before the gradient, pixels; 0 = none; 0..50
  int aperture = 3;    ///< side of the Sobel kernel: 3, 5 or 7
  GradientNorm norm = GradientNorm::l1;
  CannyThresholds thresholds = CannyThresholds::given;
  double low = 50;   ///< weak edges are above it; units of the norm; low <= high
  double high = 150; ///< strong edges are above it
};

struct CannyResult {
  Status status = Status::not_prepared;
  double low = 0;           ///< the thresholds that were used
  double high = 0;
  std::uint32_t strong = 0; ///< pixels above `high` after suppression, the seeds of the flood fill
  std::uint32_t edges = 0;  ///< pixels set in the output
};

class Canny {
 public:
  /// Bytes that `prepare` needs; 0 when size or options are invalid.
  static constexpr std::size_t workspace_bytes(Size size, const CannyOptions& options) noexcept;
  static Status prepare(Canny& canny, Size size, const CannyOptions& options,
                        std::span<std::byte> workspace) noexcept;

  /// `edges`: 255 on edges, 0 elsewhere. Both views have the prepared size.
  CannyResult run(GrayView gray, ImageView<std::uint8_t> edges) noexcept;

  // What the stages left behind, readable until the next `run`.
  GrayView blurred() const noexcept;
  ImageView<const std::int16_t> gradient_x() const noexcept;  ///< right minus left
  ImageView<const std::int16_t> gradient_y() const noexcept;  ///< below minus above
  ImageView<const std::int32_t> magnitude() const noexcept;   ///< L1, or the square of L2
  GrayView suppressed() const noexcept;                       ///< 0 no edge, 1 weak, 2 strong
};

}  // namespace straightedge
