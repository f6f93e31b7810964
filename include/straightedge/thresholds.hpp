// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/image.hpp"
#include "straightedge/magnitude.hpp"
#include "straightedge/status.hpp"

/// The two thresholds of Canny: from numbers to the magnitude's units, and from the image itself.
namespace straightedge {

/// Thresholds as a person gives them: units of the gradient of an unscaled Sobel operator.
struct Thresholds {
  double low = 0;
  double high = 0;
};

/// Thresholds as magnitudes are compared with them: `m > low`, `m > high`.
struct MagnitudeThresholds {
  std::int32_t low = 0;
  std::int32_t high = 0;
};

/// True unless one is NaN or low > high. Negative numbers act like 0, infinity is above everything.
constexpr bool is_valid(const Thresholds& given) noexcept {
  return given.low <= given.high;
}

/// Steps
///   1. Side 7 is kept as sixteenths, so its thresholds are divided by 16.
///   2. L2 compares squares: cut at 32767 and square.
///   3. Magnitudes are whole numbers, so the fraction below does not count: floor.
/// Needs `is_valid`. Values beyond 32 bits are cut to them.
MagnitudeThresholds to_magnitude(const Thresholds& given, GradientNorm norm, int aperture) noexcept;

struct AutomaticThresholds {
  Status status = Status::ok;
  Thresholds thresholds = {};
  std::int32_t median = 0;  ///< the middle magnitude of the image, in the magnitude's own units
};

/// Thresholds from the noise in the image.
///
/// Most pixels of most pictures lie on no edge, so the middle value of all gradient magnitudes tells how
/// long a gradient is that only noise or texture makes. For noise in dx and dy of deviation s the length
/// has a Rayleigh distribution: median 1.18 s, and beyond t with probability exp(−t² / 2 s²). A seed of
/// the flood fill must not be chance anywhere in the image: for a million pixels that asks for t = 5.3 s,
/// 4.5 medians. Weak pixels only need to continue an edge: 0.4 of that, the ratio Canny found best lies
/// between 1/2 and 1/3.
///
/// Steps
///   1. The exact median of the magnitudes, by counting one byte after another from the top.
///   2. high = 4.5 medians, but not below what a bare step of 8 gray levels gives (32, 384 or 5120 for
///      side 3, 5, 7), because a drawing has no noise at all, and rounding and JPEG are not edges.
///   3. low = 0.4 high.
///
/// Where edges fill more than half of the image the median is an edge's and the thresholds come out high;
/// give them by hand then. J. Canny 1986, doi:10.1109/TPAMI.1986.4767851, section VIII; noise from the
/// gradient's distribution: H. Voorhees and T. Poggio, "Detecting textons and texture boundaries in natural
/// images", ICCV 1987.
///
/// Integers only, so the same on every machine. Time linear in pixels (at most four passes); no memory but
/// 1 KB of the stack. Errors: `invalid_image`, `invalid_option`, `too_large` (2^32 pixels or more).
AutomaticThresholds automatic_thresholds(ImageView<const std::int32_t> magnitude, GradientNorm norm,
                                         int aperture) noexcept;

}  // namespace straightedge
