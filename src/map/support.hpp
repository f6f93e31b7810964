// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "map/picture.hpp"
#include "map/picture_rows.hpp"
#include "map/wall_line.hpp"

namespace straightedge {

struct SupportOptions {
  double min_piece = 10;   ///< pixels; smaller dark pieces are crumbs and support nothing
  double max_gap = 10;     ///< pixels between two supported stretches of one segment
  double min_share = 0.7;  ///< of a segment's length that is supported
};

/// Keeps of each segment what the picture really shows as wall.
///
/// 1. What is dark: below the map's threshold; where the walls of the whole picture are paler than that
///    (a faint or blurred drawing), below half the way from the usual wall to the ground.
/// 2. Connected dark areas that are less than min_piece long are crumbs, such as a robot's map is full of: a
///    dotted line of crumbs is no wall.
/// 3. Along each segment, the stretches with dark area close by. Those with short gaps between them make a
///    segment; ends that lie near the old ones stay where they were measured.
/// 4. In a noisy picture, short segments with few edge pixels are chance.
/// Segments of which too little is supported are left out.
/// `marks` is memory that may be kept from one picture to the next.
std::vector<WallLine> keep_supported(const std::vector<WallLine>& lines, const Picture& picture,
                                     const SupportOptions& options, Image<std::uint8_t>& marks,
                                     const PictureRowKernels& kernels = plain_picture_row_kernels);

}  // namespace straightedge
