// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/sobel.hpp"

#include <algorithm>
#include <cstddef>

#include "base/bordered_row.hpp"
#include "canny/sobel_taps.hpp"

namespace straightedge {
namespace {

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
    add_row(gray.row(source), SobelTaps<Side>::smooth[k], SobelTaps<Side>::difference[k], smoothed,
            differences, gray.width);
  }
  fill_margins(scratch.smoothed.data(), gray.width, margin, border);
  fill_margins(scratch.difference.data(), gray.width, margin, border);
}

template <int Side, GradientScale Scale>
void filter_image(GrayView gray, Border border, const SobelScratch& scratch, ImageView<std::int16_t> dx,
                  ImageView<std::int16_t> dy) noexcept {
  for (std::int32_t y = 0; y < gray.height; ++y) {
    sum_columns<Side>(gray, y, border, scratch);
    sobel_filter_row<Side, Scale>(scratch.smoothed.data(), SobelTaps<Side>::difference, dx.row(y),
                                  gray.width);
    sobel_filter_row<Side, Scale>(scratch.difference.data(), SobelTaps<Side>::smooth, dy.row(y), gray.width);
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
