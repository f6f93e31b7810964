// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// A row for every stage from depth frame to plane map:
//   bench_planes --benchmark_filter='ransac.*640x480'
#include "plane_rows.hpp"

int main(int argc, char** argv) {
  for (const straightedge::Size size : {straightedge::Size{320, 240}, straightedge::Size{640, 480}}) {
    bench::add_ransac_rows(size);
    bench::add_plane_map_rows(size);
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
