// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>
#include <set>

#include "planes_room.hpp"
#include "straightedge/host/depth_file.hpp"
#include "straightedge/host/plane_map_file.hpp"
#include "support/catch.hpp"

using namespace straightedge;

namespace {

struct RoomFolder : TemporaryFolder {
  RoomFolder() { planes_room::write_sequence(room()); }
  std::filesystem::path room() const { return *this / "room"; }
  std::string out(const std::string& name) const { return (*this / name).string(); }
};

Run planes(const RoomFolder& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"planes", folder.room().string()});
  Run run = run_program(arguments);
  INFO(run.err);
  CHECK(run.code == 0);
  return run;
}

PlaneMap map_in(const std::string& file) {
  auto map = read_plane_map(file);
  REQUIRE(map);
  return *map;
}

/// The face of the room that a plane lies on, 0 to 5; −1: none.
int face_of(const Plane& plane) {
  const Vector3& n = plane.normal;
  const auto near = [](double a, double b, double tolerance) { return std::abs(a - b) < tolerance; };
  if (near(std::abs(n.x), 1, 1e-3) && near(plane.distance, 2, 0.01)) return n.x > 0 ? 0 : 1;
  if (near(std::abs(n.y), 1, 1e-3) && near(plane.distance, 1.5, 0.01)) return n.y > 0 ? 2 : 3;
  if (near(std::abs(n.z), 1, 1e-3) && near(plane.distance, 0, 0.01)) return 4;
  if (near(n.z, 1, 1e-3) && near(plane.distance, 2.5, 0.01)) return 5;
  return -1;
}

const std::vector<std::string> methods = {"ransac", "hough"};

}  // namespace

TEST_CASE("a look around a room is one plane a face") {
  const RoomFolder folder;
  for (const std::string& method : methods) {
    INFO(method);
    const std::string xml = folder.out(method + ".xml");
    const Run run = planes(folder, {"-o", xml, "--method", method, "--seed", "7"});
    CHECK(run.out.empty());
    CHECK(run.err.find("5 frames of 160 x 120 pixels") != std::string::npos);
    CHECK(run.err.find("written: " + xml) != std::string::npos);
    const PlaneMap map = map_in(xml);
    std::set<int> faces;
    for (const MapPlane& plane : map.planes) {
      CHECK(face_of(plane.plane) >= 0);
      CHECK(faces.insert(face_of(plane.plane)).second);
      CHECK(plane.source == method);
      CHECK_FALSE(plane.polygons.empty());
    }
    CHECK(faces.size() >= 5);
    CHECK(map.meta.name == "room");
    CHECK(map.meta.tool == "straightedge " STRAIGHTEDGE_VERSION);
    CHECK(map.meta.options.find("seed 7; of room") != std::string::npos);
    CHECK(map.meta.created.empty());
    CHECK(run_program({"validate", xml}).code == 0);
  }
}

TEST_CASE("label pictures name the plane that a pixel lies on") {
  const RoomFolder folder;
  const std::string xml = folder.out("m.xml"), labels = folder.out("labels");
  planes(folder, {"-o", xml, "--labels", labels});
  const PlaneMap map = map_in(xml);
  const DepthCamera camera = planes_room::camera();
  for (int i = 0; i < planes_room::frames; ++i) {
    const auto picture = read_depth_image(labels + "/" + std::to_string(i) + ".png");
    REQUIRE(picture);
    const Pose pose = planes_room::pose(0.4 * i);
    const Image<std::uint16_t> depth = planes_room::depth(pose);
    REQUIRE(picture->size() == depth.size());
    int labelled = 0;
    for (int v = 0; v < depth.height(); ++v) {
      for (int u = 0; u < depth.width(); ++u) {
        const std::uint16_t id = picture->at(u, v);
        if (id == 0) continue;
        ++labelled;
        REQUIRE(id <= map.planes.size());
        REQUIRE(map.planes[id - 1].id == id);
        const double z = depth.at(u, v) * camera.metres_per_unit();
        const Vector3 world = pose.apply(z * camera.pinhole.ray(u, v));
        REQUIRE(std::abs(map.planes[id - 1].plane.signed_distance(world)) < 0.06);
      }
    }
    CHECK(labelled > 0.95 * depth.width() * depth.height());
  }
  CHECK(std::distance(std::filesystem::directory_iterator(labels), {}) == planes_room::frames);
  CHECK(names_in(folder) == std::vector<std::string>{"labels", "m.xml", "room"});
}

