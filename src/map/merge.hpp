// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "map/picture.hpp"
#include "map/wall_line.hpp"

namespace straightedge {

struct MergeOptions {
  double gate = 9.21;       ///< chi-square, 2 degrees of freedom, 99 %
  double max_angle = 0.07;  ///< radians; long uncertain lines would accept anything
  double max_offset = 1.5;  ///< pixels, at the nearer ends
  double touching = 1.5;    ///< pixels between ends of pieces of one segment
};

/// One segment where several lie on one another.
///
/// 1. Two segments of one kind that overlap or touch and pass the chi-square test become one: their moments
///    are added, which is the fit to the pixels of both.
/// 2. Of two that overlap, nearly parallel and nearly in one place, but fail the test (a bent wall), the
///    shorter one keeps only what the longer one leaves over.
/// Returns how many segments vanished.
std::uint32_t merge_fragments(std::vector<WallLine>& lines, const PictureFacts& picture,
                              const MergeOptions& options);

/// Segments that continue one another on one infinite line (a wall and its door openings): indices into
/// `lines`, longest first. Each group passes the chi-square test as it grows and shares one fit, which is
/// written back to its members.
std::vector<std::vector<std::size_t>> group_collinear(std::vector<WallLine>& lines,
                                                      const PictureFacts& picture,
                                                      const MergeOptions& options);

}  // namespace straightedge
