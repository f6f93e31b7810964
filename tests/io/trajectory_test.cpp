// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "catch.hpp"
#include "io/number_text.hpp"
#include "refusal.hpp"
#include "temporary_folder.hpp"

using namespace straightedge;

namespace {

std::vector<TimedPose> poses_of(const std::string& text) {
  const TemporaryFolder folder;
  const auto poses = read_trajectory(folder.put("t.txt", text));
  INFO(text);
  if (!poses) FAIL(poses.failure().sentence);
  return *poses;
}

std::string refusal_of(const std::string& text) {
  return refusal_by([](const auto& file) { return read_trajectory(file); }, text);
}

/// How far R^T R is from the unit matrix, at most.
double off_rotation(const Pose& pose) {
  double worst = 0;
  const auto& r = pose.rotation;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const double product = r[i] * r[j] + r[i + 3] * r[j + 3] + r[i + 6] * r[j + 6];
      worst = std::max(worst, std::abs(product - (i == j ? 1 : 0)));
    }
  }
  return worst;
}

const std::string quarter =  // x to y, y to -x
    "0 -1 0 1\n1 0 0 2\n0 0 1 3\n";
const Pose quarter_pose{{0, -1, 0, 1, 0, 0, 0, 0, 1}, {1, 2, 3}};

}  // namespace

TEST_CASE("TUM lines: time, position, quaternion with its real part last") {
  const auto poses = poses_of(
      "# time tx ty tz qx qy qz qw\n\n1.5 1 2 3 0 0 0.70710678118654752 0.70710678118654752\r\n"
      "1.5 -1e3 +2.5 0 0 0 0 -1 # the same time again\n");
  REQUIRE(poses.size() == 2);
  CHECK(poses[0].time == 1.5);
  CHECK(poses[0].pose.translation == Vector3{1, 2, 3});
  for (std::size_t i = 0; i < 9; ++i)
    CHECK(poses[0].pose.rotation[i] == Approx(quarter_pose.rotation[i]).margin(1e-15));
  CHECK(poses[1].pose == Pose{{1, 0, 0, 0, 1, 0, 0, 0, 1}, {-1000, 2.5, 0}});
  const auto untimed = poses_of("1 2 3 1 0 0 0\n4 5 6 0 0 0 1");
  REQUIRE(untimed.size() == 2);
  CHECK_FALSE(untimed[0].time);
  CHECK(untimed[0].pose.rotation == std::array<double, 9>{1, 0, 0, 0, -1, 0, 0, 0, -1});
  CHECK(untimed[1].pose.translation == Vector3{4, 5, 6});
}

TEST_CASE("Redwood logs and matrices") {
  for (const std::string& text :
       {quarter, quarter + "0 0 0 1\n", "0\t0\t1\n" + quarter + "0 0 0 1\n",
        std::string("\xEF\xBB\xBF") + quarter, std::string("0 -1 0 1 1 0 0 2 0 0 1 3\n"),
        std::string("0 -1 0 1 1 0 0 2 0 0 1 3 0 0 0 1\n")}) {
    const auto poses = poses_of(text + "\n" + text.substr(text.starts_with('\xEF') ? 3 : 0));
    REQUIRE(poses.size() == 2);
    CHECK(poses[0].pose == quarter_pose);
    CHECK(poses[1].pose == quarter_pose);
    CHECK_FALSE(poses[0].time);
  }
  // Exponents of three digits, as programs for Windows wrote them.
  const auto old = poses_of(
      "1 1 2\n 0.999988 3.08668e-005 0.0049181 1.99962\n-8.84184e-005 0.999932 0.0117022 1.97704\n"
      "-0.0049174 -0.0117024 0.999919 -0.300486\n 0 0 0 1\n");
  CHECK(off_rotation(old[0].pose) < 1e-15);
  CHECK(old[0].pose.translation == Vector3{1.99962, 1.97704, -0.300486});
}

TEST_CASE("small faults are made good: the nearest rotation, far from any origin") {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int round = 0; round < 200; ++round) {
    double q[4];
    double length = 0;
    for (double& c : q) c = number(generator), length += c * c;
    std::string exact = "2000000.125 -1000 8848.5", scaled = exact;
    for (const double c : q) exact.append(" ").append(io::to_text(c / std::sqrt(length)));
    for (const double c : q) scaled.append(" ").append(io::to_text(1.009 * c / std::sqrt(length)));
    const Pose pose = poses_of(exact)[0].pose;
    CHECK(off_rotation(pose) < 1e-14);
    CHECK(pose.translation == Vector3{2000000.125, -1000, 8848.5});
    const Pose same = poses_of(scaled)[0].pose;
    std::string stretched, sheared;
    for (std::size_t i = 0; i < 9; ++i) {
      CHECK(same.rotation[i] == Approx(pose.rotation[i]).margin(1e-14));
      stretched += io::to_text(pose.rotation[i] * 1.004) + (i % 3 == 2 ? " 0\n" : " ");
      sheared += io::to_text(pose.rotation[i] + 1e-3 * number(generator)) + (i % 3 == 2 ? " 0\n" : " ");
    }
    const Pose nearest = poses_of(stretched)[0].pose;
    CHECK(off_rotation(nearest) < 1e-14);
    for (std::size_t i = 0; i < 9; ++i) CHECK(nearest.rotation[i] == Approx(pose.rotation[i]).margin(1e-14));
    const Pose near = poses_of(sheared)[0].pose;
    CHECK(off_rotation(near) < 1e-14);
    for (std::size_t i = 0; i < 9; ++i) CHECK(near.rotation[i] == Approx(pose.rotation[i]).margin(3e-3));
  }
}

