// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "localize/scan_fit.hpp"

#include <algorithm>
#include <cmath>

#include "straightedge/trigonometry.hpp"

namespace straightedge::localize {
namespace {

constexpr double before_wall = -2.5;
constexpr double nowhere = -3;
constexpr double behind_wall = -5;
constexpr double independent_share = 0.25;  // readings that are news, among those looked at
constexpr double look_ahead_m = 10;         // beyond a reading, for the wall that it should have met
constexpr double flattest = 0.2;  // cosine; a wall seen at a smaller angle is as uncertain as at this

}  // namespace

void choose_readings(std::span<const ScanPoint> points, const Pose2& laser_in_robot, std::size_t most,
                     Readings& readings) {
  readings.ends.clear();
  readings.laser_x_m = laser_in_robot.x_m;
  readings.laser_y_m = laser_in_robot.y_m;
  const std::size_t count = std::min(points.size(), most);
  for (std::size_t i = 0; i < count; ++i) {
    const ScanPoint& p = points[(2 * i + 1) * points.size() / (2 * count)];
    readings.ends.push_back({p.x_m, p.y_m});
  }
}

PoseScore score_pose(const WallMap& map, const Pose2& pose, const Readings& readings, double tolerance_m) {
  PoseScore score;
  if (readings.ends.empty()) return score;
  if (!usable(pose)) {
    score.fit.nowhere = 1;
    score.log_likelihood = -1e9;
    return score;
  }
  const SineCosine turn = sine_cosine(pose.heading_rad);
  const auto world_x = [&](double x, double y) { return pose.x_m + turn.cosine * x - turn.sine * y; };
  const auto world_y = [&](double x, double y) { return pose.y_m + turn.sine * x + turn.cosine * y; };
  const double x0 = world_x(readings.laser_x_m, readings.laser_y_m);
  const double y0 = world_y(readings.laser_x_m, readings.laser_y_m);
  for (const Reading& end : readings.ends) {
    const double x = world_x(end.x_m, end.y_m), y = world_y(end.x_m, end.y_m);
    const double range = std::sqrt((x - x0) * (x - x0) + (y - y0) * (y - y0));
    if (!(range > 1e-6)) continue;
    const auto crossing =
        map.first_crossing(x0, y0, (x - x0) / range, (y - y0) / range, range + look_ahead_m);
    const double distance = map.distance(x, y, std::min(tolerance_m, WallMap::reach_m));
    const double margin = crossing ? tolerance_m * (1 + 1 / std::max(flattest, crossing->cosine)) : 0;
    if (crossing && range - crossing->distance_m > margin) {
      score.fit.through_walls += 1;
      score.log_likelihood += behind_wall;
    } else if (distance < tolerance_m) {
      score.fit.on_walls += 1;
      score.log_likelihood -= 2 * (distance / tolerance_m) * (distance / tolerance_m);
    } else if (crossing) {
      score.fit.before_walls += 1;
      score.log_likelihood += before_wall;
    } else {
      score.fit.nowhere += 1;
      score.log_likelihood += nowhere;
    }
  }
  const auto count = static_cast<double>(readings.ends.size());
  for (double* share :
       {&score.fit.on_walls, &score.fit.before_walls, &score.fit.through_walls, &score.fit.nowhere})
    *share /= count;
  score.log_likelihood *= independent_share;
  return score;
}

}  // namespace straightedge::localize
