// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <random>
#include <string>

#include "catch.hpp"
#include "cloud_maker.hpp"
#include "mutated.hpp"
#include "random_plane_map.hpp"
#include "straightedge/host/cloud.hpp"
#include "straightedge/host/plane_map_file.hpp"
#include "straightedge/host/ply.hpp"
#include "temporary_folder.hpp"

using namespace straightedge;

namespace {

constexpr std::uint32_t seed = 26;

const std::string ply_texts[] = {
    "ply\nformat ascii 1.0\ncomment c\nelement face 1\nproperty list uchar int i\nelement vertex 3\nproperty "
    "float x\n"
    "property list uchar float w\nproperty float y\nproperty double z\nend_header\n3 0 1 2\n1 1 5 2 3\n"
    "4 0 5 6\nnan 2 1 2 8 9\n",
    std::string(
        "ply\nformat binary_big_endian 1.0\nelement face 1\nproperty list uchar short i\nelement vertex 2\n"
        "property short x\nproperty list ushort char w\nproperty float y\nproperty double z\nend_header\n") +
        std::string("\2\0\1\0\2\0\5\0\3abc\1\2\3\4abcdefgh\0\5\0\0\1\2\3\4abcdefgh", 39),
    std::string("ply\nformat binary_little_endian 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
                "property uchar q\nproperty float z\nend_header\nabcdefghijklmnopqrstuvwxyz")};

}  // namespace

TEST_CASE("mutated clouds are read or refused") {
  std::mt19937 generator(seed);
  int read = 0;
  for (int round = 0; round < 12000; ++round) {
    std::string good = ply_texts[round % 3];
    if (round % 6 > 2) {
      cloud_maker::Pcd file;
      file.encoding = round % 6 == 3 ? "ascii" : round % 6 == 4 ? "binary" : "binary_compressed";
      if (round % 4 == 0) file.fields = {{"q", 'U', 1, 2}, {"x"}, {"y", 'F', 8}, {"z", 'I', 2}};
      good = file.bytes();
    }
    const auto cloud = cloud_from_bytes(mutated(good, generator), "c");
    INFO("seed " << seed << ", round " << round);
    if (!cloud) {
      REQUIRE_FALSE(cloud.failure().sentence.empty());
      REQUIRE(cloud.failure().problem == Problem::bad_content);
      continue;
    }
    ++read;
    REQUIRE(cloud->x.size() == cloud->z.size());
    REQUIRE((cloud->x.empty() || cloud->view().valid()));
  }
  CHECK(read > 500);
}

TEST_CASE("mutated plane maps are read or refused; what is read can be written") {
  std::mt19937 generator(seed);
  RandomPlaneMaps maps(seed);
  const TemporaryFolder folder;
  int read = 0;
  for (int round = 0; round < 4000; ++round) {
    const std::string good = *plane_map_to_xml(round % 2 == 0 ? small_plane_map() : maps.next());
    const auto map = plane_map_from_xml(mutated(good, generator), "m.xml");
    INFO("seed " << seed << ", round " << round);
    if (!map) {
      REQUIRE_FALSE(map.failure().sentence.empty());
      REQUIRE(map.failure().problem == Problem::bad_content);
      continue;
    }
    ++read;
    const auto xml = plane_map_to_xml(*map);
    REQUIRE(xml);
    REQUIRE(*plane_map_to_xml(*plane_map_from_xml(*xml, "m.xml")) == *xml);
    if (read % 8 == 0) REQUIRE(write_polygons_ply(folder / "m.ply", *map));
  }
  CHECK(read > 100);
}
