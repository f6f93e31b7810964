// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/sobel.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "base/bordered_row.hpp"

namespace straightedge {
namespace {

template <int Side>
struct Taps;
template <>
struct Taps<3> {
  static constexpr int smooth[] = {1, 2, 1};
  static constexpr int difference[] = {-1, 0, 1};
};
template <>
struct Taps<5> {
  static constexpr int smooth[] = {1, 4, 6, 4, 1};
  static constexpr int difference[] = {-1, -2, 0, 2, 1};
};
template <>
struct Taps<7> {
  static constexpr int smooth[] = {1, 6, 15, 20, 15, 6, 1};
  static constexpr int difference[] = {-1, -4, -5, 0, 5, 4, 1};
};

// Step 1, one row of the image times its two taps. At most 64 * 255 in all: fits 16 bits.
void add_row(const std::uint8_t* pixels, int smooth, int difference, std::int16_t* smoothed,
             std::int16_t* differences, std::int32_t width) noexcept {
  for (std::int32_t x = 0; x < width; ++x) {
    smoothed[x] = static_cast<std::int16_t>(smoothed[x] + smooth * pixels[x]);
    differences[x] = static_cast<std::int16_t>(differences[x] + difference * pixels[x]);
  }
}

// Step 1.
template <int Side>
void sum_columns(GrayView gray, std::int32_t y, Border border, const SobelScratch& scratch) noexcept {
  constexpr std::int32_t margin = Side / 2;
  std::int16_t* const smoothed = scratch.smoothed.data() + margin;
  std::int16_t* const differences = scratch.difference.data() + margin;
  std::fill_n(smoothed, gray.width, std::int16_t{0});
  std::fill_n(differences, gray.width, std::int16_t{0});
  for (int k = 0; k < Side; ++k) {
    const std::int32_t source = border_index(y - margin + k, gray.height, border);
    if (source == border_zero) continue;
    add_row(gray.row(source), Taps<Side>::smooth[k], Taps<Side>::difference[k], smoothed, differences,
            gray.width);
  }
  fill_margins(scratch.smoothed.data(), gray.width, margin, border);
  fill_margins(scratch.difference.data(), gray.width, margin, border);
}

// Step 3. Adding 7, and one more where the quotient is odd, before the shift rounds halves to even.
template <GradientScale Scale>
std::int16_t to_16_bits(std::int32_t value) noexcept {
  if constexpr (Scale == GradientScale::sixteenth) value = (value + 7 + ((value >> 4) & 1)) >> 4;
  return static_cast<std::int16_t>(std::clamp<std::int32_t>(value, INT16_MIN, INT16_MAX));
}

// Step 2, one pixel. Written out by the compiler for each side, so that pixels can be computed side by side.
template <int Side, std::size_t... K>
std::int32_t weighted_sum(const std::int16_t* sums, const int (&taps)[Side],
                          std::index_sequence<K...>) noexcept {
  return ((taps[K] * sums[K]) + ...);
}

// Steps 2 and 3.
template <int Side, GradientScale Scale>
void filter_row(const std::int16_t* sums, const int (&taps)[Side], std::int16_t* out,
                std::int32_t width) noexcept {
  for (std::int32_t x = 0; x < width; ++x) {
    out[x] = to_16_bits<Scale>(weighted_sum(sums + x, taps, std::make_index_sequence<Side>()));
  }
}

template <int Side, GradientScale Scale>
void filter_image(GrayView gray, Border border, const SobelScratch& scratch, ImageView<std::int16_t> dx,
                  ImageView<std::int16_t> dy) noexcept {
  for (std::int32_t y = 0; y < gray.height; ++y) {
    sum_columns<Side>(gray, y, border, scratch);
    filter_row<Side, Scale>(scratch.smoothed.data(), Taps<Side>::difference, dx.row(y), gray.width);
    filter_row<Side, Scale>(scratch.difference.data(), Taps<Side>::smooth, dy.row(y), gray.width);
  }
}

template <GradientScale Scale>
void filter_image(GrayView gray, int aperture, Border border, const SobelScratch& scratch,
                  ImageView<std::int16_t> dx, ImageView<std::int16_t> dy) noexcept {
  if (aperture == 3) filter_image<3, Scale>(gray, border, scratch, dx, dy);
  if (aperture == 5) filter_image<5, Scale>(gray, border, scratch, dx, dy);
  if (aperture == 7) filter_image<7, Scale>(gray, border, scratch, dx, dy);
}

}  // namespace

Status sobel(GrayView gray, int aperture, Border border, GradientScale scale, const SobelScratch& scratch,
             ImageView<std::int16_t> dx, ImageView<std::int16_t> dy) noexcept {
  if (!gray.valid() || !dx.valid() || !dy.valid()) return Status::invalid_image;
  if (gray.size() != dx.size() || gray.size() != dy.size()) return Status::size_mismatch;
  if (!is_sobel_aperture(aperture) || !is_border(border)) return Status::invalid_option;
  const std::size_t length = static_cast<std::size_t>(gray.width) + static_cast<std::size_t>(aperture - 1);
  if (scratch.smoothed.size() < length || scratch.difference.size() < length) {
    return Status::workspace_too_small;
  }
  switch (scale) {
    case GradientScale::clamp:
      filter_image<GradientScale::clamp>(gray, aperture, border, scratch, dx, dy);
      return Status::ok;
    case GradientScale::sixteenth:
      filter_image<GradientScale::sixteenth>(gray, aperture, border, scratch, dx, dy);
      return Status::ok;
  }
  return Status::invalid_option;
}

}  // namespace straightedge
