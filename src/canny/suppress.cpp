// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/suppress.hpp"

namespace straightedge {
namespace {

std::int32_t magnitude_at(ImageView<const std::int32_t> magnitude, std::int32_t x, std::int32_t y) noexcept {
  return magnitude.contains(x, y) ? magnitude.at(x, y) : 0;
}

// Steps 2 and 3.
bool is_crest(ImageView<const std::int32_t> magnitude, std::int32_t x, std::int32_t y, std::int32_t dx,
              std::int32_t dy) noexcept {
  const std::int32_t m = magnitude.at(x, y);
  switch (gradient_sector(dx, dy)) {
    case GradientSector::horizontal:
      return m > magnitude_at(magnitude, x - 1, y) && m >= magnitude_at(magnitude, x + 1, y);
    case GradientSector::vertical:
      return m > magnitude_at(magnitude, x, y - 1) && m >= magnitude_at(magnitude, x, y + 1);
    case GradientSector::falling:
      return m > magnitude_at(magnitude, x - 1, y - 1) && m > magnitude_at(magnitude, x + 1, y + 1);
    case GradientSector::rising:
      return m > magnitude_at(magnitude, x + 1, y - 1) && m > magnitude_at(magnitude, x - 1, y + 1);
  }
  return false;
}

}  // namespace

Status suppress_non_maxima(ImageView<const std::int16_t> dx, ImageView<const std::int16_t> dy,
                           ImageView<const std::int32_t> magnitude, std::int32_t low, std::int32_t high,
                           ImageView<std::uint8_t> classes) noexcept {
  if (!dx.valid() || !dy.valid() || !magnitude.valid() || !classes.valid()) return Status::invalid_image;
  const Size size = magnitude.size();
  if (dx.size() != size || dy.size() != size || classes.size() != size) return Status::size_mismatch;
  if (low > high) return Status::invalid_option;
  for (std::int32_t y = 0; y < size.height; ++y) {
    const std::int32_t* const m = magnitude.row(y);
    std::uint8_t* const out = classes.row(y);
    for (std::int32_t x = 0; x < size.width; ++x) {
      out[x] = no_edge;
      // Step 1.
      if (m[x] <= low) continue;
      if (!is_crest(magnitude, x, y, dx.at(x, y), dy.at(x, y))) continue;
      // Step 4.
      out[x] = m[x] > high ? strong_edge : weak_edge;
    }
  }
  return Status::ok;
}

}  // namespace straightedge
