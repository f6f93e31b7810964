// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// A row for every stage from gray picture to line map, at four sizes, on a photo and on a floor plan:
//   bench_lines --benchmark_filter='canny/.*640x480'
#include "rows.hpp"

int main(int argc, char** argv) {
  constexpr straightedge::Size sizes[] = {{320, 240}, {640, 480}, {1920, 1080}, {3840, 2160}};
  for (const auto picture : {bench::Picture::photo, bench::Picture::floor_plan}) {
    for (const straightedge::Size size : sizes) {
      const bench::Job job{picture, size};
      bench::add_canny_rows(job);
      bench::add_hough_rows(job);
      bench::add_line_map_rows(job);
    }
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
