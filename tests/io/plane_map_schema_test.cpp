// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <string>

#include "catch.hpp"
#include "random_plane_map.hpp"
#include "schema_check.hpp"
#include "straightedge/host/plane_map_file.hpp"
#include "temporary_folder.hpp"

using namespace straightedge;

TEST_CASE("planes that are written keep the schema") {
  if (!xmllint_is_there()) return;
  const TemporaryFolder folder;
  RandomPlaneMaps maps(33);
  std::string files;
  for (int i = 0; i < 60; ++i) {
    const auto file = folder / std::to_string(i).append(".xml");
    REQUIRE(write_plane_map(file, maps.next()));
    files.append(" ").append(file.string());
  }
  REQUIRE(write_plane_map(folder / "small.xml", small_plane_map()));
  REQUIRE(write_plane_map(folder / "empty.xml", PlaneMap{}));
  PlaneMap extreme = small_plane_map();
  extreme.planes[1].plane.distance = -0.0;
  extreme.planes[0].moments->weight = 5e-324;
  extreme.planes[0].covariance->at(9) = 1e300;
  extreme.planes[0].points = ~std::uint64_t{0};
  REQUIRE(write_plane_map(folder / "extreme.xml", extreme));
  for (const char* name : {"small.xml", "empty.xml", "extreme.xml"})
    files.append(" ").append((folder / name).string());
  CHECK(keeps_the_schema(files));
}

TEST_CASE("the schema refuses planes that the reader refuses") {
  if (!xmllint_is_there()) return;
  const TemporaryFolder folder;
  const std::string good = *plane_map_to_xml(small_plane_map());
  const auto refuses = [&](const std::string& what, const std::string& by) {
    INFO(what << " -> " << by);
    std::string text = good;
    REQUIRE(text.find(what) != std::string::npos);
    text.replace(text.find(what), what.size(), by);
    CHECK_FALSE(keeps_the_schema(folder.put("bad.xml", text).string()));
    CHECK_FALSE(plane_map_from_xml(text, "bad.xml"));
  };
  refuses("version=\"1\" kind", "version=\"2\" kind");
  refuses("kind=\"planes\"", "kind=\"dots\"");
  refuses("nz=\"1\"", "nz=\"NaN\"");
  refuses("nz=\"1\"", "");
  refuses("nz=\"1\"", "nz=\"1.5\"");
  refuses("d=\"0.75\"", "d=\"-0.75\"");
  refuses("0.00025\"", "\"");
  refuses("weight=\"2500.5\"", "weight=\"-1\"");
  refuses("mean=\"0.1 ", "mean=\"");
  refuses("scatter=\"1 ", "scatter=\"1 1 ");
  refuses("hole=\"true\"", "hole=\"yes\"");
  refuses("<v x=\"0.2\" y=\"0.1\" z=\"0.75\"/>", "");
  refuses("<v x=\"0.2\"", "<v");
  refuses("seen=\"+\"", "seen=\"up\"");
  refuses("points=\"18231\"", "points=\"-5\"");
  refuses("<plane id=\"5\"", "<plane id=\"3\"");
  refuses("<frame origin=\"world\" unit=\"metre\"/>", "");
}
