// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/candidates.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>

#include "map/select.hpp"

namespace straightedge {
namespace {

constexpr int max_rounds = 3;
constexpr double shortest_edge = 6;  // pixels; corners and thin walls need the short ones, too

Status hough_segments(GrayView mask, const GradientField& field, const HoughOptions& options,
                      std::vector<HoughSegment>& segments, HoughResult& result) {
  const std::size_t bytes = HoughLines::workspace_bytes(mask.size(), options);
  const auto workspace = std::make_unique_for_overwrite<std::byte[]>(bytes);
  HoughLines hough;
  const Status prepared = HoughLines::prepare(hough, mask.size(), options, {workspace.get(), bytes});
  if (prepared != Status::ok) return prepared;
  std::vector<HoughPeak> peaks;
  std::size_t room = 4096;
  do {
    segments.resize(room);
    if (options.method == HoughMethod::standard) peaks.resize(room);
    result = hough.run(mask, GradientView{field.x, field.y}, peaks, segments);
    room *= 4;
  } while (result.status == Status::output_full && room <= (std::size_t{1} << 24));
  segments.resize(result.segments);
  return result.status == Status::output_full ? Status::ok : result.status;
}

/// What the next round asks for: less, for the long edges are gone.
HoughOptions relaxed(HoughOptions options) {
  options.threshold = std::max(options.threshold * 2 / 3, 1);
  options.min_length *= 0.7;
  return options;
}

Image<std::uint8_t> copy_of(GrayView image) {
  Image<std::uint8_t> copy(image.size());
  for (std::int32_t y = 0; y < image.height; ++y) {
    std::memcpy(copy.view().row(y), image.row(y), static_cast<std::size_t>(image.width));
  }
  return copy;
}

}  // namespace

Status find_edges(GrayView edges, const GradientField& field, const LineMapOptions& options,
                  std::vector<WallLine>& lines, LineMapReport& report) {
  Image<std::uint8_t> mask = copy_of(edges);
  HoughOptions hough = first_round(options);
  RefitOptions refit;
  refit.max_gap = std::min(options.max_gap, 8.0);
  for (int round = 0; round < max_rounds; ++round) {
    std::vector<HoughSegment> segments;
    HoughResult result;
    const Status status = hough_segments(mask, field, hough, segments, result);
    if (status != Status::ok) return status;
    if (round == 0) report.hough = result;
    ++report.rounds;
    if (segments.empty()) break;
    report.candidates += static_cast<std::uint32_t>(segments.size());
    const std::vector<WallLine> found = select_edges(segments, field, refit, shortest_edge, mask.view());
    lines.insert(lines.end(), found.begin(), found.end());
    if (round == 0) hough = relaxed(hough);
  }
  report.edges = static_cast<std::uint32_t>(lines.size());
  return Status::ok;
}

}  // namespace straightedge
