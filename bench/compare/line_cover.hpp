// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "straightedge/host/image.hpp"
#include "straightedge/host/line_map.hpp"
#include "straightedge/hough_options.hpp"

namespace compare {

using Lines = std::vector<cv::Vec4i>;

/// How segments and marked pixels cover one another, within two pixels.
struct Cover {
  double of_marks = 0;  ///< share of the marked pixels that lie at a segment
  double of_lines = 0;  ///< share of the segments' pixels that lie at a marked one

  bool as_good_as(const Cover& other) const {
    return of_marks >= other.of_marks - 0.01 && of_lines >= other.of_lines - 0.01;
  }
};

Cover cover_of(const cv::Mat& marks, const Lines& lines);

/// "98.1 % of edges, 99.0 % on edges; peer 97.0 %, 98.2 %": what is covered, and what of the lines covers.
std::string in_words(const Cover& ours, const Cover& theirs, const std::string& marks);

Lines ours_as_lines(const std::vector<straightedge::HoughSegment>& segments, std::uint32_t count);
/// From the map's frame to columns and rows.
Lines map_as_lines(const straightedge::LineMap& map, straightedge::Size size);

/// The same pixels for OpenCV.
cv::Mat mat_of(const straightedge::Image<std::uint8_t>& image);

}  // namespace compare
