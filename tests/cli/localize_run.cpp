// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "localize_run.hpp"

#include <algorithm>
#include <cmath>

#include "io/number_text.hpp"
#include "support/catch.hpp"

namespace localize_run {

using namespace straightedge;

MapFolder::MapFolder(const std::string& picture) {
  const Run run = run_program({"lines", fixture("maps/" + picture + "/map.yaml"), "-o", map(), "--quiet"});
  REQUIRE(run.code == 0);
}

Run localize(const MapFolder& folder, const std::string& scans, const std::vector<std::string>& more) {
  std::vector<std::string> arguments = {"localize", folder.map(), scans, "-o", folder.file("t.txt")};
  arguments.insert(arguments.end(), more.begin(), more.end());
  Run run = run_program(arguments);
  INFO(run.err);
  REQUIRE(run.code == 0);
  return run;
}

nlohmann::json numbers_of(const MapFolder& folder, const std::string& scans, std::vector<std::string> more) {
  more.emplace_back("--json");
  return nlohmann::json::parse(localize(folder, scans, more).out);
}

std::vector<TimedPose2> poses_in(const std::string& file) {
  const auto poses = read_planar_trajectory(file);
  return poses ? *poses : std::vector<TimedPose2>{};
}

Errors errors_of(const std::vector<TimedPose2>& poses) {
  const auto real = read_planar_trajectory(truth);
  REQUIRE(real);
  double way = 0, turn = 0;
  for (const TimedPose2& timed : poses) {
    const auto nearest = std::min_element(real->begin(), real->end(), [&](const auto& a, const auto& b) {
      return std::abs(a.time_s - timed.time_s) < std::abs(b.time_s - timed.time_s);
    });
    const Pose2& a = timed.pose;
    const Pose2& b = nearest->pose;
    way += (a.x_m - b.x_m) * (a.x_m - b.x_m) + (a.y_m - b.y_m) * (a.y_m - b.y_m);
    turn += std::pow(std::remainder(a.heading_rad - b.heading_rad, 2 * pi), 2);
  }
  const auto count = static_cast<double>(poses.size());
  return {std::sqrt(way / count), std::sqrt(turn / count) / degree};
}

std::string text_of(const LaserLog& log, std::size_t first, std::size_t last) {
  std::string text;
  const auto add = [&text](double number) { text.append(" ").append(io::to_text(number)); };
  for (std::size_t i = first; i < last; ++i) {
    const LaserScan& scan = log.scans[i].scan;
    if (const auto& odometry = log.scans[i].odometry) {
      text += "ODOM 0";
      for (const double v : {odometry->x_m, odometry->y_m, odometry->heading_rad}) add(v);
      text += "\n";
    }
    const Pose2& laser = scan.laser_in_robot;
    text += "SCAN";
    for (const double v : {scan.time_s, laser.x_m, laser.y_m, laser.heading_rad}) add(v);
    add(static_cast<double>(scan.ranges_m.size() - 1) * scan.angle_step_rad);
    text += " 1 80 " + io::to_text(scan.ranges_m.size());
    for (const float range : scan.ranges_m) add(static_cast<double>(range));
    text += "\n";
  }
  return text;
}

LaserLog log_in(const std::string& file) {
  auto log = read_laser_log(file);
  REQUIRE(log);
  return std::move(*log);
}

}  // namespace localize_run
