// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "planes_room.hpp"
#include "straightedge/host/depth_file.hpp"
#include "straightedge/host/plane_map_file.hpp"
#include "support/catch.hpp"

using namespace straightedge;

namespace {

std::size_t planes_in(const std::filesystem::path& xml) {
  const auto map = read_plane_map(xml);
  REQUIRE(map);
  return map->planes.size();
}

/// A cloud, and how many planes each method's map of it has.
std::vector<std::size_t> planes_of_cloud(const std::string& name, const std::string& bytes) {
  const TemporaryFolder folder;
  const std::string cloud = folder.put(name, bytes).string();
  std::vector<std::size_t> found;
  for (const char* method : {"ransac", "hough"}) {
    const Run run = run_program({"planes", cloud, "-o", (folder / "m.xml").string(), "--ply",
                                 (folder / "p.ply").string(), "--method", method});
    INFO(name << " by " << method << ": " << run.err);
    CHECK(run.code == 0);
    found.push_back(run.code == 0 ? planes_in(folder / "m.xml") : 999);
  }
  return found;
}

using Counts = std::vector<std::size_t>;

}  // namespace

TEST_CASE("a single depth picture, with the camera beside it, above it or named") {
  const TemporaryFolder folder;
  planes_room::write_sequence(folder / "room", 0, 0);
  const std::string picture = (folder / "room/depth/0.png").string();
  const auto xml = [&](const std::string& name) { return (folder / name).string(); };
  CHECK(run_program({"planes", picture, "-o", xml("above.xml")}).code == 0);
  std::filesystem::copy(folder / "room/camera.json", folder / "room/depth/camera.json");
  CHECK(run_program({"planes", picture, "-o", xml("beside.xml")}).code == 0);
  std::filesystem::rename(folder / "room/camera.json", folder / "c.json");
  std::filesystem::remove(folder / "room/depth/camera.json");
  CHECK(run_program({"planes", picture, "-o", xml("named.xml"), "--camera", xml("c.json")}).code == 0);
  CHECK(planes_in(folder / "above.xml") >= 3);
  CHECK(bytes_of(folder / "above.xml") == bytes_of(folder / "beside.xml"));
  CHECK(bytes_of(folder / "above.xml") == bytes_of(folder / "named.xml"));
  const Run piped =
      run_program({"planes", "-", "-o", "-", "--camera", xml("c.json")}, {.standard_input = picture});
  CHECK(piped.code == 0);
  CHECK(piped.out.find("kind=\"planes\"") != std::string::npos);
  const std::string words = refusal(run_program({"planes", picture, "-o", xml("none.xml")}), 2, picture);
  CHECK(words.find("camera") != std::string::npos);
}

TEST_CASE("the depth scale of the command line takes the place of the camera's") {
  const TemporaryFolder folder;
  planes_room::write_sequence(folder / "room", 0, 0);
  const Run run = run_program(
      {"planes", (folder / "room").string(), "--depth-scale", "2500", "-o", (folder / "m.xml").string()});
  CHECK(run.code == 0);
  const auto map = read_plane_map(folder / "m.xml");
  REQUIRE(map);
  // The wall at x = 2 is twice as far away.
  const auto& planes = map->planes;
  CHECK(std::any_of(planes.begin(), planes.end(), [](const MapPlane& p) {
    return p.plane.normal.x > 0.999 && std::abs(p.plane.distance - 4) < 0.02;
  }));
}

TEST_CASE("the n-th of poses without times is the n-th frame's") {
  const TemporaryFolder folder;
  planes_room::write_sequence(folder / "room");
  std::string poses;
  for (int i = 0; i < planes_room::frames; ++i) {
    const std::string line = planes_room::pose_line(i);
    poses += line.substr(line.find(' ') + 1);
  }
  const std::string file = folder.put("room/pose.txt", poses).string();
  std::filesystem::remove(folder / "room/groundtruth.txt");
  std::filesystem::remove(folder / "room/depth.txt");
  const std::string room = (folder / "room").string();
  CHECK(run_program({"planes", room, "-o", (folder / "own.xml").string()}).code == 0);
  CHECK(run_program({"planes", room, "-o", (folder / "named.xml").string(), "--trajectory", file}).code == 0);
  CHECK(planes_in(folder / "own.xml") >= 5);
  CHECK(bytes_of(folder / "own.xml") == bytes_of(folder / "named.xml"));
}

TEST_CASE("a kilometre away") {
  const TemporaryFolder folder;
  planes_room::write_sequence(folder / "room", 0, 4, 1000);
  planes_room::write_sequence(folder / "near");
  for (const char* room : {"room", "near"})
    CHECK(run_program({"planes", (folder / room).string(), "-o", (folder / room).string() + ".xml"}).code ==
          0);
  CHECK(planes_in(folder / "room.xml") == planes_in(folder / "near.xml"));
}

