// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/explain_depth_run.hpp"
#include "straightedge/host/image.hpp"

namespace straightedge::cli {

/// Where the watched window lies in the frame.
Image<Rgb> show_window(const ExplainDepthRun& run);

/// The cost of every hypothesis as a dot; a line for that of the refitted plane.
Image<Rgb> show_hypotheses(const ExplainDepthRun& run);

/// A hypothesis in the window: its three readings, and which others lie within the gate of their plane.
struct TriplePicture {
  Image<Rgb> picture;
  std::uint32_t readings = 0;
  std::uint32_t inliers = 0;
};
TriplePicture show_triple(const ExplainDepthRun& run, const RansacEvent& event);
/// The same for the plane in the end, which has no triple.
TriplePicture show_refitted(const ExplainDepthRun& run);

/// The best hypotheses of the window, first to last.
std::vector<RansacEvent> best_events(const WatchedWindow& window);

/// The boxes in which the readings of the strongest candidates lie, over the pixels that are nearest to them.
inline constexpr std::size_t shown_boxes = 8;
Image<Rgb> show_boxes(const ExplainDepthRun& run);

}  // namespace straightedge::cli
