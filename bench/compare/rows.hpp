// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "straightedge/image.hpp"

namespace compare {

/// Canny with both norms, and blur with Canny, once for each set of kernels.
void print_edge_rows(straightedge::Size size, int rounds);
/// The progressive Hough transform on the photos' edges; the same with a gradient window, and the whole way
/// to a line map, on a floor plan; once for each set of kernels.
void print_line_rows(straightedge::Size size, int rounds);

}  // namespace compare
