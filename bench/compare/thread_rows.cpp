// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <opencv2/imgproc.hpp>

#include "alternation.hpp"
#include "photos.hpp"
#include "rows.hpp"
#include "straightedge/canny_fused.hpp"
#include "straightedge/host/canny.hpp"

namespace compare {

using namespace straightedge;

void print_threaded_edge_rows(Size size, int rounds) {
  const std::vector<cv::Mat> pictures = photos(size);
  const CannyOptions options{.sigma = 0, .norm = GradientNorm::l1, .low = 50, .high = 150};
  std::vector<CannyEdges> ours(pictures.size());
  std::vector<cv::Mat> theirs(pictures.size());
  print_row({"Canny L1", text_of(size), std::string(best_kernels().name),
             [&] {
               for (std::size_t i = 0; i < pictures.size(); ++i)
                 ours[i] = canny(view_of(pictures[i]), options);
             },
             [&] {
               for (std::size_t i = 0; i < pictures.size(); ++i)
                 cv::Canny(pictures[i], theirs[i], options.low, options.high, options.aperture, false);
             },
             [&] {
               bool equal = true;
               for (std::size_t i = 0; i < pictures.size(); ++i) {
                 const cv::Mat edges(size.height, size.width, CV_8UC1, ours[i].edges.view().data,
                                     static_cast<std::size_t>(ours[i].edges.view().stride));
                 equal = equal && cv::norm(edges, theirs[i], cv::NORM_INF) == 0;
               }
               return equal;
             }},
            rounds, Clock::wall);
}

}  // namespace compare
