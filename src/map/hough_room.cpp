// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/hough_room.hpp"

#include <algorithm>

namespace straightedge {

std::span<const HoughSegment> HoughRoom::run(GrayView edges, GradientView gradients,
                                             const HoughOptions& options) {
  const std::size_t bytes = HoughLines::workspace_bytes(edges.size(), options);
  if (bytes > bytes_) {
    // Room for as many edge pixels as there are pixels: most of it is never touched, so it is not cleared.
    memory_ = std::make_unique_for_overwrite<std::byte[]>(bytes);
    bytes_ = bytes;
  }
  HoughLines lines;
  result = {};
  result.status = HoughLines::prepare(lines, edges.size(), options, {memory_.get(), bytes_});
  if (result.status != Status::ok) return {};
  const auto pixels = static_cast<std::size_t>(edges.width) * static_cast<std::size_t>(edges.height);
  const std::size_t room = std::max<std::size_t>(4096, pixels / 64);
  const bool with_peaks = options.method != HoughMethod::progressive;
  if (segments_.size() < room) segments_.resize(room);
  if (with_peaks && peaks_.size() < room) peaks_.resize(room);
  for (;;) {
    result = lines.run(edges, gradients, with_peaks ? std::span(peaks_) : std::span<HoughPeak>(), segments_);
    if (result.status != Status::output_full) break;
    segments_.resize(2 * segments_.size());
    if (with_peaks) peaks_.resize(2 * peaks_.size());
  }
  return std::span<const HoughSegment>(segments_).first(result.segments);
}

}  // namespace straightedge