TEST_CASE("labels go into a folder that is there, beside what is in it") {
  const RoomFolder folder;
  std::filesystem::create_directory(folder / "labels");
  folder.put("labels/0.png", "old");
  folder.put("labels/other.txt", "stays");
  planes(folder, {"--labels", folder.out("labels")});
  CHECK(read_depth_image(folder / "labels/0.png"));
  CHECK(bytes_of(folder / "labels/other.txt") == "stays");
}

TEST_CASE("the same run gives the same bytes, whatever the order of the list") {
  const RoomFolder folder;
  const auto make = [&](const std::string& name) {
    for (const std::string& method : methods) {
      const std::string base = folder.out(name + method);
      planes(folder, {"-o", base + ".xml", "--ply", base + ".ply", "--ply-polygons", base + ".polygons.ply",
                      "--html", base + ".html", "--svg", base + ".svg", "--leaves", base + ".leaves",
                      "--labels", base + "-labels", "--method", method});
    }
  };
  make("a-");
  make("b-");
  std::string list;
  for (const int i : {3, 0, 4, 2, 1}) list += std::to_string(i) + " depth/" + std::to_string(i) + ".png\n";
  folder.put("room/depth.txt", list);
  make("c-");
  for (const std::string& method : methods) {
    for (const char* ending :
         {".xml", ".ply", ".polygons.ply", ".html", ".svg", ".leaves", "-labels/2.png"}) {
      INFO(method << ending);
      const std::string first = bytes_of(folder / ("a-" + method + ending));
      CHECK_FALSE(first.empty());
      CHECK((bytes_of(folder / ("b-" + method + ending)) == first));
      CHECK((bytes_of(folder / ("c-" + method + ending)) == first));
    }
  }
}

TEST_CASE("both methods make what each makes alone, and a table") {
  const RoomFolder folder;
  const Run both = planes(folder, {"--method", "both", "-o", folder.out("m.xml"), "--ply",
                                   folder.out("p.polygons.ply"), "--labels", folder.out("labels"), "--json"});
  for (const std::string& method : methods) {
    planes(folder, {"--method", method, "-o", folder.out("alone.xml"), "--labels", folder.out(method)});
    CHECK(bytes_of(folder / ("m-" + method + ".xml")) == bytes_of(folder / "alone.xml"));
    CHECK(bytes_of(folder / ("labels/" + method + "/1.png")) == bytes_of(folder / (method + "/1.png")));
    CHECK(bytes_of(folder / ("p-" + method + ".polygons.ply")).starts_with("ply\n"));
  }
  for (const char* row :
       {"first plane of a frame, ms", "all planes of a frame, ms", "planes of the map", "partners differ by"})
    CHECK(both.err.find(row) != std::string::npos);
  const auto numbers = nlohmann::json::parse(both.out);
  const auto& comparison = numbers["comparison"];
  for (const std::string& method : methods) {
    CHECK(comparison[method]["first_plane_ms"].get<double>() > 0);
    CHECK(comparison[method]["all_planes_ms"].get<double>() > 0);
    CHECK(comparison[method]["partnered"] == comparison[method]["map_planes"]);
  }
  CHECK(comparison["median_angle_degrees"].get<double>() < 0.2);
  CHECK(comparison["same_label_share"].get<double>() > 0.98);
}

