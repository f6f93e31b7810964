// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/raw_lines.hpp"

#include <charconv>
#include <cstddef>
#include <memory>

#include "cli/picture_input.hpp"
#include "io/number_text.hpp"

namespace straightedge::cli {
namespace {

constexpr std::size_t first_room = 4096;
constexpr std::size_t most_room = std::size_t{1} << 28;  // no accumulator has more cells

Failure failure_of(const std::filesystem::path& file, Status status) {
  const bool steps = status == Status::invalid_option;
  const Problem problem = steps                         ? Problem::bad_option
                          : status == Status::too_large ? Problem::bad_content
                                                        : Problem::internal;
  const char* sentence = status == Status::too_large
                             ? "the accumulator would have too many cells; take larger --rho and --theta"
                             : to_string(status);
  return {problem, file.string() + ": " + sentence};
}

/// Of the float itself: fewer digits than its double has.
std::string float_text(float value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value);
  return {text, end.ptr};
}

}  // namespace

Result<RawLines> find_raw_lines(const std::filesystem::path& file, GrayView edges,
                                const HoughOptions& options) {
  const HoughGrid grid = hough_grid(edges.size(), options);
  if (grid.status != Status::ok) return failure_of(file, grid.status);
  const std::size_t bytes = HoughLines::workspace_bytes(edges.size(), options);
  if (auto fits = check_memory(file, bytes); !fits) return fits.failure();
  const auto workspace = std::make_unique_for_overwrite<std::byte[]>(bytes);
  HoughLines lines;
  const Status prepared = HoughLines::prepare(lines, edges.size(), options, {workspace.get(), bytes});
  if (prepared != Status::ok) return failure_of(file, prepared);
  RawLines found;
  for (std::size_t room = first_room;; room *= 8) {
    const bool standard = options.method == HoughMethod::standard;
    found.peaks.resize(standard ? room : 0);
    found.segments.resize(standard ? 0 : room);
    found.result = lines.run(edges, found.peaks, found.segments);
    if (found.result.status != Status::output_full || room >= most_room) break;
  }
  if (found.result.status != Status::ok) return failure_of(file, found.result.status);
  if (options.method == HoughMethod::standard) found.peaks.resize(found.result.peaks);
  found.segments.resize(found.result.segments);
  return found;
}

std::string csv_of(const RawLines& found, HoughMethod method) {
  const bool standard = method == HoughMethod::standard;
  std::string csv = standard ? "rho,theta,votes\n" : "x0,y0,x1,y1,votes\n";
  for (const HoughPeak& peak : found.peaks) {
    csv += float_text(peak.rho) + "," + float_text(peak.theta) + "," + io::to_text(peak.votes) + "\n";
  }
  for (const HoughSegment& segment : found.segments) {
    for (const std::int32_t end : {segment.x0, segment.y0, segment.x1, segment.y1})
      csv += io::to_text(end) + ",";
    csv += io::to_text(segment.votes) + "\n";
  }
  return csv;
}

}  // namespace straightedge::cli
