// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/lines_report.hpp"

#include "io/number_text.hpp"

namespace straightedge::cli {

std::string kind_of(const LineMapReport& report) {
  switch (report.picture) {
    case PictureKind::map:
      return "map";
    case PictureKind::photo:
      return "photo";
    default:
      return "not asked";
  }
}

std::string words_of(const LineMapReport& report, Size size) {
  const auto count = [](auto value, const char* what) { return io::to_text(value) + what; };
  const bool refined = report.picture != PictureKind::automatic;
  const std::string result =
      "  map       " + count(report.lines, " lines, ") + count(report.segments, " segments");
  std::string words = "  picture   " + count(size.width, " x ") + count(size.height, " pixels") +
                      (refined ? ", taken for a " + kind_of(report) : "") + "\n";
  words += "  edges     " + count(report.canny.edges, " pixels (low ") + io::to_text(report.canny.low) +
           ", high " + io::to_text(report.canny.high) + ")\n";
  if (!refined) {
    words += "  followed  " + count(report.edges, " straight edges\n") + "  joined    " +
             count(report.walls, " pairs of edges into axes of thin walls, ") +
             count(report.merged, " fragments into others\n") + "  dropped   " +
             count(report.too_short, " too short\n");
    return words + result;
  }
  if (report.rounds == 0) {
    words += "  followed  " + count(report.edges, " straight edges\n");
  } else {
    words += "  Hough     " + count(report.candidates, " segments in ") + count(report.rounds, " rounds; ") +
             count(report.edges, " held as straight edges\n");
  }
  words += "  joined    " + count(report.walls, " pairs of edges into axes of thin walls, ") +
           count(report.merged, " fragments into others\n");
  words += "  dropped   " + count(report.no_wall, " no wall, ") + count(report.furniture, " furniture, ") +
           count(report.too_short, " too short\n");
  return words + result;
}

}  // namespace straightedge::cli
