// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/depth_sequence.hpp"

#include <limits>
#include <string>

#include "catch.hpp"
#include "sequence_maker.hpp"

using namespace straightedge;

namespace {

DepthSequence opened(const std::filesystem::path& folder, const SequenceOptions& options = {}) {
  auto sequence = open_depth_sequence(folder, options);
  if (!sequence) FAIL(sequence.failure().sentence);
  return *sequence;
}

std::string names_of(const DepthSequence& sequence) {
  std::string names;
  for (const SequenceFrame& frame : sequence.frames) names += frame.name + " ";
  return names;
}

/// The x of each frame's pose, or what the problem says after the file's name.
std::string poses_of(const DepthSequence& sequence) {
  std::string text;
  for (const SequenceFrame& frame : sequence.frames) {
    if (!frame.problem.empty()) {
      CHECK(frame.problem.find(": ") != std::string::npos);
      text.append("(").append(frame.problem.substr(frame.problem.find(": ") + 2)).append(")");
    } else {
      REQUIRE(frame.pose);
      text += std::to_string(static_cast<int>(frame.pose->translation.x)) + " ";
    }
  }
  return text;
}

std::string refusal_of(const std::filesystem::path& folder, Problem problem,
                       const SequenceOptions& options = {}) {
  const auto sequence = open_depth_sequence(folder, options);
  REQUIRE_FALSE(sequence);
  CHECK(sequence.failure().problem == problem);
  const std::string& sentence = sequence.failure().sentence;
  const std::string name = folder.string();
  return sentence.starts_with(name) ? sentence.substr(name.size()) : sentence;
}

}  // namespace

TEST_CASE("the shipped room: TUM layout") {
  const auto room = opened(STRAIGHTEDGE_FIXTURES "/depth/room");
  CHECK(room.camera.units_per_metre == 5000);
  REQUIRE(room.frames.size() == 12);
  for (const SequenceFrame& frame : room.frames) {
    CHECK(frame.problem.empty());
    REQUIRE(frame.pose);
    CHECK(frame.pose->translation.z == Approx(1.3).margin(0.1));
  }
  CHECK(room.frames[3].name == "03.png");
  CHECK(room.frames[3].time == 101.5);
  CHECK(room.frames[3].pose->translation == Vector3{0, 0.55, 1.22});
}

TEST_CASE("depth.txt in any order; the nearest pose counts") {
  SequenceMaker made;
  made.text("depth.txt", "# t\n3.0 depth/c.png\n1.0 depth/a.png\n2.005 depth/b.png\n\n9 depth/d.png\n");
  for (const char* name : {"a", "b", "c", "d"}) made.frame(std::string("depth/") + name + ".png");
  made.text("groundtruth.txt",
            made.tum({{0.99, 1}, {1.012, 2}, {2, 3}, {2.008, 4}, {3, 5}, {3, 6}, {8.97, 7}}));
  const auto sequence = opened(made.path());
  CHECK(names_of(sequence) == "a.png b.png c.png d.png ");
  CHECK(sequence.frames[1].time == 2.005);
  CHECK(poses_of(sequence) == "1 4 5 (no pose within 0.02 s; the nearest is 0.03 s away)");
  SequenceOptions wide;
  wide.max_time_difference = 0.1;
  CHECK(poses_of(opened(made.path(), wide)) == "1 4 5 7 ");
  made.text("groundtruth.txt", made.tum({{0.75, 8}, {1.25, 9}}));  // as near: the earlier one
  wide.max_time_difference = 0.25;
  CHECK(poses_of(opened(made.path(), wide)).starts_with("8 ("));
  // A trajectory without times goes by order, another with times by time.
  SequenceOptions other;
  other.trajectory =
      made.text("other.txt", made.matrix(10) + made.matrix(11) + made.matrix(12) + made.matrix(13));
  CHECK(poses_of(opened(made.path(), other)) == "10 11 12 13 ");
  other.trajectory = made.text("other.txt", made.tum({{1, 20}, {2, 21}, {3, 22}, {9, 23}}));
  CHECK(poses_of(opened(made.path(), other)) == "20 21 22 23 ");
}

