// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// Straightedge beside OpenCV, one thread each: bench_compare [ROUNDS, default 41]
// The answers must agree before a time counts. A row is the sum over six photos, or a drawn floor plan;
// processor time of the thread, the two in turns, medians.
#include <cstdio>
#include <cstdlib>
#include <opencv2/core.hpp>

#include "alternation.hpp"
#include "rows.hpp"

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 41;
  if (rounds < 1) {
    std::fprintf(stderr, "bench_compare: the number of rounds is at least 1\n");
    return 2;
  }
  cv::setNumThreads(1);
  std::printf("OpenCV %s, one thread each, %d rounds\n\n", CV_VERSION, rounds);
  compare::print_head();
  for (const straightedge::Size size : {straightedge::Size{640, 480}, {1920, 1080}, {3840, 2160}}) {
    const int fewer = size.width > 2000 ? (rounds + 2) / 3 : rounds;
    compare::print_edge_rows(size, fewer);
    compare::print_line_rows(size, (fewer + 3) / 4);
  }
}
