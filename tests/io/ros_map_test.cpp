// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/ros_map.hpp"

#include <locale>
#include <string>

#include "catch.hpp"
#include "straightedge/host/image_file.hpp"
#include "support/replaced.hpp"
#include "temporary_folder.hpp"

using namespace straightedge;

namespace {

const std::string good =
    "image: floor.pgm\nresolution: 0.05\norigin: [-12.5, 3.0, 0.1]\nnegate: 0\noccupied_thresh: 0.65\n"
    "free_thresh: 0.196\n";

std::string replaced(const std::string& what, const std::string& by) {
  return ::replaced(good, what, by);
}

void refused(const std::string& text, const std::string& sentence) {
  const TemporaryFolder folder;
  const auto file = folder.put("map.yaml", text);
  const auto map = read_ros_map(file);
  INFO(text.substr(0, 200));
  REQUIRE_FALSE(map);
  CHECK(map.failure().problem == Problem::bad_content);
  CHECK(map.failure().sentence == file.string() + ": " + sentence);
}

struct Comma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  std::string do_grouping() const override { return "\3"; }
  char do_thousands_sep() const override { return '.'; }
};

}  // namespace

TEST_CASE("a map's YAML is read, its image beside it") {
  const TemporaryFolder folder;
  const auto map = read_ros_map(folder.put("map.yaml", good));
  REQUIRE(map);
  CHECK(map->image == folder / "floor.pgm");
  CHECK(map->placement == MapPlacement{0.05, -12.5, 3.0, 0.1});
  CHECK(map->meaning == RosMeaning{false, 0.65, 0.196, RosMapMode::trinary});
}

TEST_CASE("the other notations of YAML mean the same") {
  const TemporaryFolder folder;
  const auto map =
      read_ros_map(folder.put("map.yaml",
                              "# a comment\n---\nmode: raw\nimage: \"/abs/floor 1.png\"\nresolution: "
                              "5e-2\norigin:\n  - -1\n  - +2.\n  - .5\n"
                              "negate: true\noccupied_thresh: 1\nfree_thresh: 0\nmystery: {a: [1, 2]}\n"));
  if (!map) FAIL(map.failure().sentence);
  CHECK(map->image == "/abs/floor 1.png");
  CHECK(map->placement == MapPlacement{0.05, -1, 2, 0.5});
  CHECK(map->meaning == RosMeaning{true, 1, 0, RosMapMode::raw});
}

TEST_CASE("a comma locale changes nothing") {
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
  const TemporaryFolder folder;
  const auto map = read_ros_map(folder.put("map.yaml", replaced("0.05", "1234.5")));
  std::locale::global(before);
  REQUIRE(map);
  CHECK(map->placement.resolution == 1234.5);
}

TEST_CASE("each shipped map is read and its picture opens") {
  for (const char* name : {"mrpt", "mrpt_corridor", "mrpt_malaga"}) {
    const auto map = read_ros_map(std::string(STRAIGHTEDGE_FIXTURES) + "/maps/" + name + "/map.yaml");
    REQUIRE(map);
    CHECK(map->placement.resolution > 0);
    CHECK(read_gray_image(map->image));
  }
}

TEST_CASE("wrong YAML is one sentence that names the key") {
  refused("", "is not the YAML of a map: it has no keys");
  refused("just a text", "is not the YAML of a map: it has no keys");
  refused("- 1\n- 2\n", "is not the YAML of a map: it has no keys");
  refused(replaced("image: floor.pgm\n", ""), "has no `image`");
  refused(replaced("resolution: 0.05\n", ""), "has no `resolution`");
  refused(replaced("origin: [-12.5, 3.0, 0.1]\n", ""), "has no `origin`");
  refused(replaced("negate: 0\n", ""), "has no `negate`");
  refused(replaced("free_thresh: 0.196\n", ""), "has no `free_thresh`");
  refused(replaced("floor.pgm", ""), "has no `image`");
  refused(replaced("floor.pgm", "[a, b]"), "`image` is not a single value");
  refused(replaced("0.05", "five"), "`resolution` is not a finite number (five)");
  refused(replaced("0.05", ".nan"), "`resolution` is not a finite number (.nan)");
  refused(replaced("0.05", "nan"), "`resolution` is not a finite number (nan)");
  refused(replaced("0.05", "1e999"), "`resolution` is not a finite number (1e999)");
  refused(replaced("0.05", "0"), "`resolution` is not above zero");
  refused(replaced("0.05", "-0.05"), "`resolution` is not above zero");
  refused(replaced("[-12.5, 3.0, 0.1]", "[1, 2]"), "`origin` is not a list of x, y and yaw");
  refused(replaced("[-12.5, 3.0, 0.1]", "7"), "`origin` is not a list of x, y and yaw");
  refused(replaced("[-12.5, 3.0, 0.1]", "[1, inf, 3]"), "`origin` is not a finite number (inf)");
  refused(replaced("[-12.5, 3.0, 0.1]", "[1, 2, 1e9]"), "the yaw of `origin` is outside of ±1000 radians");
  refused(replaced("negate: 0", "negate: maybe"), "`negate` is neither 0 nor 1");
  refused(replaced("0.65", "1.5"), "`occupied_thresh` is outside of 0 to 1");
  refused(replaced("0.196", "-0.1"), "`free_thresh` is outside of 0 to 1");
  refused(replaced("0.196", "0.7"), "`free_thresh` is above `occupied_thresh`");
  refused(good + "mode: fancy\n", "`mode` is none of trinary, scale and raw");
  refused(good + std::string(100000, '#'), "is longer than the 65536 bytes that are read of such a file");
}

TEST_CASE("text that is no YAML is refused with its line") {
  const TemporaryFolder folder;
  for (const std::string& text :
       {good + "a: [1, 2\n", std::string("image: \"floor\n"), std::string(60000, '['),
        std::string(60000, '{'), std::string("\x01\x02\xFF", 3)}) {
    const auto file = folder.put("map.yaml", text);
    const auto map = read_ros_map(file);
    INFO(text.substr(0, 60));
    REQUIRE_FALSE(map);
    CHECK(map.failure().problem == Problem::bad_content);
    CHECK(map.failure().sentence.starts_with(file.string() + ": "));
  }
  const auto missing = read_ros_map(folder / "no.yaml");
  REQUIRE_FALSE(missing);
  CHECK(missing.failure().problem == Problem::cannot_read);
}
