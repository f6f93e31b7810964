// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "budget/case.hpp"
#include "budget/depth_input.hpp"
#include "scenes/room.hpp"

namespace firmware {
namespace {

[[gnu::section(".big.depth")]] std::array<std::uint16_t, most_pixels> depth;

}  // namespace

straightedge::DepthView room_depth(straightedge::Size size) noexcept {
  const straightedge::ImageView<std::uint16_t> raw(depth.data(), size);
  draw_room(raw);
  return {.raw = raw, .metres_per_unit = 0.001, .camera = kinect(size)};
}

}  // namespace firmware
