// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "straightedge/host/result.hpp"
#include "straightedge/hough_lines.hpp"

namespace straightedge::cli {

struct RawLines {
  HoughResult result;
  std::vector<HoughPeak> peaks;        ///< standard
  std::vector<HoughSegment> segments;  ///< the other methods
};

/// The raw transform: lines alone in the standard method, whose end points nobody asks for. With as much room
/// for its output as it asks for. `file` is for the sentences.
Result<RawLines> find_raw_lines(const std::filesystem::path& file, GrayView edges,
                                const HoughOptions& options);

/// `rho,theta,votes` or `x0,y0,x1,y1,votes` under a row with these names, in the order of discovery.
std::string csv_of(const RawLines& found, HoughMethod method);

}  // namespace straightedge::cli
