// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "straightedge/image.hpp"

namespace firmware {

/// The plan of scenes/plan.hpp.
straightedge::ImageView<std::uint8_t> plan_picture(straightedge::Size size) noexcept;
/// Its edges, in the same memory.
straightedge::ImageView<std::uint8_t> plan_edges(straightedge::Size size) noexcept;

}  // namespace firmware
