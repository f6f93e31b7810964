// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "line_cover.hpp"

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <opencv2/imgproc.hpp>

namespace compare {
namespace {

double share(const cv::Mat& part, const cv::Mat& whole) {
  const int all = cv::countNonZero(whole);
  return all == 0 ? 0 : static_cast<double>(cv::countNonZero(part & whole)) / all;
}

}  // namespace

Cover cover_of(const cv::Mat& marks, const Lines& lines) {
  cv::Mat drawn(marks.size(), CV_8UC1, cv::Scalar(0));
  for (const cv::Vec4i& line : lines) cv::line(drawn, {line[0], line[1]}, {line[2], line[3]}, 255);
  const cv::Mat square = cv::getStructuringElement(cv::MORPH_RECT, {5, 5});
  cv::Mat near_lines, near_marks;
  cv::dilate(drawn, near_lines, square);
  cv::dilate(marks, near_marks, square);
  return {share(near_lines, marks), share(near_marks, drawn)};
}

std::string in_words(const Cover& ours, const Cover& theirs, const std::string& marks) {
  char text[160];
  std::snprintf(text, sizeof(text), "%.1f %% of %s, %.1f %% on %s; peer %.1f %%, %.1f %%",
                100 * ours.of_marks, marks.c_str(), 100 * ours.of_lines, marks.c_str(), 100 * theirs.of_marks,
                100 * theirs.of_lines);
  return text;
}

Lines ours_as_lines(const std::vector<straightedge::HoughSegment>& segments, std::uint32_t count) {
  Lines lines;
  for (std::uint32_t i = 0; i < count; ++i)
    lines.emplace_back(segments[i].x0, segments[i].y0, segments[i].x1, segments[i].y1);
  return lines;
}

Lines map_as_lines(const straightedge::LineMap& map, straightedge::Size size) {
  const auto column = [&](double x) { return static_cast<int>(std::lround(x + 0.5 * size.width - 0.5)); };
  const auto row = [&](double y) { return static_cast<int>(std::lround(0.5 * size.height - y - 0.5)); };
  Lines lines;
  for (const straightedge::MapLine& line : map.lines)
    for (const straightedge::MapSegment& s : line.segments)
      lines.emplace_back(column(s.x0), row(s.y0), column(s.x1), row(s.y1));
  return lines;
}

cv::Mat mat_of(const straightedge::Image<std::uint8_t>& image) {
  const straightedge::GrayView view = image.view();
  return cv::Mat(view.height, view.width, CV_8UC1, const_cast<std::uint8_t*>(view.data),
                 static_cast<std::size_t>(view.stride));
}

}  // namespace compare
