// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/lines_report.hpp"

#include "io/number_text.hpp"

namespace straightedge::cli {

std::string kind_of(const LineMapReport& report) {
  return report.picture == PictureKind::map ? "map" : "photo";
}

std::string words_of(const LineMapReport& report, Size size) {
  const auto count = [](auto value, const char* what) { return io::to_text(value) + what; };
  std::string words = "  picture   " + count(size.width, " x ") +
                      count(size.height, " pixels, taken for a ") + kind_of(report) + "\n";
  words += "  edges     " + count(report.canny.edges, " pixels (low ") + io::to_text(report.canny.low) +
           ", high " + io::to_text(report.canny.high) + ")\n";
  words += "  Hough     " + count(report.candidates, " segments in ") + count(report.rounds, " rounds; ") +
           count(report.edges, " held as straight edges\n");
  words += "  joined    " + count(report.walls, " pairs of edges into axes of thin walls, ") +
           count(report.merged, " fragments into others\n");
  words += "  dropped   " + count(report.no_wall, " no wall, ") + count(report.furniture, " furniture, ") +
           count(report.too_short, " too short\n");
  return words + "  map       " + count(report.lines, " lines, ") + count(report.segments, " segments");
}

}  // namespace straightedge::cli
