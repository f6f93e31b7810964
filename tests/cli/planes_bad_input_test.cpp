// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "planes_room.hpp"
#include "straightedge/host/depth_file.hpp"
#include "support/catch.hpp"

using namespace straightedge;

namespace {

/// A room that something is done to; the program is to say what is wrong.
struct BadRoom : TemporaryFolder {
  explicit BadRoom(int last = 2) { planes_room::write_sequence(*this / "room", 0, last); }
  std::string room() const { return (*this / "room").string(); }
  std::string in_room(const std::string& name) const { return (*this / "room" / name).string(); }
  std::string xml() const { return (*this / "m.xml").string(); }

  /// Nothing but the room is left behind.
  void refused(int code, const std::string& name, const std::string& words,
               const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"planes", room(), "-o", xml()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    INFO(words);
    CHECK(refusal(run_program(arguments), code, name).find(words) != std::string::npos);
    CHECK(names_in(*this) == std::vector<std::string>{"room"});
  }
  /// The frame is told, skipped and counted; with --strict it is the failure.
  void skipped(const std::string& frame, const std::string& words, int strict_code) const {
    INFO(words);
    refusal(run_program({"planes", room(), "-o", xml(), "--strict"}), strict_code, frame);
    CHECK_FALSE(std::filesystem::exists(xml()));
    const Run run = run_program({"planes", room(), "-o", xml(), "--json"});
    CHECK(run.code == 0);
    CHECK(run.err.starts_with("straightedge: "));
    CHECK(run.err.substr(0, run.err.find('\n')).find(frame) != std::string::npos);
    CHECK(run.err.find(words) != std::string::npos);
    CHECK(run.err.find("1 bad frame skipped") != std::string::npos);
    const auto numbers = nlohmann::json::parse(run.out);
    CHECK(numbers["frames"] == 2);
    REQUIRE(numbers["skipped"].size() == 1);
    CHECK(numbers["skipped"][0]["reason"].get<std::string>().find(words) != std::string::npos);
  }
};

std::string camera_with(const std::string& what, const std::string& by) {
  std::string text = planes_room::camera_json();
  return text.replace(text.find(what), what.size(), by);
}

}  // namespace

TEST_CASE("folders that are no sequence") {
  const TemporaryFolder empty;
  const std::string folder = empty.path().string();
  refusal(run_program({"planes", folder, "-o", "-"}), 5, folder);
  refusal(run_program({"planes", (empty / "none").string(), "-o", "-"}), 3, "none");
  const BadRoom no_list;
  std::filesystem::remove(no_list.in_room("depth.txt"));
  no_list.refused(3, "depth.txt", "is missing");
  const BadRoom no_poses;
  std::filesystem::remove(no_poses.in_room("groundtruth.txt"));
  no_poses.refused(3, no_poses.room(), "");
  const BadRoom no_camera;
  std::filesystem::remove(no_camera.in_room("camera.json"));
  no_camera.refused(3, no_camera.room(), "camera");
  const BadRoom broken_list;
  broken_list.put("room/depth.txt", "0 depth/0.png\none depth/1.png\n");
  broken_list.refused(5, "depth.txt", "line 2");
}

TEST_CASE("poses that are none") {
  const BadRoom no_rotation;
  no_rotation.put("room/groundtruth.txt", planes_room::pose_line(0) + "1 0 0 0 0 0 0 0\n");
  no_rotation.refused(5, "groundtruth.txt", "line 2");
  const BadRoom mirrored;
  mirrored.put("poses.txt", "-1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n");
  CHECK(refusal(run_program({"planes", mirrored.room(), "-o", "-", "--trajectory",
                             (mirrored / "poses.txt").string()}),
                5, "poses.txt")
            .find("line 1") != std::string::npos);
  const BadRoom far_in_time;
  far_in_time.put("room/groundtruth.txt", "100 0 0 0 0 0 0 1\n");
  far_in_time.refused(5, "groundtruth.txt", "no pose");
}

TEST_CASE("cameras that are none") {
  for (const auto& [what, by] :
       {std::pair("\"fx\": 80", "\"fx\": 0"), std::pair("\"fy\": 80", "\"fy\": NaN"),
        std::pair("\"cx\": 79.5, ", ""), std::pair("5000", "-1"), std::pair("{", "")}) {
    const BadRoom folder;
    folder.put("room/camera.json", camera_with(what, by));
    folder.refused(5, "camera.json", "");
  }
  const BadRoom folder;
  folder.refused(3, "none.json", "", {"--camera", (folder / "none.json").string()});
}

TEST_CASE("a frame without pose is skipped") {
  const BadRoom folder;
  folder.put("room/groundtruth.txt", planes_room::pose_line(0) + planes_room::pose_line(2));
  folder.skipped("1.png", "no pose within", 5);
}

