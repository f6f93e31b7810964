// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "map/wall_line.hpp"
#include "straightedge/image.hpp"

namespace straightedge {

/// Joins the pieces of a pale thin wall that noise has torn apart. For neighbours on one line (`groups` of
/// group_collinear), the wall's contrast is averaged over the whole gap between them: noise averages out, a
/// door does not. With most of the contrast of the pieces themselves the gap is wall.
///
/// `blurred` is the picture as Canny saw it. Axes alone: faces are strong enough. A joined piece takes the
/// other's pixels and leaves it without length. Returns how many gaps were bridged.
std::uint32_t bridge_pale_gaps(std::vector<WallLine>& lines,
                               const std::vector<std::vector<std::size_t>>& groups, GrayView blurred);

}  // namespace straightedge
