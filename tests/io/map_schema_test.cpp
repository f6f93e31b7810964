// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <string>

#include "catch.hpp"
#include "random_line_map.hpp"
#include "straightedge/host/map_file.hpp"
#include "temporary_folder.hpp"

using namespace straightedge;

namespace {

bool xmllint_is_there() {
  return std::system("xmllint --version >/dev/null 2>&1") == 0;
}

bool validates(const std::string& files) {
  const std::string command =
      "xmllint --noout --schema " STRAIGHTEDGE_SCHEMA " " + files + " >/dev/null 2>&1";
  return std::system(command.c_str()) == 0;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  REQUIRE(text.find(what) != std::string::npos);
  return text.replace(text.find(what), what.size(), by);
}

const std::string planes = R"(<map format="straightedge-map" version="1" kind="planes">
  <frame unit="metre" origin="world"/>
  <plane id="0" nx="0" ny="0" nz="1" d="0.75" points="18231" count="12" source="kinect" seen="+">
    <covariance upper="1e-06 0 0 0 1e-06 0 0 0 0 0.0001"/>
    <moments weight="2500.5" mean="0.1 -0.2 0.75" scatter="1 0 0 1 0 0"/>
    <polygon><v x="0" y="0" z="0.75"/><v x="1" y="0" z="0.75"/><v x="0" y="1" z="0.75"/></polygon>
    <polygon hole="true"><v x="0.1" y="0.1" z="0.75"/><v x="0.1" y="0.2" z="0.75"/><v x="0.2" y="0.1" z="0.75"/></polygon>
  </plane>
</map>)";

}  // namespace

TEST_CASE("what is written keeps the schema") {
  if (!xmllint_is_there()) return;
  const TemporaryFolder folder;
  RandomLineMaps maps(22);
  std::string files;
  for (int i = 0; i < 60; ++i) {
    const auto file = folder / std::to_string(i).append(".xml");
    REQUIRE(write_line_map(file, maps.next()));
    files.append(" ").append(file.string());
  }
  REQUIRE(write_line_map(folder / "small.xml", small_line_map()));
  REQUIRE(write_line_map(folder / "metres.xml", *to_metres(small_line_map())));
  REQUIRE(write_line_map(folder / "empty.xml", LineMap{}));
  for (const char* name : {"small.xml", "metres.xml", "empty.xml"})
    files.append(" ").append((folder / name).string());
  CHECK(validates(files));
  CHECK(validates(folder.put("planes.xml", planes).string()));
}

TEST_CASE("the schema refuses what the reader refuses") {
  if (!xmllint_is_there()) return;
  const TemporaryFolder folder;
  const std::string good = *line_map_to_xml(small_line_map());
  const auto refuses = [&](const std::string& what, const std::string& by) {
    INFO(what << " -> " << by);
    CHECK_FALSE(validates(folder.put("bad.xml", replaced(good, what, by)).string()));
  };
  refuses("version=\"1\" kind", "version=\"2\" kind");
  refuses("kind=\"lines\"", "kind=\"dots\"");
  refuses("rho=\"101.25\"", "rho=\"NaN\"");
  refuses("rho=\"101.25\"", "rho=\"-1\"");
  refuses("rho=\"101.25\"", "");
  refuses("theta=\"0\"", "theta=\"3.2\"");
  refuses("resolution=\"0.05\"", "resolution=\"0\"");
  refuses("var-offset=\"0.04\"", "var-offset=\"-0.04\"");
  refuses("<line id=\"5\"", "<line id=\"3\"");
  refuses("<segment id=\"12\"", "<segment id=\"10\"");
  refuses("free=\"both\"", "free=\"left\"");
  refuses("unit=\"pixel\"", "unit=\"inch\"");
  CHECK_FALSE(validates(folder.put("bad.xml", replaced(planes, "0.0001\"", "\"")).string()));
}
