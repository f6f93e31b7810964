// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "io/number_text.hpp"
#include "localize_run.hpp"
#include "support/catch.hpp"

using namespace straightedge;
using namespace localize_run;

namespace {

std::string without_comments(const std::string& file) {
  std::string text = bytes_of(file);
  while (text.starts_with("#")) text.erase(0, text.find('\n') + 1);
  return text;
}

/// The same scans as CARMEN writes them, with a reading of no return where there is none.
std::string carmen_text(const LaserLog& log, std::size_t scans) {
  std::string text = "# message formats defined: PARAM ODOM FLASER\nPARAM robot_length 0.5 1 h 1\n";
  const auto add = [&text](double number) { text.append(" ").append(io::to_text(number)); };
  const auto end = [&](double time) { add(time), text.append(" host 1\n"); };
  for (std::size_t i = 0; i < scans; ++i) {
    const LaserScan& scan = log.scans[i].scan;
    if (const auto& odometry = log.scans[i].odometry) {
      text += "ODOM";
      for (const double v : {odometry->x_m, odometry->y_m, odometry->heading_rad, 0.0, 0.0, 0.0}) add(v);
      end(scan.time_s);
    }
    text += "FLASER";
    add(static_cast<double>(scan.ranges_m.size()));
    for (const float range : scan.ranges_m) add(range > 0 ? static_cast<double>(range) : 81.91);
    for (int k = 0; k < 6; ++k) add(9);
    end(scan.time_s);
  }
  return text;
}

}  // namespace

TEST_CASE("CARMEN's log of the same scans gives the same poses") {
  const MapFolder folder;
  const LaserLog log = log_in(simulated);
  localize(folder, folder.put("plain.txt", text_of(log, 0, 100)).string(), {"--start", "0 0 0"});
  const auto plain = poses_in(folder.file("t.txt"));
  const std::string carmen = folder.put("carmen.log", carmen_text(log, 100)).string();
  localize(folder, carmen, {"--start", "0 0 0", "--laser", "0.2 0 0"});
  const auto poses = poses_in(folder.file("t.txt"));
  REQUIRE(plain.size() == 100);
  REQUIRE(poses.size() == 100);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    CHECK(poses[i].time_s == plain[i].time_s);
    CHECK(poses[i].pose.x_m == Approx(plain[i].pose.x_m).margin(1e-3));
    CHECK(poses[i].pose.y_m == Approx(plain[i].pose.y_m).margin(1e-3));
  }
  // The poses of these FLASER records stand still.
  localize(folder, carmen, {"--start", "0 0 0", "--laser", "0.2 0 0", "--odometry", "flaser"});
  CHECK(poses_in(folder.file("t.txt")).size() == 100);
}

TEST_CASE("packed or plain, from a file or a pipe, into a file or a pipe: the same lines") {
  const MapFolder folder;
  const std::string text = text_of(log_in(corridor), 0, 37);
  const std::string plain = folder.put("scans.txt", text).string();
  const MapFolder building("mrpt_corridor");
  localize(building, plain);
  const std::string lines = without_comments(building.file("t.txt"));
  CHECK_FALSE(lines.empty());
  const Run from_pipe =
      run_program({"localize", building.map(), "-", "-o", "-", "--quiet"}, {.standard_input = plain});
  CHECK(from_pipe.code == 0);
  CHECK(from_pipe.err.empty());
  CHECK(from_pipe.out.ends_with(lines));
  const Run map_from_pipe =
      run_program({"localize", "-", plain, "-o", "-", "--quiet"}, {.standard_input = building.map()});
  CHECK(map_from_pipe.out.ends_with(lines));
  CHECK(from_pipe.out.starts_with("# straightedge " STRAIGHTEDGE_VERSION " localize\n# lines split, "));
}

TEST_CASE("a robot that sees nothing is not found: an empty trajectory and a sentence") {
  const MapFolder folder;
  const std::string blind =
      folder.put("blind.txt", "SCAN 1 0 0 0 3.1 1 80 4 0 nan inf 81\nSCAN 2 0 0 0 3.1 1 80 0\n").string();
  const Run run = localize(
      folder, blind,
      {"--covariance", folder.file("c.txt"), "--svg", folder.file("r.svg"), "--explain", folder.file("ex")});
  CHECK(run.err.find("never: no place in the map stood out; the trajectory is empty") != std::string::npos);
  CHECK(run.err.find("2 scans without a reading") != std::string::npos);
  CHECK(without_comments(folder.file("t.txt")).empty());
  CHECK(without_comments(folder.file("c.txt")).empty());
  CHECK(bytes_of(folder.file("r.svg")).find("class=\"way\"") == std::string::npos);
  CHECK_FALSE(bytes_of(folder.file("ex/index.html")).empty());
  localize(folder, blind, {"--start", "0 0 0", "--explain", folder.file("ex2")});
  CHECK(bytes_of(folder.file("ex2/index.html")).find("Scan 2 of blind.txt") != std::string::npos);
  const auto numbers = numbers_of(folder, blind, {"--quiet", "--truth", truth});
  CHECK(numbers["poses"] == 0);
  CHECK(numbers["events"].empty());
  CHECK(numbers["errors"]["compared"] == 0);
  CHECK(numbers["without_reading"] == 2);
}

TEST_CASE("scans may change in size on the way") {
  const MapFolder folder;
  LaserLog log = log_in(simulated);
  for (std::size_t i = 0; i < 60; i += 2) {
    LaserScan& scan = log.scans[i].scan;
    std::vector<float> half;
    for (std::size_t k = 0; k < scan.ranges_m.size(); k += 2) half.push_back(scan.ranges_m[k]);
    scan.ranges_m = half;
    scan.angle_step_rad *= 2;
  }
  const std::string file = folder.put("sizes.txt", text_of(log, 0, 60)).string();
  const auto numbers = numbers_of(folder, file, {"--start", "0 0 0", "--truth", truth});
  CHECK(numbers["poses"] == 60);
  CHECK(numbers["errors"]["position_rms"] < 0.1);
}

TEST_CASE("options say where the laser sits, how far it sees, and what it stands on") {
  const MapFolder folder;
  const std::string part = folder.put("part.txt", text_of(log_in(simulated), 0, 40)).string();
  localize(folder, part, {"--start", "0 0 0"});
  const auto poses = poses_in(folder.file("t.txt"));
  // Half a metre further ahead in the robot: the robot is half a metre behind.
  localize(folder, part, {"--start", "-0.5 0 0", "--laser", "0.7 0 0"});
  const auto behind = poses_in(folder.file("t.txt"));
  REQUIRE(behind.size() == poses.size());
  const double heading = poses.back().pose.heading_rad;
  CHECK(behind.back().pose.x_m == Approx(poses.back().pose.x_m - 0.5 * std::cos(heading)).margin(0.05));
  const auto far = numbers_of(folder, part, {"--start", "0 0 0"});
  const auto near = numbers_of(folder, part, {"--start", "0 0 0", "--max-range", "9"});
  CHECK(near["scan_lines"] < far["scan_lines"]);
  CHECK(numbers_of(folder, part, {"--start", "0 0 0", "--odometry", "none"})["with_odometry"] == 0);
  CHECK(numbers_of(folder, part, {"--start", "0 0 0", "--min-length", "3"})["scan_lines"] <
        far["scan_lines"]);
}
