// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/magnitude.hpp"

#include "canny/gradient_norm.hpp"

namespace straightedge {
namespace {

void l1_row(const std::int16_t* dx, const std::int16_t* dy, std::int32_t* out, std::int32_t width) noexcept {
  for (std::int32_t x = 0; x < width; ++x) out[x] = l1_norm(dx[x], dy[x]);
}

void l2_row(const std::int16_t* dx, const std::int16_t* dy, std::int32_t* out, std::int32_t width) noexcept {
  for (std::int32_t x = 0; x < width; ++x) out[x] = l2_norm(dx[x], dy[x]);
}

}  // namespace

Status gradient_magnitude(ImageView<const std::int16_t> dx, ImageView<const std::int16_t> dy,
                          GradientNorm norm, ImageView<std::int32_t> magnitude) noexcept {
  if (!dx.valid() || !dy.valid() || !magnitude.valid()) return Status::invalid_image;
  if (dx.size() != dy.size() || dx.size() != magnitude.size()) return Status::size_mismatch;
  if (norm != GradientNorm::l1 && norm != GradientNorm::l2) return Status::invalid_option;
  const auto measure_row = norm == GradientNorm::l1 ? l1_row : l2_row;
  for (std::int32_t y = 0; y < dx.height; ++y) measure_row(dx.row(y), dy.row(y), magnitude.row(y), dx.width);
  return Status::ok;
}

}  // namespace straightedge
