// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "budget/case.hpp"
#include "budget/edge_input.hpp"
#include "scenes/plan.hpp"

namespace firmware {
namespace {

[[gnu::section(".big.picture")]] std::array<std::uint8_t, most_pixels> picture;

}  // namespace

straightedge::ImageView<std::uint8_t> plan_picture(straightedge::Size size) noexcept {
  const straightedge::ImageView<std::uint8_t> view(picture.data(), size);
  draw_plan(view);
  return view;
}

}  // namespace firmware
