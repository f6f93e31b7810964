// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "map/line_sampler.hpp"
#include "map/wall_line.hpp"

namespace straightedge {

/// Makes axes of faces that have a thin wall behind them, though its other edge was not found (too ragged,
/// too short). Otherwise the map would have the wall's face in one place and its axis in the next.
///
/// 1. Along the face, the darkness behind it: its sum is the width, its centre of mass the axis.
/// 2. The wall is thin there when the width is at most `max_width` and it is light again behind it.
/// 3. Thin along most of the face: the face moves to the mean centre.
/// `picture` is the stretched one. Returns how many faces became axes.
std::uint32_t turn_strokes_to_axes(std::vector<WallLine>& lines, const LineSampler& picture,
                                   double max_width);

}  // namespace straightedge
