// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "straightedge/detail/canny_workspace.hpp"
#include "straightedge/gaussian.hpp"
#include "straightedge/hysteresis.hpp"
#include "straightedge/image.hpp"
#include "straightedge/magnitude.hpp"
#include "straightedge/sobel.hpp"
#include "straightedge/status.hpp"
#include "straightedge/suppress.hpp"
#include "straightedge/thresholds.hpp"

/// Canny's edge detector: thin, closed curves where the gray value changes most.
///
/// Steps, each a function of its own that can be called and looked at alone
///   1. Blur by a Gaussian, border reflect-101 (gaussian.hpp).
///   2. Gradient by Sobel, border replicate; side 7 in sixteenths (sobel.hpp).
///   3. Magnitude of the gradient (magnitude.hpp).
///   4. Thresholds, from the options or from the image (thresholds.hpp).
///   5. Suppress what is no maximum across the edge; divide into weak and strong (suppress.hpp).
///   6. Hysteresis: weak edges stay where they hang together with strong ones (hysteresis.hpp).
///
/// J. Canny, "A Computational Approach to Edge Detection", IEEE TPAMI 8(6), 1986,
/// doi:10.1109/TPAMI.1986.4767851.
///
/// Integers from the first step to the last: the same bits on every machine. With sigma 0 equal to OpenCV
/// 4.6.0's Canny bit for bit; with a sigma, to its GaussianBlur (automatic size) followed by Canny.
///
/// Deliberate differences from OpenCV
///   - low > high is `invalid_option`; OpenCV swaps them. NaN is `invalid_option`; there it is undefined.
///   - Thresholds beyond 32 bits (infinity too) are above every edge; there, with L1, they wrap round and
///     let everything pass. Negative ones act like 0, in both.
///   - One channel. OpenCV takes the channel with the largest gradient; here colour becomes gray first
///     (gray.hpp).
///   - No aperture −1 (Scharr).
///
/// Time linear in pixels, whatever is in the image. Memory 14 bytes a pixel, all in the workspace.
namespace straightedge {

enum class CannyThresholds : std::uint8_t {
  given,      ///< `low` and `high` as they stand
  automatic,  ///< from the noise in the image (thresholds.hpp); `low` and `high` are not looked at
};

struct CannyOptions {
  double sigma = 1.4;  ///< Gaussian blur before the gradient, pixels, 0 to 50; 0 = none
  int aperture = 3;    ///< side of the Sobel operator: 3, 5 or 7
  GradientNorm norm = GradientNorm::l1;
  CannyThresholds thresholds = CannyThresholds::given;
  double low = 50;    ///< weak edges are above it; units of the norm of the unscaled gradient; low <= high
  double high = 150;  ///< strong edges are above it
};

struct CannyResult {
  Status status = Status::not_prepared;
  double low = 0;  ///< the thresholds that were used
  double high = 0;
  std::uint32_t strong = 0;  ///< pixels above `high` after suppression, the seeds of the flood fill
  std::uint32_t edges = 0;   ///< pixels set in the output
};

/// `prepare` once for a size and options, `run` many times. The workspace is the caller's and must outlive
/// the object; copies of the object share it, so only one of them may run at a time.
class Canny {
 public:
  /// Bytes that `prepare` needs; 0 when size or options are invalid. Usable in constant expressions.
  static constexpr std::size_t workspace_bytes(Size size, const CannyOptions& options) noexcept {
    if (check(size, options) != Status::ok) return 0;
    Arena arena = Arena::measure();
    detail::CannyWorkspace::take(arena, size, gaussian_size(options.sigma), options.aperture);
    return arena.used();
  }

  /// `invalid_image` (size), `invalid_option`, `too_large` (2^31 pixels or more) or `workspace_too_small`
  /// leave `canny` unprepared.
  static Status prepare(Canny& canny, Size size, const CannyOptions& options,
                        std::span<std::byte> workspace) noexcept;

  /// `edges`: 255 on edges, 0 elsewhere; it may be the same memory as `gray`. Both views have the prepared
  /// size. Errors, with `edges` untouched: `not_prepared`, `invalid_image`, `size_mismatch`; `cancelled`
  /// when the trace asked to stop.
  CannyResult run(GrayView gray, ImageView<std::uint8_t> edges, HysteresisTrace trace = {}) noexcept;

  // What the stages left behind, readable until the next `run`; empty views before the first `prepare`.
  GrayView blurred() const noexcept { return {memory_.blurred.data(), size_}; }
  /// Right minus left.
  ImageView<const std::int16_t> gradient_x() const noexcept { return {memory_.dx.data(), size_}; }
  /// Below minus above.
  ImageView<const std::int16_t> gradient_y() const noexcept { return {memory_.dy.data(), size_}; }
  /// L1, or the square of L2; of sixteenths for aperture 7.
  ImageView<const std::int32_t> magnitude() const noexcept { return {memory_.magnitude.data(), size_}; }
  /// 0 no edge, 1 weak, 2 strong.
  GrayView suppressed() const noexcept { return {memory_.classes.data(), size_}; }

  /// What `prepare` says about size and options.
  static constexpr Status check(Size size, const CannyOptions& options) noexcept {
    if (size.width < 1 || size.height < 1) return Status::invalid_image;
    const bool norm_known = options.norm == GradientNorm::l1 || options.norm == GradientNorm::l2;
    const bool automatic = options.thresholds == CannyThresholds::automatic;
    if (!automatic && options.thresholds != CannyThresholds::given) return Status::invalid_option;
    if (!automatic && !is_valid(Thresholds{options.low, options.high})) return Status::invalid_option;
    if (gaussian_size(options.sigma) == 0 || !is_sobel_aperture(options.aperture) || !norm_known) {
      return Status::invalid_option;
    }
    const auto pixels = static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height);
    return pixels > detail::max_canny_pixels ? Status::too_large : Status::ok;
  }

 private:
  bool prepared_ = false;
  Size size_;
  CannyOptions options_;
  detail::CannyWorkspace memory_;
};

}  // namespace straightedge
