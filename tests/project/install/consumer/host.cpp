// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstdio>

#include <straightedge/host/depth_file.hpp>
#include <straightedge/host/image_file.hpp>
#include <straightedge/host/map_file.hpp>

// A map goes to XML and comes back; a file that is not there is a sentence, and one that is no depth.
int main() {
  straightedge::LineMap map;
  map.meta.name = "consumer";
  map.image = straightedge::MapImage{.file = "none.png", .size = {4, 3}, .placement = {}, .meaning = {}};
  const auto xml = straightedge::line_map_to_xml(map);
  if (!xml) return 1;
  const auto back = straightedge::line_map_from_xml(*xml, "memory");
  if (!back || back->meta.name != "consumer") return 1;
  const auto absent = straightedge::read_gray_image("absent.png");
  if (absent) return 1;
  const auto no_depth = straightedge::decode_depth_image("text", "memory");
  if (no_depth) return 1;
  std::printf("%s\n", no_depth.failure().sentence.c_str());
  std::printf("%s\n", absent.failure().sentence.c_str());
  return 0;
}