TEST_CASE("frames that are missing or named twice stay in the list") {
  SequenceMaker made;
  made.text("depth.txt", "1 depth/a.png\n2 depth/b.png\n3 depth/a.png\n");
  made.frame("depth/a.png");
  made.text("groundtruth.txt", made.tum({{1, 1}, {2, 2}, {3, 3}}));
  CHECK(poses_of(opened(made.path())) == "1 (is missing)(a frame named a.png came before)");
}

TEST_CASE("n-th pose to n-th frame; numbers in names count as numbers") {
  for (const char* name : {"pose.txt", "poses.txt", "trajectory.txt", "trajectory.log"}) {
    SequenceMaker made;
    for (const int n : {1, 2, 10, 9, 100}) made.frame("depth/frame-" + std::to_string(n) + ".png");
    made.frame("depth/.hidden.png");
    made.text("depth/notes.txt", "no frame");
    made.text(name, made.matrix(1) + made.matrix(2) + made.matrix(9) + made.matrix(10) + made.matrix(100));
    const auto sequence = opened(made.path());
    CHECK(names_of(sequence) == "frame-1.png frame-2.png frame-9.png frame-10.png frame-100.png ");
    CHECK(poses_of(sequence) == "1 2 9 10 100 ");
  }
}

TEST_CASE("colour and labels beside the depth are passed over") {
  SequenceMaker made;
  for (const char* name : {"1.png", "2.PGM", "1.color.png", "rgb_2.png", "label-1.png", "x.jpg"})
    made.frame(name);
  made.frame("labels/1.png");
  made.text("poses.txt", made.matrix(1) + made.matrix(2));
  CHECK(names_of(opened(made.path())) == "1.png 2.PGM ");
  SequenceMaker told;
  for (const char* name : {"Depth_1.png", "left_1.png", "depth_2.png", "1.png"}) told.frame(name);
  told.text("poses.txt", told.matrix(1) + told.matrix(2));
  CHECK(names_of(opened(told.path())) == "Depth_1.png depth_2.png ");
}

TEST_CASE("a pose file for each frame, beside it or in a folder of poses") {
  SequenceMaker beside;
  for (const char* n : {"15", "16", "17", "18", "19"}) {
    beside.frame(std::string("frame-0000") + n + ".depth.png");
    beside.frame(std::string("frame-0000") + n + ".color.png");
  }
  beside.text("frame-000015.pose.txt", beside.matrix(15));
  beside.text("frame-000016.pose.txt", " \n");
  beside.text("frame-000017.pose.txt", beside.matrix(1) + beside.matrix(2));
  beside.text("frame-000019.pose.txt", "nan 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n");
  beside.text("trajectory.log", "not looked at");
  CHECK(poses_of(opened(beside.path())) ==
        "15 (holds no pose)(has 2 poses; one is expected)(has no pose file)(line 1: 'nan' is not finite)");
  for (const char* folder : {"pose/", "poses/"}) {
    SequenceMaker made;
    for (const int n : {0, 1, 2}) {
      made.frame("depth/" + std::to_string(n) + ".png");
      made.text(folder + std::to_string(n) + ".txt", made.matrix(n + 5));
    }
    CHECK(poses_of(opened(made.path())) == "5 6 7 ");
  }
}

TEST_CASE("cameras: the option, camera.json, a matrix file; the scale may be overruled") {
  SequenceMaker made;
  made.frame("1.png");
  made.text("pose.txt", made.matrix(1));
  made.text("intrinsics.K.txt", "600 0 320\n0 601 240\n0 0 1\n");
  CHECK(opened(made.path()).camera.pinhole.fx == 525);
  SequenceOptions options;
  options.camera = made.path() / "intrinsics.K.txt";
  options.units_per_metre = 5000;
  CHECK(opened(made.path(), options).camera.pinhole.fy == 601);
  CHECK(opened(made.path(), options).camera.units_per_metre == 5000);
  std::filesystem::remove(made.path() / "camera.json");
  CHECK(opened(made.path()).camera.pinhole.fx == 600);
  made.text("camera_2.json", "{}");
  CHECK(refusal_of(made.path(), Problem::bad_content) ==
        ": has more than one camera (camera_2.json, intrinsics.K.txt): say which one counts");
  std::filesystem::remove(made.path() / "intrinsics.K.txt");
  CHECK(refusal_of(made.path(), Problem::bad_content) == "/camera_2.json: has no `fx`");
  std::filesystem::remove(made.path() / "camera_2.json");
  CHECK(refusal_of(made.path(), Problem::cannot_read).starts_with(": has no camera: neither a camera.json"));
  options.camera = made.path() / "none.json";
  CHECK(refusal_of(made.path(), Problem::cannot_read, options).starts_with("/none.json: cannot be opened"));
}

