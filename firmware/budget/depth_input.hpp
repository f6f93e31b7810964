// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "straightedge/depth_view.hpp"

namespace firmware {

/// The room of scenes/room.hpp.
straightedge::DepthView room_depth(straightedge::Size size) noexcept;

}  // namespace firmware
