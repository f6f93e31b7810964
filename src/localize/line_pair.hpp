// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "localize/pose_belief.hpp"
#include "localize/wall_map.hpp"

namespace straightedge::localize {

/// A line of the scan and the wall that it may be. With pose (x, y, h), the line's normal angle a and
/// centroid c (robot frame), the wall's normal n, angle b and point m, both errors are zero when all is
/// right:
///
///   angle:   b − a − h                   (modulo pi, the normals may point to opposite sides)
///   offset:  n · ((x, y) + R(h) c − m)
///
/// Derivatives by the pose: (0, 0, −1) and (nx, ny, n · R'(h) c). About its centroid the line's own errors
/// of angle and offset are independent, so its covariance enters as a diagonal. An error of the wall's angle
/// turns it round m: it enters the offset by the lever along the wall, its derivatives are (1, 0) and
/// (lever, −1).
struct LinePair {
  std::uint32_t line = 0;  ///< of the scan
  std::uint32_t wall = 0;
  double angle = 0, offset = 0;          ///< the two errors
  double offset_by_heading = 0;          ///< n · R'(h) c
  double lever = 0;                      ///< from m to the line's centroid, along the wall
  double var_theta = 0, var_offset = 0;  ///< of the scan's line, with the wall's roughness
  Matrix2 s;                             ///< covariance of the two errors
  double chi_square = 0;
};

/// The errors as they are at this pose, without covariance.
LinePair make_pair(const Pose2& pose, const ScanLine& line, std::uint32_t line_index, const WallMap& map,
                   std::uint32_t wall_index);

/// The derivatives by the pose; those by the odometry's faults are zero.
Matrix<2, state_size> by_state(const LinePair& pair, const Wall& wall);
/// The derivatives by the wall's angle and offset.
Matrix<2, 2> by_wall(const LinePair& pair);
/// The covariance that the wall and the scan's line bring in.
Matrix2 own_covariance(const LinePair& pair, const Wall& wall);

/// Fills `s` and `chi_square`. False: no positive covariance.
bool judge_pair(LinePair& pair, const PoseBelief& belief, const Wall& wall);

/// Step 4 of localizer.hpp: the pair, made for the belief's present pose and judged, corrects the belief.
///
///   K = (P Hᵀ + C Jᵀ) S⁻¹,  P ← P − K S Kᵀ,  C_j ← C_j − K (H C_j + [j is this line] J M)
///
/// P: covariance of the pose; C: with this line, C_j: with line j; M: the line's covariance; H, J: the
/// derivatives. The lines themselves are not corrected, only considered (Schmidt's filter).
void correct(PoseBelief& belief, const LinePair& pair, const WallMap& map);

}  // namespace straightedge::localize
