// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/magnitude.hpp"

#include "canny/magnitude_row.hpp"

namespace straightedge {
Status gradient_magnitude(ImageView<const std::int16_t> dx, ImageView<const std::int16_t> dy,
                          GradientNorm norm, ImageView<std::int32_t> magnitude) noexcept {
  if (!dx.valid() || !dy.valid() || !magnitude.valid()) return Status::invalid_image;
  if (dx.size() != dy.size() || dx.size() != magnitude.size()) return Status::size_mismatch;
  if (norm != GradientNorm::l1 && norm != GradientNorm::l2) return Status::invalid_option;
  const auto measure_row = norm == GradientNorm::l1 ? l1_row<std::int32_t> : l2_row<std::int32_t>;
  for (std::int32_t y = 0; y < dx.height; ++y) measure_row(dx.row(y), dy.row(y), magnitude.row(y), dx.width);
  return Status::ok;
}

}  // namespace straightedge
