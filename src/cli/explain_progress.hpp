// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "cli/explain_pictures.hpp"
#include "cli/explain_run.hpp"
#include "straightedge/host/image.hpp"

namespace straightedge::cli {

/// One moment of a Hough transform that draws pixels by chance.
struct ProgressPicture {
  std::uint32_t lines = 0;  ///< found until then
  std::uint64_t votes = 0;  ///< cast until then: by pixels, or (randomized) by pairs
  std::uint32_t left = 0;   ///< edge pixels that no line has taken
  Image<Rgb> picture;       ///< pixels that wait gray, those that have voted yellow, those taken by lines red
};

/// The run once more, looked at after the first line, a sixteenth, a quarter and all of them. Empty for the
/// standard method, in which nothing happens by turns, and when there is no line.
std::vector<ProgressPicture> show_progress(const ExplainRun& run, const HoughOptions& options,
                                           const PictureScale& scale);

}  // namespace straightedge::cli
