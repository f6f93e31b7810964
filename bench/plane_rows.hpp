// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <benchmark/benchmark.h>

#include <string>

#include "straightedge/image.hpp"

namespace bench {

/// One row of the table, `stage/scene/size`. `prepare(size)` makes what is measured as a function object.
/// Beside the time of a call the row shows the time for each pixel of the frame.
template <class Prepare>
void add_plane_row(const std::string& stage, straightedge::Size size, Prepare prepare) {
  const std::string name = stage + "/scene/" + std::to_string(size.width) + "x" + std::to_string(size.height);
  benchmark::RegisterBenchmark(name.c_str(), [size, prepare](benchmark::State& state) {
    auto run = prepare(size);
    for (auto _ : state) {
      run();
      benchmark::ClobberMemory();
    }
    const double pixels = static_cast<double>(size.width) * static_cast<double>(size.height);
    state.counters["per_pixel"] = benchmark::Counter(
        pixels, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  })->Unit(benchmark::kMillisecond);
}

void add_ransac_rows(straightedge::Size size);
void add_plane_map_rows(straightedge::Size size);

}  // namespace bench
