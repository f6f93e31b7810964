// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "map/border_chain.hpp"
#include "map/triangulate.hpp"

namespace straightedge {

/// Cuts the border that the corner is on into triangles; it is used up.
///
/// A corner with its two neighbours is an ear when it turns left and no corner that does not turn left lies
/// in their triangle; such corners are looked up in a grid. Corners wait in a queue. Cutting an ear puts its
/// neighbours back into it, and when it runs empty all that are left are tried again. Corners on straight
/// lines are dropped. Where no ear is left, which borders that cross can bring about, the first corner that
/// turns left is cut.
void clip_ears(Borders& borders, std::uint32_t corner, std::vector<Triangle>& triangles);

}  // namespace straightedge
