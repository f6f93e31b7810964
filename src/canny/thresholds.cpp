// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/thresholds.hpp"

#include <algorithm>
#include <cstddef>

#include "straightedge/rounding.hpp"
#include "straightedge/sobel.hpp"

namespace straightedge {
namespace {

std::int32_t to_magnitude(double threshold, GradientNorm norm, int aperture) noexcept {
  // Step 1.
  if (aperture == 7) threshold /= 16;
  // Step 2.
  if (norm == GradientNorm::l2) {
    threshold = std::min(threshold, 32767.0);
    if (threshold > 0) threshold *= threshold;
  }
  // Step 3.
  return static_cast<std::int32_t>(
      floor_to_integer(std::clamp(threshold, double{INT32_MIN}, double{INT32_MAX})));
}

// How many whole bytes the largest number has; 1 when all are 0.
std::uint32_t significant_bytes(ImageView<const std::int32_t> magnitude) noexcept {
  std::uint32_t bits = 0;
  for (std::int32_t y = 0; y < magnitude.height; ++y) {
    const std::int32_t* const row = magnitude.row(y);
    for (std::int32_t x = 0; x < magnitude.width; ++x) bits |= static_cast<std::uint32_t>(row[x]);
  }
  std::uint32_t bytes = 1;
  while (bytes < 4 && (bits >> (8 * bytes)) != 0) ++bytes;
  return bytes;
}

// The middle value: half of the pixels or more are not above it, and it is the least such. Magnitudes are
// never negative, so bytes from the top sort like numbers: the byte is found in which the middle lies,
// then only pixels that begin with the bytes found so far are counted.
std::int32_t median_of(ImageView<const std::int32_t> magnitude) noexcept {
  const auto pixels =
      static_cast<std::uint64_t>(magnitude.width) * static_cast<std::uint64_t>(magnitude.height);
  auto rank = static_cast<std::uint32_t>((pixels - 1) / 2);
  std::uint64_t found = 0;
  for (std::uint32_t shift = 8 * significant_bytes(magnitude); shift > 0;) {
    const std::uint32_t known = shift;
    shift -= 8;
    std::uint32_t histogram[256] = {};
    for (std::int32_t y = 0; y < magnitude.height; ++y) {
      const std::int32_t* const row = magnitude.row(y);
      for (std::int32_t x = 0; x < magnitude.width; ++x) {
        const std::uint64_t m = static_cast<std::uint32_t>(row[x]);
        if ((m >> known) == found) ++histogram[(m >> shift) & 255U];
      }
    }
    std::uint32_t byte = 0;
    while (rank >= histogram[byte]) rank -= histogram[byte++];
    found = (found << 8U) | byte;
  }
  return static_cast<std::int32_t>(found);
}

// The largest integer whose square is not above n: one bit after another from the top.
std::int64_t integer_root(std::int64_t n) noexcept {
  std::int64_t root = 0;
  for (std::int64_t bit = std::int64_t{1} << 20; bit > 0; bit >>= 1) {
    if ((root + bit) * (root + bit) <= n) root += bit;
  }
  return root;
}

// The gradient of a bare step of one gray level.
std::int64_t step_response(int aperture) noexcept {
  if (aperture == 3) return 4;
  return aperture == 5 ? 48 : 640;
}

}  // namespace

MagnitudeThresholds to_magnitude(const Thresholds& given, GradientNorm norm, int aperture) noexcept {
  return {to_magnitude(given.low, norm, aperture), to_magnitude(given.high, norm, aperture)};
}

AutomaticThresholds automatic_thresholds(ImageView<const std::int32_t> magnitude, GradientNorm norm,
                                         int aperture) noexcept {
  if (!magnitude.valid()) return {Status::invalid_image};
  const auto pixels =
      static_cast<std::uint64_t>(magnitude.width) * static_cast<std::uint64_t>(magnitude.height);
  if (pixels > UINT32_MAX) return {Status::too_large};
  const bool norm_known = norm == GradientNorm::l1 || norm == GradientNorm::l2;
  if (!norm_known || !is_sobel_aperture(aperture)) return {Status::invalid_option};

  // Step 1.
  const std::int32_t median = median_of(magnitude);

  // Step 2. 4.5 times a root is the root of 20.25 times its square.
  const std::int64_t scale = aperture == 7 ? 16 : 1;
  const std::int64_t medians =
      norm == GradientNorm::l1 ? std::int64_t{median} * 9 / 2 : integer_root(std::int64_t{median} * 81 / 4);
  const std::int64_t high = std::max(medians * scale, 8 * step_response(aperture));

  // Step 3.
  const std::int64_t low = high * 2 / 5;
  return {Status::ok, {static_cast<double>(low), static_cast<double>(high)}, median};
}

}  // namespace straightedge
