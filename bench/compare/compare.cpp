// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// Straightedge beside the libraries that people use, in one process:
//   bench_compare [ROUNDS, default 41] [PART...: edges lines first planes octree threads, default all]
// The answers must agree before a time counts. The two take turns; medians. One thread each and its processor
// time, but for `threads`: there each takes the threads that it wants, and the time is the clock's.
// edges, lines: a row is the sum over six photos, or a drawn floor plan. first, planes, octree: a depth frame.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#if defined(_OPENMP)
#include <omp.h>
#endif

#include "alternation.hpp"
#include "rows.hpp"

namespace {

constexpr straightedge::Size sizes[] = {{640, 480}, {1920, 1080}, {3840, 2160}};

int fewer(straightedge::Size size, int rounds) {
  return size.width > 2000 ? (rounds + 2) / 3 : rounds;
}

void use_threads(int threads) {
  cv::setNumThreads(threads);
#if defined(_OPENMP)
  omp_set_num_threads(threads > 0 ? threads : omp_get_num_procs());
#endif
}

void print_threads(int rounds) {
  use_threads(-1);
  for (const straightedge::Size size : sizes) compare::print_threaded_edge_rows(size, fewer(size, rounds));
  compare::print_threaded_sequence_rows(rounds);
  compare::print_threaded_plane_rows(rounds);
}

struct Part {
  const char* name;
  const char* title;
  std::function<void(int)> print;
};

const Part parts[] = {
    {"edges", "Edges",
     [](int rounds) {
       for (const straightedge::Size size : sizes) compare::print_edge_rows(size, fewer(size, rounds));
     }},
    {"lines", "Lines",
     [](int rounds) {
       for (const straightedge::Size size : sizes)
         compare::print_line_rows(size, (fewer(size, rounds) + 3) / 4);
     }},
    {"first", "First plane", compare::print_first_plane_rows},
    {"planes", "All planes of 5 % of the readings or more", compare::print_all_planes_rows},
    {"octree", "Octree", compare::print_octree_rows},
    {"threads", "With all threads", print_threads},
};

const Part* find_part(const std::string& name) {
  const auto found =
      std::find_if(std::begin(parts), std::end(parts), [&](const Part& p) { return p.name == name; });
  return found == std::end(parts) ? nullptr : found;
}

}  // namespace

int main(int argc, char** argv) {
  int rounds = 41;
  std::vector<const Part*> wanted;
  for (int i = 1; i < argc; ++i) {
    if (const Part* part = find_part(argv[i])) {
      wanted.push_back(part);
    } else if ((rounds = std::atoi(argv[i])) < 1) {
      std::fprintf(stderr, "bench_compare [ROUNDS] [edges|lines|first|planes|octree|threads]...\n");
      return 2;
    }
  }
  if (wanted.empty())
    for (const Part& part : parts) wanted.push_back(&part);
  std::printf("OpenCV %s, %d rounds\n", CV_VERSION, rounds);
  for (const Part* part : wanted) {
    use_threads(1);
    std::printf("\n### %s\n\n", part->title);
    compare::print_head();
    part->print(rounds);
  }
}
