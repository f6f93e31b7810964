// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "alternation.hpp"
#include "photos.hpp"
#include "rows.hpp"
#include "straightedge/host/hough_lines.hpp"

namespace compare {
namespace {

using namespace straightedge;

/// OpenCV's numbers and habits, so that both find the same segments in the same order.
constexpr HoughOptions options{
    .threshold = 50, .min_length = 30, .max_gap = 10, .generator = HoughGenerator::opencv};

bool same(const std::vector<HoughSegment>& ours, const std::vector<cv::Vec4i>& theirs) {
  if (ours.size() != theirs.size()) return false;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const HoughSegment& s = ours[i];
    if (theirs[i] != cv::Vec4i(s.x0, s.y0, s.x1, s.y1)) return false;
  }
  return true;
}

}  // namespace

void print_line_rows(Size size, int rounds) {
  std::vector<cv::Mat> edges = photos(size);
  for (cv::Mat& picture : edges) cv::Canny(picture.clone(), picture, 50, 150);
  std::vector<std::vector<HoughSegment>> ours(edges.size());
  std::vector<std::vector<cv::Vec4i>> theirs(edges.size());
  print_row({"progressive Hough", text_of(size), "plain",
             [&] {
               for (std::size_t i = 0; i < edges.size(); ++i) {
                 ours[i] = hough_lines(view_of(edges[i]), options).segments;
               }
             },
             [&] {
               for (std::size_t i = 0; i < edges.size(); ++i) {
                 cv::HoughLinesP(edges[i], theirs[i], options.rho_step, options.theta_step, options.threshold,
                                 options.min_length, options.max_gap);
               }
             },
             [&] {
               bool equal = true;
               for (std::size_t i = 0; i < edges.size(); ++i) equal = equal && same(ours[i], theirs[i]);
               return equal;
             }},
            rounds);
}

}  // namespace compare
