// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>

#include "pictures.hpp"
#include "straightedge/status.hpp"

namespace bench {

/// Ends the program: a row whose work failed would be a fast row.
inline void require(straightedge::Status status, const char* what) {
  if (status == straightedge::Status::ok || status == straightedge::Status::output_full) return;
  std::fprintf(stderr, "%s: %s\n", what, straightedge::to_string(status));
  std::exit(70);
}

/// Ends the program likewise: every picture here has lines.
inline void require_some(std::size_t count, const char* what) {
  if (count > 0) return;
  std::fprintf(stderr, "no %s found\n", what);
  std::exit(70);
}

/// One row of the table, `stage/picture/size`. `prepare(job)` makes what is measured as a function object:
/// everything that happens once is done there and not timed. Beside the time of a call the row shows the
/// time for each pixel of the picture.
template <class Prepare>
void add_row(const std::string& stage, const Job& job, Prepare prepare) {
  benchmark::RegisterBenchmark((stage + "/" + job.name()).c_str(), [job, prepare](benchmark::State& state) {
    auto run = prepare(job);
    for (auto _ : state) {
      run();
      benchmark::ClobberMemory();
    }
    const double pixels = static_cast<double>(job.size.width) * static_cast<double>(job.size.height);
    state.counters["per_pixel"] = benchmark::Counter(
        pixels, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  })->Unit(benchmark::kMillisecond);
}

void add_canny_rows(const Job& job);
void add_hough_rows(const Job& job);
void add_line_map_rows(const Job& job);

}  // namespace bench
