// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <string>

#include "catch.hpp"
#include "random_line_map.hpp"
#include "schema_check.hpp"
#include "straightedge/host/map_file.hpp"
#include "support/replaced.hpp"
#include "temporary_folder.hpp"

using namespace straightedge;

namespace {}  // namespace

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
  CHECK(keeps_the_schema(files));
}

TEST_CASE("the schema refuses what the reader refuses") {
  if (!xmllint_is_there()) return;
  const TemporaryFolder folder;
  const std::string good = *line_map_to_xml(small_line_map());
  const auto refuses = [&](const std::string& what, const std::string& by) {
    INFO(what << " -> " << by);
    CHECK_FALSE(keeps_the_schema(folder.put("bad.xml", replaced(good, what, by)).string()));
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
}