TEST_CASE("a folder without frames, poses or times is refused") {
  SequenceMaker made;
  CHECK(refusal_of(made.path(), Problem::bad_content) ==
        ": holds no depth frames (PNG or PGM, here or in depth/)");
  CHECK(refusal_of(made.path() / "none", Problem::cannot_read) ==
        ": cannot be opened (No such file or directory)");
  CHECK(refusal_of(made.path() / "camera.json", Problem::cannot_read) == ": is no folder");
  made.frame("depth/1.png");
  made.frame("depth/2.png");
  CHECK(refusal_of(made.path(), Problem::cannot_read).starts_with(": has no poses: neither a trajectory"));
  made.text("pose.txt", made.matrix(1));
  CHECK(refusal_of(made.path(), Problem::bad_content) ==
        "/pose.txt: has 1 poses for 2 frames; the n-th belongs to the n-th, so the counts must be equal");
  made.text("pose.txt", made.matrix(1) + "0 0 0\n");
  CHECK(refusal_of(made.path(), Problem::bad_content).starts_with("/pose.txt: line 5: "));
  std::filesystem::remove(made.path() / "pose.txt");
  made.text("groundtruth.txt", made.tum({{1, 1}, {2, 2}}));
  CHECK(refusal_of(made.path(), Problem::cannot_read) ==
        "/depth.txt: is missing: groundtruth.txt has times, and nothing says those of the frames");
  SequenceOptions by_order;
  by_order.trajectory = made.path() / "groundtruth.txt";
  CHECK(poses_of(opened(made.path(), by_order)) == "1 2 ");
}

TEST_CASE("a broken depth.txt or trajectory is refused") {
  SequenceMaker made;
  made.frame("depth/1.png");
  made.text("groundtruth.txt", made.tum({{1, 1}}));
  const auto listed = [&](const std::string& list) {
    made.text("depth.txt", list);
    return refusal_of(made.path(), Problem::bad_content);
  };
  CHECK(listed("# none\n") == "/depth.txt: names no frame");
  CHECK(listed("1 depth/1.png\n2\n") == "/depth.txt: line 2: is not a time and a file");
  CHECK(listed("1 rgb/1.png 1 depth/1.png\n") == "/depth.txt: line 1: is not a time and a file");
  CHECK(listed("depth/1.png 1\n") == "/depth.txt: line 1: 'depth/1.png' is no number");
  CHECK(listed("inf depth/1.png\n") == "/depth.txt: line 1: 'inf' is not finite");
  CHECK(listed("5 depth/1.png\n") == "/groundtruth.txt: no pose is within 0.02 s of any frame");
  made.text("depth.txt", "1 depth/1.png\n");
  made.text("groundtruth.txt", "1 0 0 0 0 0 0 0\n");
  CHECK(refusal_of(made.path(), Problem::bad_content) == "/groundtruth.txt: line 1: the quaternion is zero");
  std::filesystem::remove(made.path() / "groundtruth.txt");
  CHECK(refusal_of(made.path(), Problem::cannot_read).starts_with(": has no poses"));
}

TEST_CASE("options out of range are refused") {
  for (const double wrong :
       {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    SequenceOptions options;
    options.max_time_difference = wrong;
    CHECK(refusal_of(STRAIGHTEDGE_FIXTURES "/depth/room", Problem::bad_option, options).size() > 10);
    options = {};
    options.units_per_metre = wrong;
    CHECK(refusal_of(STRAIGHTEDGE_FIXTURES "/depth/room", Problem::bad_option, options).size() > 10);
  }
}
