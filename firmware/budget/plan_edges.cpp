// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "budget/edge_input.hpp"
#include "scenes/plan.hpp"

namespace firmware {

straightedge::ImageView<std::uint8_t> plan_edges(straightedge::Size size) noexcept {
  const straightedge::ImageView<std::uint8_t> view = plan_picture(size);
  draw_plan_edges(view);
  return view;
}

}  // namespace firmware
