// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// From a picture to a line map with the host library: 02_lines IMAGE MAP.xml
#include <cstdio>

#include "straightedge/host/image_file.hpp"
#include "straightedge/host/line_map_builder.hpp"
#include "straightedge/host/map_file.hpp"

namespace {

int fail(const straightedge::Failure& failure) {
  std::fprintf(stderr, "%s\n", failure.sentence.c_str());
  return static_cast<int>(failure.problem);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return fail({straightedge::Problem::bad_option, "usage: 02_lines IMAGE MAP.xml"});

  const auto image = straightedge::read_gray_image(argv[1]);
  if (!image) return fail(image.failure());
  const auto lines = straightedge::build_line_map(*image);
  if (!lines) return fail(lines.failure());
  const auto written = straightedge::write_line_map(argv[2], lines->map);
  if (!written) return fail(written.failure());

  for (const straightedge::MapLine& line : lines->map.lines) {
    std::printf("line %u: rho %.2f px, theta %.4f rad, %zu segments\n", line.id, line.rho, line.theta,
                line.segments.size());
  }
  std::printf("%zu lines in %s\n", lines->map.lines.size(), argv[2]);
}
