// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/csv.hpp"

#include "catch.hpp"
#include "random_line_map.hpp"
#include "temporary_folder.hpp"

using namespace straightedge;

TEST_CASE("one row a segment under the names of the columns") {
  LineMap map = small_line_map();
  map.lines[1].segments[0].pixels.reset();
  CHECK(line_map_to_csv(map) ==
        "x0,y0,x1,y1,line,rho,theta,width,votes,pixels\n"
        "120.5,101.25,-113.5,101.25,3,101.25,1.5707963267948966,2.1,312,229\n"
        "-120.5,101.25,-150.5,101.25,3,101.25,1.5707963267948966,2.1,312,30\n"
        "20,-60,20,80,5,20,0,,,\n");
  CHECK(line_map_to_csv({}) == "x0,y0,x1,y1,line,rho,theta,width,votes,pixels\n");
}

TEST_CASE("the file holds the text; an unwritable one is a sentence") {
  const TemporaryFolder folder;
  REQUIRE(write_csv(folder / "m.csv", small_line_map()));
  CHECK(bytes_of(folder / "m.csv") == line_map_to_csv(small_line_map()));
  const auto nowhere = write_csv(folder / "missing/m.csv", {});
  REQUIRE_FALSE(nowhere);
  CHECK(nowhere.failure().problem == Problem::cannot_write);
}
