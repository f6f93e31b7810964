// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "map/wall_line.hpp"
#include "straightedge/gradient_view.hpp"
#include "straightedge/hough_options.hpp"

namespace straightedge {

/// Segments of the Hough transform as edges, without a refit: each goes from end to end, which are taken to
/// be within a pixel of the edge; the gradients there say which side is light. Shorter ones than `min_length`
/// are left out.
std::vector<WallLine> coarse_lines(std::span<const HoughSegment> rough, GradientView gradients,
                                   double min_length);

}  // namespace straightedge
