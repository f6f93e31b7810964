// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/explain_depth_run.hpp"
#include "straightedge/host/image.hpp"

namespace straightedge::cli {

/// The flat squares of the frame: in the colour of the plane that took them, pale where none did, and
/// crossed out where they know their normal too badly to vote.
Image<Rgb> show_patches(const ExplainDepthRun& run);

struct SpherePicture {
  Image<Rgb> picture;
  std::uint32_t most_votes = 0;  ///< of one cell, which is white
};

/// The most votes of each direction, seen from the middle of the sphere of directions along the optical axis:
/// the normal of a wall ahead is in the middle, that of the floor below. Lambert's azimuthal projection,
/// which keeps areas (the ball's cells have equal ones), to 125 degrees from the axis. Rings mark the
/// peaks from which candidates grew, with the candidates' numbers.
SpherePicture show_sphere(const ExplainDepthRun& run);

/// One row for each candidate: the votes of the direction of its peak over the distance.
Image<Rgb> show_distances(const ExplainDepthRun& run);

/// At most so many rows and rings are shown.
inline constexpr std::size_t shown_planes = 12;

}  // namespace straightedge::cli
