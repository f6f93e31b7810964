// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "io/number_text.hpp"
#include "localize_run.hpp"
#include "straightedge/host/line_geometry.hpp"
#include "straightedge/host/map_file.hpp"
#include "support/catch.hpp"

using namespace straightedge;
using namespace localize_run;

namespace {

double distance_to_segment(Point2 p, const MapSegment& s) {
  const Point2 a = first_end(s), b = second_end(s);
  const Point2 along{b.x - a.x, b.y - a.y}, to{p.x - a.x, p.y - a.y};
  const double part = std::clamp(dot(along, to) / dot(along, along), 0.0, 1.0);
  return std::hypot(to.x - part * along.x, to.y - part * along.y);
}

/// The median distance of a scan's points from the nearest wall of the map.
double median_off_walls(const LineMap& map, const LaserScan& scan, const Pose2& robot) {
  const Pose2 laser = compose(robot, scan.laser_in_robot);
  std::vector<double> distances;
  for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
    const double range = static_cast<double>(scan.ranges_m[i]);
    if (!(range > 0)) continue;
    const double angle =
        laser.heading_rad + scan.first_angle_rad + static_cast<double>(i) * scan.angle_step_rad;
    const Point2 p{laser.x_m + range * std::cos(angle), laser.y_m + range * std::sin(angle)};
    double nearest = 1e9;
    for (const MapLine& line : map.lines) {
      for (const MapSegment& segment : line.segments)
        nearest = std::min(nearest, distance_to_segment(p, segment));
    }
    distances.push_back(nearest);
  }
  std::nth_element(distances.begin(), distances.begin() + static_cast<long>(distances.size() / 2),
                   distances.end());
  return distances[distances.size() / 2];
}

}  // namespace

TEST_CASE("the simulated run from its start: errors against the exact truth") {
  const MapFolder folder;
  const auto numbers = numbers_of(
      folder, simulated, {"--start", "0 0 0", "--truth", truth, "--covariance", folder.file("c.txt")});
  CHECK(numbers["scans"] == 1733);
  CHECK(numbers["poses"] == 1733);
  CHECK(numbers["lost_times"] == 0);
  CHECK(numbers["errors"]["position_rms"] <= 0.10);
  CHECK(numbers["errors"]["heading_rms"] <= 0.4 * degree);
  CHECK(numbers["errors"]["nees"] >= 1);
  CHECK(numbers["errors"]["nees"] <= 5);
  CHECK(numbers["errors"]["compared"] == 1733);
  CHECK(numbers["odometry_errors"]["position_rms"] > 10);
  // The same, found from the file alone.
  const auto poses = poses_in(folder.file("t.txt"));
  REQUIRE(poses.size() == 1733);
  const Errors errors = errors_of(poses);
  CHECK(errors.position_m == Approx(numbers["errors"]["position_rms"].get<double>()).epsilon(1e-6));
  CHECK(errors.heading_degrees * degree ==
        Approx(numbers["errors"]["heading_rms"].get<double>()).epsilon(1e-6));
  const std::string covariances = bytes_of(folder.file("c.txt"));
  CHECK(std::count(covariances.begin(), covariances.end(), '\n') == 1733 + 3);
}

TEST_CASE("the simulated run without a start") {
  const MapFolder folder;
  const auto numbers = numbers_of(folder, simulated, {"--truth", truth});
  CHECK(numbers["lost_times"] == 0);
  REQUIRE(numbers["events"].size() == 1);
  CHECK(numbers["events"][0]["state"] == "found");
  CHECK(numbers["events"][0]["scan"] <= 20);
  CHECK(numbers["errors"]["position_rms"] <= 0.10);
  CHECK(numbers["poses"] == 1734 - numbers["events"][0]["scan"].get<int>());
}

TEST_CASE("the real corridor: found by the third scan, and on the walls to the end") {
  const MapFolder folder("mrpt_corridor");
  const auto numbers = numbers_of(folder, corridor);
  REQUIRE(numbers["events"].size() == 1);
  CHECK(numbers["events"][0]["scan"] <= 3);
  const auto map = to_metres(*read_line_map(folder.map()));
  REQUIRE(map);
  const LaserLog log = log_in(corridor);
  const auto poses = poses_in(folder.file("t.txt"));
  REQUIRE(poses.size() >= 35);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const LaserScan& scan = log.scans[log.scans.size() - poses.size() + i].scan;
    REQUIRE(scan.time_s == poses[i].time_s);
    INFO("scan at " << scan.time_s);
    CHECK(median_off_walls(*map, scan, poses[i].pose) <= 0.08);
  }
}

