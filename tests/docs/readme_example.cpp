// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstdio>

#include <straightedge/host/image_file.hpp>
#include <straightedge/host/line_map_builder.hpp>
#include <straightedge/host/map_file.hpp>

int main(int argc, char** argv) {
  const auto image = straightedge::read_gray_image(argc > 1 ? argv[1] : "plan.png");
  if (!image) return std::fprintf(stderr, "%s\n", image.failure().sentence.c_str()), 1;
  const auto found = straightedge::build_line_map(*image);
  if (!found) return std::fprintf(stderr, "%s\n", found.failure().sentence.c_str()), 1;
  for (const auto& line : found->map.lines) {
    for (const auto& s : line.segments) std::printf("%.2f %.2f  %.2f %.2f\n", s.x0, s.y0, s.x1, s.y1);
  }
  return straightedge::write_line_map("plan.xml", found->map) ? 0 : 1;
}
