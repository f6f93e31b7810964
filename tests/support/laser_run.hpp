// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "straightedge/host/localizer.hpp"
#include "support/laser_room.hpp"

/// Robots that drive through rooms of straight walls.
namespace support {

/// The odometry of a robot: what it says of a way, faults and noise put on.
class Odometry {
 public:
  double scale = 0;  ///< it says so much more than was driven
  double drift_per_m = 0;
  double noise = 0.02;  ///< of way and turn, for each metre and radian

  const Pose2& drive(const Pose2& motion, Pcg32& random) {
    const double way = std::hypot(motion.x_m, motion.y_m), turn = std::fabs(motion.heading_rad);
    const double sigma = noise * (way + turn) + (noise > 0 ? 0.001 : 0);
    says_ = straightedge::compose(says_, {(1 + scale) * motion.x_m + sigma * normal(random),
                                          (1 + scale) * motion.y_m + sigma * normal(random),
                                          motion.heading_rad + drift_per_m * way + sigma * normal(random)});
    return says_;
  }

 private:
  Pose2 says_{5, -3, 2};  // a frame of its own
};

inline double distance(const Pose2& a, const Pose2& b) {
  return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m);
}

inline double turn_between(const Pose2& a, const Pose2& b) {
  return std::fabs(straightedge::wrap_angle(a.heading_rad - b.heading_rad));
}

/// Normalised estimation error squared: 3 on average for a covariance that is right.
inline double nees(const straightedge::LocalizeResult& result, const Pose2& truth) {
  const double e[] = {result.pose.x_m - truth.x_m, result.pose.y_m - truth.y_m,
                      straightedge::wrap_angle(result.pose.heading_rad - truth.heading_rad)};
  double a[3][4];
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) a[r][c] = result.covariance[3 * r + c];
    a[r][3] = e[r];
  }
  double sum = 0;  // L D Lᵀ: squared conditional errors over conditional variances
  for (std::size_t k = 0; k < 3; ++k) {
    sum += a[k][3] * a[k][3] / a[k][k];
    for (std::size_t r = k + 1; r < 3; ++r) {
      const double factor = a[r][k] / a[k][k];
      for (std::size_t c = k; c < 4; ++c) a[r][c] -= factor * a[k][c];
    }
  }
  return sum;
}

inline straightedge::LocalizeOptions started_at(const Pose2& pose) {
  straightedge::LocalizeOptions options;
  options.start = pose;
  return options;
}

}  // namespace support
