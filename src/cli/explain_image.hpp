// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "straightedge/host/line_map_builder.hpp"
#include "straightedge/host/result.hpp"
#include "straightedge/image.hpp"

namespace straightedge::cli {

struct ExplainOptions {
  /// Its Canny and Hough options are those of every picture: one run.
  LineMapOptions lines{.hough = line_map_hough};
  std::string input = {};    ///< base name of the picture's file
  std::string version = {};  ///< of the program
};

/// Every stage on the way from a picture to its line map as a PNG, and a page `index.html` that walks
/// through them with the numbers of this run. Straight edges are voted for, not followed: votes show what a
/// line is. The folder needs no network and no other file.
///
/// Steps
///   1. Run all stages and keep what each leaves behind (explain_run.hpp).
///   2. Make the pictures (explain_pictures.hpp, explain_accumulator.hpp) and encode them.
///   3. Write the page (explain_sections.hpp says what is in it, explain_page.hpp how it looks).
///   4. Make the folder if there is none; write each file whole or not at all, the page last.
///
/// Everything is made in memory before the first file is written, so a stage that fails leaves no trace. A
/// folder that step 4 made goes again when a file cannot be written. Files of an older run are replaced.
///
/// Fails with `bad_option` (what build_line_map refuses, and `lines` without `hough`), `cannot_write`, or
/// `internal`.
Result<Done> explain_image(GrayView gray, const ExplainOptions& options,
                           const std::filesystem::path& directory);

}  // namespace straightedge::cli