TEST_CASE("the numbers of a run") {
  const RoomFolder folder;
  const std::string xml = folder.out("m.xml");
  const Run run = planes(folder, {"-o", xml, "--json", "--quiet", "--seed", "3"});
  CHECK(run.err.empty());
  const auto numbers = nlohmann::json::parse(run.out);
  CHECK(numbers["command"] == "planes");
  CHECK(numbers["input"] == "room");
  CHECK(numbers["seed"] == 3);
  CHECK(numbers["frames"] == planes_room::frames);
  CHECK(numbers["readings"] == 160 * 120 * planes_room::frames);
  CHECK(numbers["skipped"].empty());
  CHECK_FALSE(numbers.contains("comparison"));
  const auto& method = numbers["methods"][0];
  CHECK(method["method"] == "ransac");
  CHECK(method["map"]["planes"].size() == map_in(xml).planes.size());
  CHECK(method["frames"].size() == planes_room::frames);
  for (const auto& frame : method["frames"]) {
    std::uint64_t inliers = 0;
    for (const auto& plane : frame["planes"]) {
      CHECK(plane["id"].get<std::uint32_t>() <= method["map"]["planes"].size());
      CHECK(plane["residual"].get<double>() < 0.01);
      inliers += plane["inliers"].get<std::uint64_t>();
    }
    CHECK(inliers == frame["labelled"].get<std::uint64_t>());
  }
  CHECK(run.out.find("_ms") == std::string::npos);
}

TEST_CASE("large planes alone have the share of the frame that was asked for") {
  const RoomFolder folder;
  const auto numbers_with = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--json", "--quiet"});
    return nlohmann::json::parse(planes(folder, arguments).out);
  };
  for (const std::string& method : methods) {
    INFO(method);
    const auto all = numbers_with({"--method", method})["methods"][0];
    const auto large = numbers_with({"--method", method, "--large", "0.25"})["methods"][0];
    CHECK(all["options"].get<std::string>().find("large") == std::string::npos);
    CHECK(large["options"].get<std::string>().find("large 0.25, max-planes") != std::string::npos);
    for (std::size_t i = 0; i < planes_room::frames; ++i) {
      const auto is_large = [](const auto& plane) { return plane["inliers"] >= 160 * 120 / 4; };
      const auto& every = all["frames"][i]["planes"];
      const auto& found = large["frames"][i]["planes"];
      CHECK(std::all_of(found.begin(), found.end(), is_large));
      CHECK(static_cast<std::ptrdiff_t>(found.size()) == std::count_if(every.begin(), every.end(), is_large));
    }
  }
}

TEST_CASE("points are thinned to as many as asked for") {
  const RoomFolder folder;
  planes(folder, {"--ply", folder.out("p.ply"), "--ply-points", "5000"});
  const std::string ply = bytes_of(folder / "p.ply");
  const std::size_t at = ply.find("element vertex ") + 15;
  const int count = std::stoi(ply.substr(at, ply.find('\n', at) - at));
  CHECK(count <= 5000);
  CHECK(count > 2500);
}

TEST_CASE("an interrupted run leaves all labels or none") {
  const RoomFolder folder;
  for (int ms = 1; ms <= 61; ms += 4) {
    const Run run = run_program({"planes", folder.room().string(), "-o", folder.out("m.xml"), "--labels",
                                 folder.out("labels"), "--method", "both"},
                                {.interrupt_after_ms = ms});
    INFO(ms << " ms, " << run.err);
    CHECK((run.code == 0 || run.code == -SIGINT));
    for (const std::string& name : names_in(folder)) {
      CHECK((name == "room" || name == "labels" || name == "m-ransac.xml" || name == "m-hough.xml"));
      if (name.ends_with(".xml")) CHECK(read_plane_map(folder / name));
      if (name != "labels") continue;
      for (const std::string& method : methods) {
        for (int i = 0; i < planes_room::frames; ++i)
          CHECK(read_depth_image(folder / "labels" / method / (std::to_string(i) + ".png")));
      }
    }
    for (const char* name : {"labels", "m-ransac.xml", "m-hough.xml"})
      std::filesystem::remove_all(folder / name);
  }
}