TEST_CASE("a frame that is missing, cut short, of 8 bits or of another size is skipped") {
  const BadRoom missing;
  std::filesystem::remove(missing.in_room("depth/1.png"));
  missing.skipped("1.png", "is missing", 3);
  const BadRoom truncated;
  const std::string whole = bytes_of(truncated.in_room("depth/1.png"));
  truncated.put("room/depth/1.png", whole.substr(0, whole.size() / 2));
  truncated.skipped("1.png", "", 5);
  const BadRoom byte;
  byte.put("room/depth/1.png", pgm(160, 120, 9));
  byte.skipped("1.png", "8", 5);
  const BadRoom small;
  REQUIRE(write_png16(small.in_room("depth/1.png"), Image<std::uint16_t>(Size{80, 60}, 5000)));
  small.skipped("1.png", "60 pixels", 5);
  const BadRoom unequal;
  unequal.put("room/camera.json", R"({"fx": 80, "fy": 80, "cx": 79.5, "cy": 59.5, "depth_scale": 5000})");
  REQUIRE(write_png16(unequal.in_room("depth/1.png"), Image<std::uint16_t>(Size{80, 60}, 5000)));
  unequal.skipped("1.png", "60 pixels", 5);
}

TEST_CASE("a sequence of bad frames alone is a failure") {
  const BadRoom folder;
  for (const char* name : {"0", "1", "2"}) folder.put("room/depth/" + std::string(name) + ".png", "no PNG");
  const Run run = run_program({"planes", folder.room(), "-o", folder.xml()});
  CHECK(run.code == 5);
  CHECK(run.err.find("none of its 3 frames can be used") != std::string::npos);
  CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 4);
  CHECK(names_in(folder) == std::vector<std::string>{"room"});
}

TEST_CASE("clouds that are none") {
  const std::string good = planes_room::corner_ply(20);
  const auto refused = [](const std::string& name, const std::string& bytes, const std::string& words) {
    const TemporaryFolder folder;
    const std::string file = folder.put(name, bytes).string();
    INFO(words);
    CHECK(refusal(run_program({"planes", file, "-o", (folder / "m.xml").string()}), 5, file).find(words) !=
          std::string::npos);
    CHECK(names_in(folder) == std::vector<std::string>{name});
  };
  refused("short.ply", good.substr(0, good.size() / 2), "");
  std::string huge = good;
  huge.replace(huge.find("800"), 3, "1000000000000");
  refused("huge.ply", huge, "");
  refused("flat.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n", "");
  refused("text.ply", "not a cloud", "");
  refused("short.pcd",
          "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 4\nHEIGHT 1\nPOINTS 4\nDATA "
          "binary\n12345678",
          "");
  refused("huge.pcd",
          "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 1000000000000\nHEIGHT 1\n"
          "POINTS 1000000000000\nDATA ascii\n1 2 3\n",
          "");
  refusal(run_program({"planes", "/nowhere/c.pcd", "-o", "-"}), 3, "/nowhere/c.pcd");
}

TEST_CASE("options of planes that are out of range or do not fit the input") {
  const BadRoom folder;
  for (const auto& [option, value] :
       {std::pair("--sigma", "0"),         std::pair("--sigma", "nan"),     std::pair("--sigma", "1"),
        std::pair("--sigmas", "-3"),       std::pair("--sigmas", "1e9"),    std::pair("--threshold", "-0.01"),
        std::pair("--threshold", "inf"),   std::pair("--min-pixels", "-1"), std::pair("--min-pixels", "1e30"),
        std::pair("--large", "0"),         std::pair("--large", "1.01"),    std::pair("--large", "nan"),
        std::pair("--large", "5%"),        std::pair("--max-planes", "0"),  std::pair("--max-planes", "257"),
        std::pair("--min-points", "x"),    std::pair("--ply-points", "0"),  std::pair("--depth-scale", "0"),
        std::pair("--depth-scale", "nan"), std::pair("--method", "magic"),  std::pair("--up", "x")})
    folder.refused(2, option, value, {option, value});
  refusal(run_program({"planes", folder.room(), "-o", (folder / "m.x").string()}), 2, "m.x");
  folder.refused(2, folder.in_room("depth"), "replace the frames", {"--labels", folder.in_room("depth")});
  folder.refused(2, "0.png", "replace the input", {"--leaves", folder.in_room("depth/0.png")});
  folder.refused(4, "nowhere", "cannot be written", {"--labels", (folder / "nowhere/labels").string()});
  folder.refused(2, "--min-pixels", "--large", {"--large", "0.1", "--min-pixels", "500"});
  const std::string picture = folder.in_room("depth/0.png");
  refusal(run_program({"planes", picture, "-o", "-", "--trajectory", folder.in_room("groundtruth.txt")}), 2,
          "--trajectory");
  const std::string cloud = folder.put("c.ply", planes_room::corner_ply(20)).string();
  for (const auto& [option, value] : {std::pair("--labels", "labels"), std::pair("--depth-scale", "1000"),
                                      std::pair("--camera", "c.json"), std::pair("--large", "0.1")})
    refusal(run_program({"planes", cloud, "-o", "-", option, value}), 2, option);
  refusal(run_program({"planes", cloud, "-o", "-", "--method", "both"}), 2, "both");
}
