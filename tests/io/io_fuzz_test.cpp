// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <random>
#include <string>

#include "catch.hpp"
#include "mutated.hpp"
#include "png_maker.hpp"
#include "random_line_map.hpp"
#include "straightedge/host/csv.hpp"
#include "straightedge/host/image_file.hpp"
#include "straightedge/host/map_file.hpp"
#include "straightedge/host/ros_map.hpp"
#include "straightedge/host/svg.hpp"
#include "temporary_folder.hpp"

using namespace straightedge;

namespace {

constexpr std::uint32_t seed = 25;

void expect_sentence(const Failure& failure, int round) {
  INFO("seed " << seed << ", round " << round << ": " << failure.sentence);
  REQUIRE_FALSE(failure.sentence.empty());
  REQUIRE(failure.problem != Problem::internal);
}

}  // namespace

TEST_CASE("mutated maps are read or refused; what is read can be written and drawn") {
  std::mt19937 generator(seed);
  RandomLineMaps maps(seed);
  int read = 0;
  for (int round = 0; round < 4000; ++round) {
    const std::string good = *line_map_to_xml(round % 2 == 0 ? small_line_map() : maps.next());
    const auto map = line_map_from_xml(mutated(good, generator), "m.xml");
    if (!map) {
      expect_sentence(map.failure(), round);
      continue;
    }
    ++read;
    INFO("seed " << seed << ", round " << round);
    const auto xml = line_map_to_xml(*map);
    REQUIRE(xml);
    REQUIRE(*line_map_to_xml(*line_map_from_xml(*xml, "m.xml")) == *xml);
    REQUIRE(!line_map_to_csv(*map).empty());
    (void)line_map_to_svg(*map);
    (void)to_metres(*map);
  }
  CHECK(read > 100);
}

TEST_CASE("mutated pictures are read or refused") {
  std::mt19937 generator(seed);
  Image<std::uint8_t> picture({16, 12}, 90);
  picture.at(3, 3) = 7;
  const std::string rows(13 * 4, '\2');
  const std::string files[] = {*encode_png(picture),
                               png_maker::png(4, 4, 8, png_maker::rgb, rows),
                               png_maker::png(6, 4, 16, png_maker::gray, rows),
                               "P5 # c\n4 3 255\nabcdefghijkl",
                               "P2 4 3 1000\n1 2 3 4 5 6 7 8 9 10 11 12\n",
                               "P6 2 2 65535\nabcdefghijklmnopqrstuvwx",
                               bytes_of(STRAIGHTEDGE_FIXTURES "/images/blox.jpg")};
  for (int round = 0; round < 7000; ++round) {
    const auto image = decode_gray_image(mutated(files[round % 7], generator), "x.png");
    if (!image) {
      expect_sentence(image.failure(), round);
    } else {
      REQUIRE(image->width() > 0);
    }
  }
}

TEST_CASE("mutated YAML is read or refused") {
  std::mt19937 generator(seed);
  const TemporaryFolder folder;
  const std::string good =
      "image: floor.pgm\nresolution: 0.05\norigin: [-12.5, 3.0, 0.1]\nnegate: 0\noccupied_thresh: 0.65\n"
      "free_thresh: 0.196\nmode: scale\n";
  for (int round = 0; round < 3000; ++round) {
    const auto map = read_ros_map(folder.put("map.yaml", mutated(good, generator)));
    if (!map) {
      expect_sentence(map.failure(), round);
    } else {
      REQUIRE(map->placement.resolution > 0);
    }
  }
}
