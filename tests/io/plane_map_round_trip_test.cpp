// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "catch.hpp"
#include "random_plane_map.hpp"
#include "straightedge/host/plane_map_file.hpp"
#include "temporary_folder.hpp"

using namespace straightedge;

namespace {

std::string xml_of(const PlaneMap& map) {
  const auto xml = plane_map_to_xml(map);
  if (!xml) FAIL(xml.failure().sentence);
  return *xml;
}

PlaneMap map_of(const std::string& xml) {
  const auto map = plane_map_from_xml(xml, "m.xml");
  if (!map) FAIL(map.failure().sentence);
  return *map;
}

std::uint64_t bits(double value) {
  return std::bit_cast<std::uint64_t>(value);
}

}  // namespace

TEST_CASE("the file of planes looks as its description says") {
  CHECK(xml_of(small_plane_map()) ==
        R"(<?xml version="1.0" encoding="UTF-8"?>
<map format="straightedge-map" version="1" kind="planes">
    <meta name="floor 4" tool="straightedge 0.1" options="planes room --seed 1"/>
    <frame origin="world" unit="metre"/>
    <plane id="3" nx="0" ny="0" nz="1" d="0.75" points="18231" count="12" source="ransac" seen="+">
        <covariance upper="1e-06 0 0 2e-06 1e-06 0 0 0 0 0.00025"/>
        <moments weight="2500.5" mean="0.1 -0.2 0.75" scatter="1 0.5 0 1 0 0"/>
        <polygon>
            <v x="0" y="0" z="0.75"/>
            <v x="1" y="0" z="0.75"/>
            <v x="1" y="1" z="0.75"/>
            <v x="0" y="1" z="0.75"/>
        </polygon>
        <polygon hole="true">
            <v x="0.1" y="0.1" z="0.75"/>
            <v x="0.1" y="0.2" z="0.75"/>
            <v x="0.2" y="0.1" z="0.75"/>
        </polygon>
    </plane>
    <plane id="5" nx="0" ny="0.6" nz="-0.8" d="0"/>
</map>
)");
}

TEST_CASE("random plane maps: read gives what was written, and writing again the same bytes") {
  const std::uint32_t seed = 32;
  RandomPlaneMaps maps(seed);
  for (int i = 0; i < 300; ++i) {
    INFO("seed " << seed << ", map " << i);
    const PlaneMap map = maps.next();
    const std::string xml = xml_of(map);
    const PlaneMap back = map_of(xml);
    REQUIRE(back == map);
    REQUIRE(xml_of(back) == xml);
  }
}

TEST_CASE("doubles of planes keep their bits: minus zero, denormals, 1e300") {
  const double tiny = std::numeric_limits<double>::denorm_min();
  PlaneMap map;
  MapPlane plane;
  plane.plane = {{-0.0, tiny, 1}, 1e300};
  plane.points = std::numeric_limits<std::uint64_t>::max();
  plane.covariance = {tiny, -0.0, 0, 0, tiny, 0, 0, tiny, 0, 1e300};
  plane.moments = MapMoments{1e300, {-0.0, tiny, -1e300}, {1e300, -0.0, 0, tiny, 0, 0}};
  plane.polygons = {{false, {{-0.0, 0, 1e300}, {1e300, 0, 1e300}, {0, 1e300, 1e300}}}};
  map.planes = {plane};
  const std::string xml = xml_of(map);
  const PlaneMap back = map_of(xml);
  REQUIRE(back == map);
  CHECK(bits(back.planes[0].plane.normal.x) == bits(-0.0));
  CHECK(bits(back.planes[0].plane.normal.y) == bits(tiny));
  CHECK(bits(back.planes[0].covariance->at(1)) == bits(-0.0));
  CHECK(bits(back.planes[0].moments->scatter[1]) == bits(-0.0));
  CHECK(bits(back.planes[0].polygons[0].points[0].x) == bits(-0.0));
  CHECK(xml_of(back) == xml);
}

TEST_CASE("unknown elements and attributes around planes are passed over") {
  const PlaneMap map = map_of(
      "<?xml version=\"1.0\"?><!-- by hand --><map extra=\"1\" kind=\"planes\" version=\"1\" "
      "format=\"straightedge-map\"><future><plane id=\"x\"/></future><line id=\"?\"/><image/>"
      "<plane colour=\"red\" d=\"2\" nz=\"1\" ny=\"0\" nx=\"0\" id=\"7\"><note>text</note>"
      "<polygon edge=\"soft\"><w/><v z=\"2\" y=\"0\" x=\"0\" q=\"?\"/>text<v x=\"1\" y=\"0\" z=\"2\"/>"
      "<!-- c --><v x=\"0\" y=\"1\" z=\"2\"><v/></v></polygon></plane><frame unit=\"metre\"/></map>");
  REQUIRE(map.planes.size() == 1);
  CHECK(map.planes[0].id == 7);
  REQUIRE(map.planes[0].polygons.size() == 1);
  CHECK(map.planes[0].polygons[0].points.size() == 3);
  CHECK_FALSE(map.planes[0].covariance);
}

TEST_CASE("planes through a file, and an unwritable file is a sentence") {
  const TemporaryFolder folder;
  REQUIRE(write_plane_map(folder / "m.xml", small_plane_map()));
  const auto back = read_plane_map(folder / "m.xml");
  REQUIRE(back);
  CHECK(*back == small_plane_map());
  const auto nowhere = write_plane_map(folder / "missing/m.xml", small_plane_map());
  REQUIRE_FALSE(nowhere);
  CHECK(nowhere.failure().problem == Problem::cannot_write);
  PlaneMap bad = small_plane_map();
  bad.planes[0].plane.distance = -1;
  const auto refused = write_plane_map(folder / "m.xml", bad);
  REQUIRE_FALSE(refused);
  CHECK(refused.failure().sentence.starts_with((folder / "m.xml").string() + ": the map breaks a rule"));
  CHECK(read_plane_map(folder / "m.xml"));
}

TEST_CASE("a polygon of many points") {
  PlaneMap map = small_plane_map();
  auto& points = map.planes[0].polygons[0].points;
  points.clear();
  constexpr int steps = 40000;
  for (int i = 0; i < steps; ++i) points.push_back({0.01 * i, i % 2 == 0 ? 0.0 : 0.01, 0.75});
  points.push_back({0.01 * steps, 5, 0.75});
  points.push_back({0, 5, 0.75});
  const std::string xml = xml_of(map);
  REQUIRE(map_of(xml) == map);
}
