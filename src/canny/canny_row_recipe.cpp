// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/detail/canny_row_recipe.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>

#include "base/bordered_row.hpp"

namespace straightedge::detail {
namespace {

template <class M>
MagnitudeRows<M> rows_around(const RowRing<M>& magnitude, const CannyRowMemory& memory,
                             std::int32_t y) noexcept {
  // Two further on lies in the slot of the one before: y − 1 would be negative in the first row.
  return {magnitude.row(y + 2), magnitude.row(y), magnitude.row(y + 1), memory.dx.row(y), memory.dy.row(y)};
}

template <class M>
void clear_row(const RowRing<M>& ring, std::int32_t y) noexcept {
  if (!ring.elements.empty()) std::fill_n(ring.row(y) - ring.margin, ring.stride, M{0});
}

}  // namespace

void CannyRowRecipe::prepare(CannyRowRecipe& recipe, Size size, const CannyOptions& options,
                             const CannyRowKernels& kernels, const CannyRowMemory& memory) noexcept {
  recipe.size_ = size;
  recipe.options_ = options;
  recipe.limits_ = to_magnitude({options.low, options.high}, options.norm, options.aperture);
  recipe.kernels_ = &kernels;
  recipe.memory_ = memory;
}

void CannyRowRecipe::begin() noexcept {
  gray_rows_ = blurred_rows_ = gradient_rows_ = class_rows_ = 0;
  strong_ = 0;
  // The margins stay 0, and so does the row above the picture until its slot is needed.
  for (std::int32_t y = 0; y < 3; ++y) clear_magnitude(y);
}

void CannyRowRecipe::push(const std::uint8_t* gray) noexcept {
  const bool blurs = memory_.taps.size() > 1;
  std::uint8_t* const row = blurs ? memory_.gray.row(gray_rows_) : memory_.blurred.row(gray_rows_);
  std::memcpy(row, gray, static_cast<std::size_t>(size_.width));
  ++gray_rows_;
  if (!blurs) finish_blurred_row(row);
}

bool CannyRowRecipe::next(std::uint8_t* classes) noexcept {
  const std::int32_t y = class_rows_;
  if (y == size_.height) return false;
  while (gradient_rows_ < std::min(y + 2, size_.height)) {
    if (!make_gradient_row()) return false;
  }
  // Step 5.
  if (y + 1 == size_.height) clear_magnitude(y + 1);
  if (options_.norm == GradientNorm::l1) {
    strong_ +=
        kernels_->suppress_l1(rows_around(memory_.magnitude_l1, memory_, y), limits_, classes, size_.width);
  } else {
    strong_ +=
        kernels_->suppress_l2(rows_around(memory_.magnitude_l2, memory_, y), limits_, classes, size_.width);
  }
  ++class_rows_;
  return true;
}

// Steps 2 and 3.
bool CannyRowRecipe::make_gradient_row() noexcept {
  const std::int32_t y = gradient_rows_, margin = options_.aperture / 2, last = size_.height - 1;
  while (blurred_rows_ <= std::min(y + margin, last)) {
    if (!make_blurred_row()) return false;
  }
  for (std::int32_t k = 0; k < options_.aperture; ++k) {
    const std::int32_t source = std::clamp<std::int32_t>(y - margin + k, 0, last);
    memory_.sources[static_cast<std::size_t>(k)] = memory_.blurred.row(source);
  }
  const std::uint8_t* const* const rows = memory_.sources.data();
  std::int16_t* const scratch = memory_.sobel_scratch.data();
  std::int16_t* const dx = memory_.dx.row(y);
  std::int16_t* const dy = memory_.dy.row(y);
  if (options_.norm == GradientNorm::l1) {
    std::uint16_t* const magnitude = memory_.magnitude_l1.row(y);
    kernels_->gradient_l1[margin - 1](rows, scratch, dx, dy, magnitude, size_.width);
    magnitude[size_.width] = 0;  // right of the last pixel; a kernel may have written beyond the row
  } else {
    std::uint32_t* const magnitude = memory_.magnitude_l2.row(y);
    kernels_->gradient_l2[margin - 1](rows, scratch, dx, dy, magnitude, size_.width);
    magnitude[size_.width] = 0;
  }
  ++gradient_rows_;
  return true;
}

// Step 1.
bool CannyRowRecipe::make_blurred_row() noexcept {
  const auto taps = static_cast<std::int32_t>(memory_.taps.size());
  const std::int32_t y = blurred_rows_, margin = taps / 2;
  if (taps == 1 || gray_rows_ <= std::min(y + margin, size_.height - 1)) return false;
  for (std::int32_t k = 0; k < taps; ++k) {
    const std::int32_t source = border_index(y - margin + k, size_.height, Border::reflect_101);
    memory_.sources[static_cast<std::size_t>(k)] = memory_.gray.row(source);
  }
  std::uint16_t* const sums = memory_.sums.row(0);
  kernels_->blur_down(memory_.sources.data(), memory_.taps.data(), taps, sums, size_.width);
  fill_margins(sums - margin, size_.width, margin, Border::reflect_101);
  std::uint8_t* const blurred = memory_.blurred.row(y);
  kernels_->blur_along(sums, memory_.taps.data(), taps, blurred, size_.width);
  finish_blurred_row(blurred);
  return true;
}

void CannyRowRecipe::finish_blurred_row(std::uint8_t* row) noexcept {
  const std::int32_t margin = options_.aperture / 2;
  fill_margins(row - margin, size_.width, margin, Border::replicate);
  ++blurred_rows_;
}

void CannyRowRecipe::clear_magnitude(std::int32_t y) noexcept {
  clear_row(memory_.magnitude_l1, y);
  clear_row(memory_.magnitude_l2, y);
}

}  // namespace straightedge::detail