TEST_CASE("a robot that is carried off is lost, writes nothing, and is found again") {
  const MapFolder folder;
  const LaserLog log = log_in(simulated);
  // The odometry after goes on from where it was before.
  LaserLog after = log;
  const Pose2 shift = compose(*log.scans[599].odometry, inverse(*log.scans[899].odometry));
  for (std::size_t i = 900; i < log.scans.size(); ++i)
    after.scans[i].odometry = compose(shift, *log.scans[i].odometry);
  const std::string text = text_of(log, 0, 600) + text_of(after, 900, 1200);
  const auto numbers = numbers_of(folder, folder.put("carried.txt", text).string(), {"--start", "0 0 0"});
  REQUIRE(numbers["events"].size() == 3);
  CHECK(numbers["events"][1]["state"] == "lost");
  CHECK(numbers["events"][1]["scan"] > 600);
  CHECK(numbers["events"][1]["scan"] <= 610);
  CHECK(numbers["events"][2]["state"] == "found");
  CHECK(numbers["events"][2]["scan"] <= 660);
  CHECK(numbers["lost_times"] == 1);
  const auto poses = poses_in(folder.file("t.txt"));
  const std::size_t lost = numbers["events"][1]["scan"], found = numbers["events"][2]["scan"];
  CHECK(poses.size() == 900 - (found - lost));
  for (const TimedPose2& timed : poses) {
    const bool while_lost =
        timed.time_s >= numbers["events"][1]["time"] && timed.time_s < numbers["events"][2]["time"];
    CHECK_FALSE(while_lost);
  }
  CHECK(errors_of({poses.begin() + static_cast<long>(lost + 5), poses.end()}).position_m < 0.15);
}

TEST_CASE("every way to find lines and to pair them keeps the robot") {
  const MapFolder folder;
  const std::string part = folder.put("part.txt", text_of(log_in(simulated), 0, 300)).string();
  for (const std::vector<std::string>& more : {std::vector<std::string>{"--lines", "ransac"},
                                               {"--lines", "hough"},
                                               {"--association", "nearest"},
                                               {"--lines", "ransac", "--seed", "7"},
                                               {"--odometry", "none"}}) {
    INFO(more[0] << " " << more[1]);
    std::vector<std::string> arguments = more;
    arguments.insert(arguments.end(), {"--start", "0,0,0", "--truth", truth});
    const auto numbers = numbers_of(folder, part, arguments);
    CHECK(numbers["lost_times"] == 0);
    CHECK(numbers["errors"]["position_rms"] < (more[1] == "none" ? 0.4 : 0.25));
  }
}

TEST_CASE("the same run gives the same bytes") {
  const MapFolder folder;
  const std::string part = folder.put("part.txt", text_of(log_in(simulated), 0, 80)).string();
  std::vector<std::string> first;
  for (int round = 0; round < 2; ++round) {
    const Run run = localize(folder, part,
                             {"--covariance", folder.file("c.txt"), "--svg", folder.file("r.svg"),
                              "--explain", folder.file("ex"), "--truth", truth, "--json"});
    std::vector<std::string> all = {run.out};
    for (const char* name : {"t.txt", "c.txt", "r.svg", "ex/index.html", "ex/matches.svg"})
      all.push_back(bytes_of(folder.file(name)));
    for (const std::string& bytes : all) CHECK_FALSE(bytes.empty());
    if (round == 0) first = all;
    CHECK(all == first);
  }
}

TEST_CASE("the drawings show what happened") {
  const MapFolder folder;
  const std::string part = folder.put("part.txt", text_of(log_in(simulated), 0, 60)).string();
  localize(folder, part, {"--svg", folder.file("r.svg"), "--explain", folder.file("ex"), "--truth", truth});
  const std::string svg = bytes_of(folder.file("r.svg"));
  for (const char* part_of :
       {"class=\"wall\"", "class=\"reading\"", "class=\"way\"", "class=\"truth\"", "class=\"odometry\"",
        "class=\"start\"", "class=\"end\"", "part.txt in map.xml"})
    CHECK(svg.find(part_of) != std::string::npos);
  CHECK(svg.find("class=\"lost\"") == std::string::npos);
  const std::string page = bytes_of(folder.file("ex/index.html"));
  for (const char* name :
       {"search-1.svg", "search-2.svg", "readings.svg", "scan-lines.svg", "matches.svg", "pose.svg"}) {
    CHECK(page.find(std::string("src=\"") + name) != std::string::npos);
    CHECK(bytes_of(folder.file(std::string("ex/") + name)).starts_with("<svg"));
  }
  CHECK(bytes_of(folder.file("ex/matches.svg")).find("class=\"bold\"") != std::string::npos);
  CHECK(bytes_of(folder.file("ex/pose.svg")).find("class=\"sigma\"") != std::string::npos);
  // Another scan, by its number; pictures of the search are gone.
  localize(folder, part, {"--start", "0 0 0", "--explain", folder.file("ex"), "--explain-scan", "40"});
  CHECK(bytes_of(folder.file("ex/index.html")).find("Scan 40 of part.txt") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(folder.file("ex/search-1.svg")));
}
