// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "straightedge/depth_view.hpp"
#include "straightedge/host/plane_detector.hpp"
#include "straightedge/host/result.hpp"

namespace straightedge::cli {

struct ExplainDepthOptions {
  PlaneDetectorOptions detector = {};  ///< one run is behind every picture
  std::string input = {};              ///< base name of the frame's file
  std::string version = {};            ///< of the program
};

/// Every stage on the way from a depth frame to its planes as a picture, and a page `index.html` that walks
/// through them with the numbers of this frame. The folder needs no network and no other file.
///
/// Steps
///   1. Run all stages and keep what each leaves behind (explain_depth_run.hpp).
///   2. Make the pictures (explain_depth_pictures.hpp, explain_ransac.hpp, explain_planes_hough.hpp).
///   3. Write the page (explain_depth_sections.hpp says what is in it, io/html_page.hpp how it looks).
///   4. Write the folder (explain_files.hpp).
///
/// The same frame and options give the same bytes. Everything is made in memory before the first file is
/// written. Fails with `bad_option` and `bad_content` as PlaneDetector and PlaneMapBuilder do,
/// `cannot_write`, or `internal`.
Result<Done> explain_depth(const DepthView& depth, const ExplainDepthOptions& options,
                           const std::filesystem::path& directory);

}  // namespace straightedge::cli
