// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include "straightedge/hough_lines.hpp"

namespace straightedge {

/// The lines of an edge image, in memory of their own.
struct HoughFound {
  HoughResult result;
  std::vector<HoughPeak> peaks;
  std::vector<HoughSegment> segments;
};

/// HoughLines (hough_lines.hpp) in one call. When the output proves too small it is doubled and the
/// run, which is deterministic, repeated. Bad input is told by `result.status`.
inline HoughFound hough_lines(GrayView edges, const HoughOptions& options = {}, GradientView gradients = {}) {
  HoughFound found;
  const HoughGrid grid = hough_grid(edges.size(), options);
  found.result.status = edges.valid() ? grid.status : Status::invalid_image;
  if (found.result.status != Status::ok) return found;

  // Room for as many edge pixels as there are pixels: most of it is never touched, so it is not cleared.
  const std::size_t bytes = HoughLines::workspace_bytes(edges.size(), options);
  const auto workspace = std::make_unique_for_overwrite<std::byte[]>(bytes);
  HoughLines lines;
  found.result.status = HoughLines::prepare(lines, edges.size(), options, {workspace.get(), bytes});
  if (found.result.status != Status::ok) return found;

  const bool with_peaks = options.method != HoughMethod::progressive;
  // Large enough nearly always: a second run costs more than room.
  const auto pixels = static_cast<std::size_t>(edges.width) * static_cast<std::size_t>(edges.height);
  std::size_t capacity = std::max<std::size_t>(4096, pixels / 64);
  do {
    found.peaks.resize(with_peaks ? capacity : 0);
    found.segments.resize(capacity);
    found.result = lines.run(edges, gradients, found.peaks, found.segments);
    capacity *= 2;
  } while (found.result.status == Status::output_full);
  found.peaks.resize(found.result.peaks);
  found.segments.resize(found.result.segments);
  return found;
}

}  // namespace straightedge