TEST_CASE("what is no rotation is refused with its line") {
  CHECK(refusal_of("# t\n1 0 0 0 0 0 0 0\n") == "line 2: the quaternion is zero");
  CHECK(refusal_of("1 0 0 0 0 0 0 1.02\n") == "line 1: the quaternion's length is not 1");
  CHECK(refusal_of("1 0 0 0 0 0 0 1e300\n") == "line 1: the quaternion's length is not 1");
  CHECK(refusal_of("1 0 0 0\n0 1 0 0\n0 0 -1 0\n0 0 0 1\n") == "line 1: the matrix mirrors");
  CHECK(refusal_of("1 0 0 0\n0 1.02 0 0\n0 0 1 0\n") == "line 1: the matrix is no rotation");
  CHECK(refusal_of("1 0 0 0\n0 1 0.02 0\n0 0 1 0\n") == "line 1: the matrix is no rotation");
  CHECK(refusal_of("0 0 0 0\n0 0 0 0\n0 0 0 0\n0 0 0 1\n") == "line 1: the matrix is no rotation");
  CHECK(refusal_of("1e300 0 0 0\n0 1e300 0 0\n0 0 1 0\n") == "line 1: the matrix is no rotation");
  CHECK(refusal_of(quarter + "0 0 0 2\n") == "line 4: the last row of a 4x4 matrix is 0 0 0 1");
  CHECK(refusal_of("0 0 1\n" + quarter + "0 0 1 1\n") == "line 5: the last row of a 4x4 matrix is 0 0 0 1");
  CHECK(refusal_of(quarter + "0 0 0 1\n" + quarter + "0 0 0 1\n-1 0 0 0\n0 1 0 0\n0 0 1 0") ==
        "line 9: the matrix mirrors");
}

TEST_CASE("what is no trajectory is refused with its line") {
  CHECK(refusal_of("") == "holds no pose");
  CHECK(refusal_of("\n# nothing\n \n") == "holds no pose");
  CHECK(refusal_of("1 0 0 0 0 0 0 nan\n") == "line 1: 'nan' is not finite");
  CHECK(refusal_of("1 0 0 inf 0 0 0 1\n") == "line 1: 'inf' is not finite");
  CHECK(refusal_of("1 0 0 -1.#IND 0 0 0 1\n").starts_with("line 1: "));
  CHECK(refusal_of("1 0 0 0 0 0 0 1e999\n") == "line 1: '1e999' is no number");
  CHECK(refusal_of("1 0 0 0 0 0 0 1\n2 0 0 0 0 0 1\n") == "line 2: has 7 numbers where 8 are expected");
  CHECK(refusal_of("1 0 0 0 0 0 0,0 1\n") == "line 1: '0,0' is no number");
  CHECK(refusal_of("2 0 0 0 0 0 0 1\n1.5 0 0 0 0 0 0 1\n") ==
        "line 2: time 1.5 comes after 2: times must not run backwards");
  CHECK(refusal_of("1 2 3 4 5\n").starts_with("line 1: has 5 numbers; poses are"));
  CHECK(refusal_of("1\n").starts_with("line 1: has 1 number; poses are"));
  CHECK(refusal_of("0 -1 0 1\n1 0 0 2\n") == "line 2: the file ends within a matrix");
  CHECK(refusal_of("0 -1 0 1\n1 0 0 2\n0 0 1\n") == "line 3: has 3 numbers where 4 are expected");
  CHECK(refusal_of("0 0 1\n" + quarter) == "line 4: the file ends within a matrix");
  CHECK(refusal_of("0 0 1.5\n" + quarter + "0 0 0 1\n") == "line 1: three whole numbers are expected");
  CHECK(refusal_of("no poses here\n") == "line 1: 'no' is no number");
  CHECK(refusal_of("\x1b[31m\n") == "line 1: '?[31m' is no number");
  const auto missing = read_trajectory("/nonexistent/t.txt");
  REQUIRE_FALSE(missing);
  CHECK(missing.failure().problem == Problem::cannot_read);
}
