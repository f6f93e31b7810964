// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "io/random_line_map.hpp"
#include "planes_room.hpp"
#include "straightedge/host/map_file.hpp"
#include "straightedge/host/plane_map_file.hpp"
#include "support/catch.hpp"

using namespace straightedge;

namespace {

/// Maps and leaves of the first frames, of the last ones, and of all.
struct Maps : TemporaryFolder {
  Maps() {
    make("a", 0, 2);
    make("b", 3, 4);
    make("all", 0, 4);
  }
  void make(const std::string& name, int first, int last) const {
    planes_room::write_sequence(*this / name, first, last);
    // With this seed the strip of ceiling, six pixels high, is found in all frames.
    const Run run = run_program(
        {"planes", file(name), "-o", file(name + ".xml"), "--leaves", file(name + ".leaves"), "--seed", "2"});
    INFO(run.err);
    REQUIRE(run.code == 0);
  }
  std::string file(const std::string& name) const { return (*this / name).string(); }
  std::vector<MapPlane> planes(const std::string& name) const {
    const auto map = read_plane_map(file(name));
    REQUIRE(map);
    return map->planes;
  }
};

}  // namespace

TEST_CASE("maps merged with their leaves are the map of all frames") {
  const Maps maps;
  const Run run = run_program({"merge", maps.file("a.xml"), maps.file("b.xml"), "--leaves",
                               maps.file("a.leaves"), maps.file("b.leaves"), "-o", maps.file("c.xml"),
                               "--leaves-output", maps.file("c.leaves"), "--json"});
  INFO(run.err);
  REQUIRE(run.code == 0);
  CHECK(maps.planes("c.xml") == maps.planes("all.xml"));
  CHECK((bytes_of(maps.file("c.leaves")) == bytes_of(maps.file("all.leaves"))));
  const auto numbers = nlohmann::json::parse(run.out);
  CHECK(numbers["exact"] == true);
  CHECK(numbers["planes"] == maps.planes("all.xml").size());
  // The order of the maps does not matter to the planes.
  REQUIRE(run_program({"merge", maps.file("b.xml"), maps.file("a.xml"), "--leaves", maps.file("b.leaves"),
                       maps.file("a.leaves"), "-o", maps.file("d.xml")})
              .code == 0);
  CHECK(maps.planes("d.xml") == maps.planes("all.xml"));
}

TEST_CASE("maps merged by their moments have the planes of all frames") {
  const Maps maps;
  const Run run = run_program({"merge", maps.file("a.xml"), maps.file("b.xml"), "-o", maps.file("c.xml")});
  INFO(run.err);
  REQUIRE(run.code == 0);
  CHECK(run_program({"validate", maps.file("c.xml")}).code == 0);
  const auto merged = maps.planes("c.xml"), all = maps.planes("all.xml");
  REQUIRE(merged.size() == all.size());
  for (const MapPlane& plane : all) {
    CHECK(std::any_of(merged.begin(), merged.end(), [&](const MapPlane& other) {
      return length(cross(plane.plane.normal, other.plane.normal)) < 0.005 &&
             std::abs(other.plane.signed_distance(plane.moments->mean)) < 0.005;
    }));
  }
  const std::string text = bytes_of(maps.file("c.xml"));
  CHECK(text.find("merged by moments; of a.xml, b.xml") != std::string::npos);
}

TEST_CASE("merges that make no sense") {
  const Maps maps;
  const std::string a = maps.file("a.xml"), b = maps.file("b.xml"), out = maps.file("c.xml");
  const std::string lines = maps.put("lines.xml", *line_map_to_xml(small_line_map())).string();
  CHECK(refusal(run_program({"merge", a, lines, "-o", out}), 5, lines).find("map of lines") !=
        std::string::npos);
  refusal(run_program({"merge", a, "-o", out}), 2, a);
  refusal(run_program({"merge", a, b, "-o", out, "--leaves", maps.file("a.leaves")}), 2, "--leaves");
  refusal(run_program({"merge", a, b, "-o", out, "--leaves", maps.file("a.leaves"), b}), 5, b);
  refusal(run_program({"merge", a, b, "-o", out, "--leaves", maps.file("a.leaves"), "/nowhere/l"}), 3,
          "/nowhere/l");
  refusal(run_program({"merge", a, b, "-o", out, "--leaves-output", maps.file("c.leaves")}), 2,
          "--leaves-output");
  refusal(run_program({"merge", a, b, "-o", out, "--min-points", "9"}), 2, "--min-points");
  refusal(run_program({"merge", a, b, "-o", a}), 2, a);
  refusal(run_program({"merge", a, maps.file("none.xml"), "-o", out}), 3, "none.xml");
  CHECK_FALSE(std::filesystem::exists(out));
}

TEST_CASE("a plane map is shown as drawing, page and triangles, and checked") {
  const TemporaryFolder folder;
  planes_room::write_sequence(folder / "room", 0, 1);
  const auto file = [&](const std::string& name) { return (folder / name).string(); };
  REQUIRE(run_program({"planes", file("room"), "-o", file("m.xml"), "--ply-polygons", file("p.ply")}).code ==
          0);
  CHECK(run_program({"show", file("m.xml"), "-o", file("m.svg")}).code == 0);
  CHECK(bytes_of(file("m.svg")).find("<svg") != std::string::npos);
  CHECK(run_program({"show", file("m.xml"), "-o", "-", "--quiet"}).out == bytes_of(file("m.svg")));
  CHECK(run_program({"show", "-", "-o", "-", "--quiet"}, {.standard_input = file("m.xml")}).out ==
        bytes_of(file("m.svg")));
  CHECK(run_program({"show", file("m.xml"), "-o", file("y.svg"), "--up", "y"}).code == 0);
  CHECK(bytes_of(file("y.svg")) != bytes_of(file("m.svg")));
  CHECK(run_program({"show", file("m.xml"), "-o", file("m.html")}).code == 0);
  CHECK(bytes_of(file("m.html")).starts_with("<!"));
  CHECK(run_program({"show", file("m.xml"), "-o", file("m.ply")}).code == 0);
  CHECK((bytes_of(file("m.ply")) == bytes_of(file("p.ply"))));
  const Run run = run_program({"validate", file("m.xml"), "--json"});
  CHECK(run.code == 0);
  CHECK(nlohmann::json::parse(run.out)["planes"].get<int>() >= 3);
  std::string broken = bytes_of(file("m.xml"));
  broken.replace(broken.find("<plane id=\"2\""), 13, "<plane id=\"1\"");
  refusal(run_program({"validate", folder.put("bad.xml", broken).string()}), 5, "bad.xml");
}

TEST_CASE("a line map is drawn as SVG alone") {
  const TemporaryFolder folder;
  const std::string map = folder.put("lines.xml", *line_map_to_xml(small_line_map())).string();
  refusal(run_program({"show", map, "-o", (folder / "m.html").string()}), 2, map);
  refusal(run_program({"show", map, "-o", (folder / "m.ply").string()}), 2, map);
  refusal(run_program({"show", map, "-o", (folder / "m.svg").string(), "--up", "z"}), 2, map);
  CHECK(names_in(folder) == std::vector<std::string>{"lines.xml"});
}
