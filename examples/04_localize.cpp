// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// From a picture of a floor to a robot's place on it, with the host library: a ROS map becomes lines, a
// laser's log is followed in them, and the poses are printed as they are found:
//   04_localize MAP.yaml SCANS
#include <cstdio>

#include "straightedge/host/image_file.hpp"
#include "straightedge/host/laser_log.hpp"
#include "straightedge/host/line_map_builder.hpp"
#include "straightedge/host/localizer.hpp"
#include "straightedge/host/map_file.hpp"
#include "straightedge/host/ros_map.hpp"

namespace {

using namespace straightedge;

int fail(const Failure& failure) {
  std::fprintf(stderr, "%s\n", failure.sentence.c_str());
  return static_cast<int>(failure.problem);
}

/// The picture's lines, in metres of the world.
Result<LineMap> metre_map(const char* yaml) {
  const auto ros = read_ros_map(yaml);
  if (!ros) return ros.failure();
  const auto picture = read_gray_image(ros->image);
  if (!picture) return picture.failure();
  LineMapOptions options;
  options.meaning = ros->meaning;
  auto lines = build_line_map(*picture, options);
  if (!lines) return lines.failure();
  lines->map.image->placement = ros->placement;
  return to_metres(lines->map);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return fail({Problem::bad_option, "usage: 04_localize MAP.yaml SCANS"});
  const auto map = metre_map(argv[1]);
  if (!map) return fail(map.failure());
  const auto log = read_laser_log(argv[2]);
  if (!log) return fail(log.failure());
  auto localizer = Localizer::create(*map);
  if (!localizer) return fail(localizer.failure());

  std::size_t poses = 0;
  for (const LoggedScan& logged : log->scans) {
    const LocalizeResult& robot = localizer->step(logged.scan, logged.odometry);
    if (!robot.has_pose) {
      std::printf("%.2f s: %s\n", robot.time_s, to_string(robot.state));
      continue;
    }
    ++poses;
    std::printf("%.2f s: x %.2f m, y %.2f m, heading %.3f rad; %u of %u lines matched\n", robot.time_s,
                robot.pose.x_m, robot.pose.y_m, robot.pose.heading_rad, robot.match_counts.matched,
                robot.match_counts.lines);
  }
  std::printf("a pose for %zu of %zu scans\n", poses, log->scans.size());
}