TEST_CASE("a lens that bends: labels are those of the picture as it came") {
  const TemporaryFolder folder;
  planes_room::write_sequence(folder / "room", 0, 0);
  std::string camera = planes_room::camera_json();
  camera.insert(1, "\"k1\": 0.02, ");
  folder.put("room/camera.json", camera);
  CHECK(run_program({"planes", (folder / "room").string(), "--labels", (folder / "labels").string()}).code ==
        0);
  const auto labels = read_depth_image(folder / "labels/0.png");
  REQUIRE(labels);
  CHECK(labels->size() == Size{160, 120});
}

TEST_CASE("frames without readings have no planes") {
  const TemporaryFolder folder;
  planes_room::write_sequence(folder / "room", 0, 1);
  for (const char* name : {"room/depth/0.png", "room/depth/1.png"})
    REQUIRE(write_png16(folder / name, Image<std::uint16_t>(Size{160, 120})));
  for (const char* method : {"ransac", "hough", "both"}) {
    const Run run = run_program({"planes", (folder / "room").string(), "--method", method, "-o",
                                 (folder / "m.xml").string(), "--labels", (folder / "labels").string(),
                                 "--html", (folder / "m.html").string(), "--svg", (folder / "m.svg").string(),
                                 "--ply", (folder / "m.ply").string(), "--strict"});
    INFO(method << run.err);
    CHECK(run.code == 0);
  }
  CHECK(planes_in(folder / "m.xml") == 0);
  CHECK(planes_in(folder / "m-hough.xml") == 0);
}

TEST_CASE("a cloud's points get their labels in their order") {
  const TemporaryFolder folder;
  const int side = 60;
  const std::string cloud = folder.put("corner.ply", planes_room::corner_ply(side)).string();
  for (const std::string method : {"ransac", "hough"}) {
    const std::string ply = (folder / "out.ply").string(), xml = (folder / "m.xml").string();
    const Run run = run_program({"planes", cloud, "--ply", ply, "-o", xml, "--method", method, "--html",
                                 (folder / "v.html").string()});
    INFO(method << ": " << run.err);
    REQUIRE(run.code == 0);
    const auto map = read_plane_map(xml);
    REQUIRE(map);
    CHECK(map->planes.size() == 2);
    const std::string bytes = bytes_of(ply);
    CHECK(bytes.find("element vertex 7200\n") != std::string::npos);
    const std::size_t data = bytes.find("end_header\n") + 11;
    REQUIRE(bytes.size() == data + 19 * 7200);
    int right = 0;
    for (std::size_t i = 0; i < 7200; ++i) {
      const auto label = static_cast<unsigned char>(bytes[data + 19 * i + 15]);
      if (label == 0 || label > map->planes.size()) continue;
      const Vector3& n = map->planes[label - 1U].plane.normal;
      right += i < 3600 ? n.z > 0.99 : n.x > 0.99;
    }
    CHECK(right > 7100);
  }
}

TEST_CASE("clouds with nothing to find") {
  std::vector<Vector3> equal(500, Vector3{1, 2, 3}), line, plane, two = {{0, 0, 1}, {1, 0, 1}};
  for (int i = 0; i < 900; ++i) {
    line.push_back({0.01 * i, 0.02 * i, 1});
    plane.push_back({0.05 * (i % 30), 0.05 * (i / 30), 2});
  }
  CHECK(planes_of_cloud("equal.ply", planes_room::ply_of(equal)) == Counts{0, 0});
  CHECK(planes_of_cloud("line.ply", planes_room::ply_of(line)) == Counts{0, 0});
  CHECK(planes_of_cloud("two.ply", planes_room::ply_of(two)) == Counts{0, 0});
  CHECK(planes_of_cloud("none.ply", planes_room::ply_of({})) == Counts{0, 0});
  CHECK(planes_of_cloud("plane.ply", planes_room::ply_of(plane)) == Counts{1, 1});
}

TEST_CASE("points that are no numbers are no points") {
  std::string text = planes_room::corner_ply(40);
  text.replace(text.find("3200"), 4, "3203");
  text += "nan nan nan\n1 inf 2\n1 2 -inf\n";
  CHECK(planes_of_cloud("holes.ply", text) == Counts{2, 2});
}

TEST_CASE("lists and unknown properties are passed over") {
  std::string text = planes_room::corner_ply(40);
  text.insert(text.find("end_header"), "element face 1\nproperty list uchar int vertex_indices\n");
  text += "3 0 1 2\n";
  CHECK(planes_of_cloud("faces.ply", text) == Counts{2, 2});
}
