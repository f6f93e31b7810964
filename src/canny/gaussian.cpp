// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/gaussian.hpp"

#include <algorithm>
#include <cstddef>

#include "base/bordered_row.hpp"

namespace straightedge {
namespace {

bool is_kernel(std::span<const std::uint16_t> taps) noexcept {
  if (taps.size() % 2 == 0 || taps.size() > static_cast<std::size_t>(max_gaussian_size)) return false;
  std::uint32_t sum = 0;
  for (const std::uint16_t tap : taps) sum += tap;
  return sum == 256;
}

// Step 3. One row of column sums, for row y of the output.
void sum_columns(GrayView gray, std::int32_t y, std::span<const std::uint16_t> taps, Border border,
                 std::uint16_t* sums) noexcept {
  const auto margin = static_cast<std::int32_t>(taps.size() / 2);
  std::fill_n(sums, gray.width, std::uint16_t{0});
  for (std::size_t k = 0; k < taps.size(); ++k) {
    const std::int32_t source = border_index(y - margin + static_cast<std::int32_t>(k), gray.height, border);
    if (source == border_zero) continue;
    const std::uint8_t* const pixels = gray.row(source);
    const std::uint16_t tap = taps[k];
    for (std::int32_t x = 0; x < gray.width; ++x) {
      sums[x] = static_cast<std::uint16_t>(sums[x] + tap * pixels[x]);
    }
  }
}

// Step 4.
void sum_row(const std::uint16_t* columns, std::span<const std::uint16_t> taps, std::uint32_t* sums,
             std::int32_t width) noexcept {
  std::fill_n(sums, width, std::uint32_t{0});
  for (std::size_t k = 0; k < taps.size(); ++k) {
    const std::uint16_t* const shifted = columns + k;
    const std::uint32_t tap = taps[k];
    for (std::int32_t x = 0; x < width; ++x) sums[x] += tap * shifted[x];
  }
}

// Step 5.
void round_row(const std::uint32_t* sums, std::uint8_t* out, std::int32_t width) noexcept {
  for (std::int32_t x = 0; x < width; ++x) out[x] = static_cast<std::uint8_t>((sums[x] + 32768) >> 16U);
}

}  // namespace

Status gaussian_blur(GrayView gray, std::span<const std::uint16_t> taps, Border border,
                     const GaussianScratch& scratch, ImageView<std::uint8_t> blurred) noexcept {
  if (!gray.valid() || !blurred.valid()) return Status::invalid_image;
  if (gray.size() != blurred.size()) return Status::size_mismatch;
  if (!is_kernel(taps) || !is_border(border)) return Status::invalid_option;
  const auto width = static_cast<std::size_t>(gray.width);
  if (scratch.columns.size() < width + taps.size() - 1 || scratch.sums.size() < width) {
    return Status::workspace_too_small;
  }
  const auto margin = static_cast<std::int32_t>(taps.size() / 2);
  std::uint16_t* const columns = scratch.columns.data();
  std::uint32_t* const sums = scratch.sums.data();
  for (std::int32_t y = 0; y < gray.height; ++y) {
    sum_columns(gray, y, taps, border, columns + margin);
    fill_margins(columns, gray.width, margin, border);
    sum_row(columns, taps, sums, gray.width);
    round_row(sums, blurred.row(y), gray.width);
  }
  return Status::ok;
}

}  // namespace straightedge
