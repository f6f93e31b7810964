// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/gray.hpp"

#include <cstring>

namespace straightedge {
namespace {

constexpr std::uint32_t red_weight = 9798;
constexpr std::uint32_t green_weight = 19235;
constexpr std::uint32_t blue_weight = 3735;
static_assert(red_weight + green_weight + blue_weight == 1U << 15U);

// Step 1. The first and third byte's weights depend on the order of the channels.
void gray_row(const std::uint8_t* color, std::int32_t step, std::uint32_t first, std::uint32_t third,
              std::uint8_t* gray, std::int32_t width) noexcept {
  for (std::int32_t x = 0; x < width; ++x) {
    const std::uint32_t sum = first * color[0] + green_weight * color[1] + third * color[2];
    gray[x] = static_cast<std::uint8_t>((sum + (1U << 14U)) >> 15U);
    color += step;
  }
}

}  // namespace

Status gray_from_color(ColorView color, ImageView<std::uint8_t> gray) noexcept {
  if (!color.valid() || !gray.valid()) return Status::invalid_image;
  if (color.size() != gray.size()) return Status::size_mismatch;
  const bool red_first = color.format == PixelFormat::rgb || color.format == PixelFormat::rgba;
  const std::uint32_t first = red_first ? red_weight : blue_weight;
  const std::uint32_t third = red_first ? blue_weight : red_weight;
  for (std::int32_t y = 0; y < gray.height; ++y) {
    // Step 2.
    if (color.format == PixelFormat::gray) {
      std::memcpy(gray.row(y), color.row(y), static_cast<std::size_t>(gray.width));
    } else {
      gray_row(color.row(y), channels(color.format), first, third, gray.row(y), gray.width);
    }
  }
  return Status::ok;
}

}  // namespace straightedge
