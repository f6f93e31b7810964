// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/planar_trajectory.hpp"

#include <cmath>
#include <random>

#include "catch.hpp"
#include "straightedge/host/trajectory.hpp"
#include "refusal.hpp"
#include "temporary_folder.hpp"

using namespace straightedge;

namespace {

std::string refusal_of(const std::string& text) {
  return refusal_by([](const auto& file) { return read_planar_trajectory(file); }, text);
}

}  // namespace

TEST_CASE("TUM lines and covariances, number for number") {
  const std::vector<TimedPose2> poses = {{1464600320.989009, {0.1, -2, 0}, {1, 2, 3, 2, 4, 5, 3, 5, 6}},
                                         {1464600321, {1e-9, 3, pi}, {}}};
  CHECK(planar_trajectory_to_text(poses) ==
        "1464600320.989009 0.1 -2 0 0 0 0 1\n1464600321 1e-09 3 0 0 0 1 " +
            std::string(sine_cosine(pi / 2).cosine == 0 ? "0" : "6.123233995736766e-17") + "\n");
  CHECK(covariances_to_text(poses, "made\nby") ==
        "# made\n# by\n# time xx xy xh yy yh hh\n1464600320.989009 1 2 3 4 5 6\n1464600321 0 0 0 0 0 0\n");
  CHECK(planar_trajectory_to_text({}, "none") == "# none\n");
  CHECK(planar_trajectory_to_text({}).empty());
}

TEST_CASE("what was written is read again, by this reader and by that of all trajectories") {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<TimedPose2> poses;
  for (int i = 0; i < 200; ++i)
    poses.push_back(
        {1e9 + i / 7.0, {300 * number(generator), 1e-3 * number(generator), pi * number(generator)}, {}});
  const TemporaryFolder folder;
  const auto file = folder.put("t.txt", planar_trajectory_to_text(poses, "by a test"));
  const auto read = read_planar_trajectory(file);
  const auto general = read_trajectory(file);
  REQUIRE(read);
  REQUIRE(general);
  REQUIRE(read->size() == poses.size());
  REQUIRE(general->size() == poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    CHECK((*read)[i].time_s == poses[i].time_s);
    CHECK((*read)[i].pose.x_m == poses[i].pose.x_m);
    CHECK((*read)[i].pose.y_m == poses[i].pose.y_m);
    CHECK(std::abs(wrap_angle((*read)[i].pose.heading_rad - poses[i].pose.heading_rad)) < 1e-12);
    CHECK((*general)[i].pose.rotation[3] == Approx(std::sin(poses[i].pose.heading_rad)).margin(1e-12));
  }
}

TEST_CASE("lines of four numbers are time, place and heading") {
  const TemporaryFolder folder;
  const auto poses =
      read_planar_trajectory(folder.put("t.txt", "# time x y theta\n1 2 3 4\n1 5 6 -7 # again\r\n"));
  REQUIRE(poses);
  REQUIRE(poses->size() == 2);
  CHECK((*poses)[0].pose == Pose2{2, 3, 4});
  CHECK((*poses)[1].pose == Pose2{5, 6, -7});
  const auto truth = read_planar_trajectory(STRAIGHTEDGE_FIXTURES "/laser2d/mrpt_simul/groundtruth.txt");
  REQUIRE(truth);
  CHECK(truth->size() == 1734);
}

TEST_CASE("what is no trajectory of a robot is refused with its line") {
  CHECK(refusal_of("") == "holds no pose");
  CHECK(refusal_of("1 2 3\n") ==
        "line 1: has 3 numbers; poses are lines of 4 (time x y theta) or of 8 as TUM has them");
  CHECK(refusal_of("1 2 3 4\n2 2 3 nan\n") == "line 2: 'nan' is not finite");
  CHECK(refusal_of("1 2 3 4\n0.5 2 3 4\n") == "line 2: time 0.5 comes after 1: times must not run backwards");
  CHECK(refusal_of("1 1e9 3 4\n") == "line 1: lies too far out");
  CHECK(refusal_of("1 0 0 0 0 0 0 0\n") == "line 1: the quaternion is zero");
  const auto missing = read_planar_trajectory("/nonexistent/t.txt");
  REQUIRE_FALSE(missing);
  CHECK(missing.failure().problem == Problem::cannot_read);
}
