// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "map/border_chain.hpp"

namespace straightedge {

/// Makes one border of each outer border and the holes in it. Holes are taken from left to right, so that
/// what a hole sees to its left is joined already.
///
/// 1. P is the leftmost point of the hole. Of the edges that have the area to their right side in the
///    picture, find the one that P sees straight to its left.
/// 2. The triangle of P, the point it sees and the left end M of that edge holds no edge, unless corners lie
/// in
///    it: of these and M, take the one nearest in direction to straight left. P sees it.
/// 3. Where several corners lie in that place, take the one whose angle P lies in.
/// 4. Walk there and back: both corners are doubled.
///
/// Holes that see no border are left alone.
void bridge_holes(Borders& borders);

}  // namespace straightedge
