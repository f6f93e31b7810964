// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <bit>
#include <cstdint>
#include <limits>
#include <locale>
#include <string>

#include "catch.hpp"
#include "random_line_map.hpp"
#include "straightedge/host/map_file.hpp"
#include "temporary_folder.hpp"

using namespace straightedge;

namespace {

std::string xml_of(const LineMap& map) {
  const auto xml = line_map_to_xml(map);
  if (!xml) FAIL(xml.failure().sentence);
  return *xml;
}

LineMap map_of(const std::string& xml) {
  const auto map = line_map_from_xml(xml, "m.xml");
  if (!map) FAIL(map.failure().sentence);
  return *map;
}

struct Comma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  std::string do_grouping() const override { return "\3"; }
  char do_thousands_sep() const override { return '.'; }
};

}  // namespace

TEST_CASE("the file looks as its description says") {
  CHECK(xml_of(small_line_map()) ==
        R"(<?xml version="1.0" encoding="UTF-8"?>
<map format="straightedge-map" version="1" kind="lines">
    <meta name="floor 4" tool="straightedge 0.1" options="lines floor4.png --seed 1"/>
    <frame origin="image-centre" x="right" y="up" unit="pixel" angle="radian"/>
    <image file="floor4.png" width="640" height="400" resolution="0.05" origin-x="-12" origin-y="-25" origin-yaw="0" negate="0" occupied-thresh="0.65" free-thresh="0.196" mode="trinary"/>
    <line id="3" rho="101.25" theta="1.5707963267948966" votes="312" width="2.1" free="both">
        <covariance at-x="3.5" at-y="101.25" var-theta="2.9e-06" var-offset="0.04"/>
        <segment id="10" x0="120.5" y0="101.25" x1="-113.5" y1="101.25" pixels="229"/>
        <segment id="11" x0="-120.5" y0="101.25" x1="-150.5" y1="101.25" pixels="30"/>
    </line>
    <line id="5" rho="20" theta="0" free="-">
        <segment id="12" x0="20" y0="-60" x1="20" y1="80" pixels="140"/>
    </line>
</map>
)");
}

TEST_CASE("random maps: read gives what was written, and writing again the same bytes") {
  const std::uint32_t seed = 21;
  RandomLineMaps maps(seed);
  for (int i = 0; i < 300; ++i) {
    INFO("seed " << seed << ", map " << i);
    const LineMap map = maps.next();
    const std::string xml = xml_of(map);
    const LineMap back = map_of(xml);
    REQUIRE(back == map);
    REQUIRE(xml_of(back) == xml);
  }
}

TEST_CASE("doubles keep their bits: minus zero, denormals, 1e300") {
  LineMap map;
  MapLine line;
  line.rho = 1e300;
  line.theta = -0.0;
  line.width = std::numeric_limits<double>::denorm_min();
  line.covariance = LineCovariance{-0.0, 1.7976931348623157e308, 2.2250738585072014e-308, 5e-324};
  line.segments = {{0, 1e300, -0.0, 1e300, 5e-324, {}}};
  map.lines = {line};
  const MapLine back = map_of(xml_of(map)).lines[0];
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
  CHECK(bits(back.rho) == bits(1e300));
  CHECK(bits(back.theta) == bits(-0.0));
  CHECK(bits(*back.width) == 1);
  CHECK(bits(back.covariance->at_x) == bits(-0.0));
  CHECK(bits(back.covariance->at_y) == bits(1.7976931348623157e308));
  CHECK(bits(back.covariance->var_theta) == bits(2.2250738585072014e-308));
  CHECK(bits(back.covariance->var_offset) == 1);
  CHECK(bits(back.segments[0].y0) == bits(-0.0));
  CHECK(bits(back.segments[0].y1) == 1);
}

TEST_CASE("a comma locale changes no byte") {
  const std::string xml = xml_of(small_line_map());
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
  const bool installed = std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr;
  const std::string again = xml_of(small_line_map());
  const LineMap back = map_of(again);
  std::setlocale(LC_ALL, "C");
  std::locale::global(before);
  INFO("de_DE installed: " << installed);
  CHECK(again == xml);
  CHECK(back == small_line_map());
}

TEST_CASE("unknown elements and attributes, comments and other orders are passed over") {
  const LineMap map = map_of(
      "<?xml version=\"1.0\"?><!-- by hand --><map extra=\"1\" kind=\"lines\" version=\"1\" "
      "format=\"straightedge-map\"><future a=\"b\"><line id=\"x\"/></future><line colour=\"red\" theta=\"0\" "
      "rho=\"2\" "
      "id=\"7\"><note>text</note><segment y1=\"1\" x1=\"2\" y0=\"-1\" x0=\"2\" id=\"0\" z=\"?\"/></line>"
      "<frame unit=\"metre\"/></map>");
  CHECK(map.unit == MapUnit::metre);
  REQUIRE(map.lines.size() == 1);
  CHECK(map.lines[0].id == 7);
  CHECK(map.lines[0].segments.size() == 1);
}

TEST_CASE("texts that XML cannot hold are written as it can, and stay so") {
  LineMap map;
  map.meta.name = "caf\xE9\n\"<&>'";
  map.lines.resize(1);
  map.lines[0].source = "";
  const std::string xml = xml_of(map);
  const LineMap back = map_of(xml);
  CHECK(back.meta.name == "caf\xEF\xBF\xBD \"<&>'");
  CHECK(back.lines[0].source == "");
  CHECK(xml_of(back) == xml);
}

TEST_CASE("through a file, and an unwritable file is a sentence") {
  const TemporaryFolder folder;
  REQUIRE(write_line_map(folder / "m.xml", small_line_map()));
  const auto back = read_line_map(folder / "m.xml");
  REQUIRE(back);
  CHECK(*back == small_line_map());
  const auto nowhere = write_line_map(folder / "missing/m.xml", small_line_map());
  REQUIRE_FALSE(nowhere);
  CHECK(nowhere.failure().problem == Problem::cannot_write);
  LineMap bad = small_line_map();
  bad.lines[0].rho = -1;
  const auto refused = write_line_map(folder / "m.xml", bad);
  REQUIRE_FALSE(refused);
  CHECK(read_line_map(folder / "m.xml"));
}
