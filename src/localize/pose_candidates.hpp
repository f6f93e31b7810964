// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "localize/scan_fit.hpp"
#include "localize/wall_map.hpp"
#include "straightedge/host/localizer.hpp"

namespace straightedge::localize {

/// The faces of all walls by the direction of their normal, so that those of one direction are found at once.
class WallFaces {
 public:
  explicit WallFaces(const WallMap& map);

  struct Face {
    double theta = 0, nx = 1, ny = 0;  ///< the normal points to the floor
    std::uint32_t wall = 0;
  };
  std::span<const Face> all() const { return faces_; }

  /// Calls visit(face) for all faces whose direction is within the tolerance.
  template <class Visit>
  void near(double theta, double tolerance, const Visit& visit) const;

 private:
  std::vector<Face> faces_;  // by theta
};

struct CandidatePose {
  Pose2 pose;
  double log_likelihood = 0;
};

/// Places where the robot may stand, from one scan:
///
///  a. Two lines of the scan that are not parallel, on two faces of walls with the same angle between them,
///  fix
///     heading and place. Both lines must lie on their walls, the open floor on the laser's side.
///  b. A line with one of its ends at the end of a wall (a corner, a door) fixes them too; for scans in which
///     all lines are parallel.
///  c. The longest line, slid along every wall that is longer, by steps; for scans whose ends are not those
///  of
///     walls.
///  d. Each pose is scored by a few readings, the best of them by all.
///
/// Out: the best, no two near one another, likeliest first.
///
/// The search by geometric constraints: K. O. Arras, J. A. Castellanos, R. Siegwart, ICRA 2002,
/// doi:10.1109/ROBOT.2002.1014734. Time: pairs of lines times pairs of faces of fitting angle.
void find_candidates(const WallMap& map, const WallFaces& faces, std::span<const ScanLine> lines,
                     const Readings& readings, double tolerance_m, const SearchOptions& options,
                     std::vector<CandidatePose>& candidates, SearchCounts& counts);

/// Nearer than this, two poses are taken for one.
bool same_place(const Pose2& a, const Pose2& b) noexcept;

}  // namespace straightedge::localize
