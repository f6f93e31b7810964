// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// The tables of docs/speed.md, in Markdown, each below a line "table NAME":
//   bench_speed [MILLISECONDS A ROW, default 200]   measures
//   bench_speed --small                             measures each small row once: whether everything works
//   bench_speed --shape                             all rows, nothing measured
// Processor time of one thread, medians. What is compared within a row takes turns.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>

#include "speed_rows.hpp"
#include "thread_time.hpp"

namespace {

using namespace bench::speed;
using straightedge::KernelSet;
using straightedge::Size;

enum class Mode : std::uint8_t { measure, small, shape };

struct Run {
  Mode mode = Mode::measure;
  double row_ms = 200;

  bool left_out(double items) const { return mode == Mode::small && items > 400'000; }
};

/// Median milliseconds of each call, in turns, at least three of each; zeros when nothing is to be measured.
std::vector<double> measure(const std::vector<Call>& calls, const Run& run) {
  std::vector<std::vector<double>> times(calls.size());
  std::vector<double> medians(calls.size(), 0.0);
  const int least = run.mode == Mode::measure ? 3 : 1, most = run.mode == Mode::measure ? 101 : 1;
  double spent = 0;
  for (int round = -1; round < least || (round < most && spent < run.row_ms); ++round) {
    for (std::size_t i = 0; i < calls.size(); ++i) {
      const double before = bench::thread_ms();
      calls[i]();
      const double time = bench::thread_ms() - before;
      if (round >= 0) times[i].push_back(time);  // the first round finds caches cold
      spent += time;
    }
  }
  for (std::size_t i = 0; i < calls.size(); ++i) medians[i] = bench::median(times[i]);
  return medians;
}

std::vector<double> measure_jobs(const std::vector<Job>& jobs, const KernelSet& set, const Run& run) {
  if (run.mode == Mode::shape) return std::vector<double>(jobs.size(), 0.0);
  std::vector<Call> calls;
  for (const Job& job : jobs) calls.push_back(job.prepare(set));
  return measure(calls, run);
}

/// Three digits, whatever the size.
std::string number(double value) {
  char text[40];
  const int before = value >= 1 ? static_cast<int>(std::log10(value)) + 1 : 0;
  std::snprintf(text, sizeof(text), "%.*f", before >= 3 ? 0 : 3 - before, value);
  return text;
}

void print_jobs(const Run& run) {
  constexpr Size vga{640, 480}, full_hd{1920, 1080};
  constexpr int points = 5;
  const Job jobs[] = {canny_job(vga),
                      canny_job(full_hd),
                      hough_job(vga),
                      hough_job(full_hd),
                      line_map_job(vga),
                      line_map_job(full_hd),
                      fast_line_map_job(vga),
                      fast_line_map_job(full_hd),
                      first_plane_job(vga),
                      ransac_planes_job(vga),
                      hough_planes_job(vga),
                      large_ransac_planes_job(vga),
                      large_hough_planes_job(vga),
                      register_job(vga),
                      cloud_plane_job(points),
                      octree_job(points),
                      nearest_job(points)};
  constexpr const char* names[] = {"plain", "sse2", "avx2", "avx512"};
  std::printf("table jobs\n| job | size | plain, ms | sse2, ms | avx2, ms | avx512, ms |\n");
  std::printf("| --- | --- | ---: | ---: | ---: | ---: |\n");
  for (const Job& job : jobs) {
    if (run.left_out(job.items)) continue;
    std::vector<Call> calls;
    if (run.mode != Mode::shape)
      for (const KernelSet& set : straightedge::kernel_sets()) calls.push_back(job.prepare(set));
    const std::vector<double> times = run.mode == Mode::shape ? std::vector<double>() : measure(calls, run);
    std::printf("| %s | %s |", job.name.c_str(), job.size.c_str());
    for (const char* name : names) {
      std::size_t i = 0;
      while (i < times.size() && straightedge::kernel_sets()[i].name != name) ++i;
      std::printf(" %s |", i < times.size() ? number(times[i]).c_str() : "–");
    }
    std::printf("\n");
  }
}

void print_growth(const Run& run) {
  std::vector<Job> jobs;
  constexpr Size pictures[] = {{320, 240}, {640, 480}, {1280, 720}, {1920, 1080}, {3840, 2160}, {7680, 4320}};
  constexpr Size frames[] = {{320, 240}, {640, 480}, {1280, 960}};
  for (const auto job : {canny_job, hough_job, line_map_job})
    for (const Size size : pictures) jobs.push_back(job(size));
  for (const auto job : {first_plane_job, ransac_planes_job, hough_planes_job, register_job})
    for (const Size size : frames) jobs.push_back(job(size));
  for (const auto job : {cloud_plane_job, octree_job, nearest_job})
    for (int power = 4; power <= 7; ++power) jobs.push_back(job(power));
  std::printf("table growth\n| job | size | ms | ns each | |\n| --- | --- | ---: | ---: | --- |\n");
  for (const Job& job : jobs) {
    if (run.left_out(job.items) || (run.mode == Mode::small && job.size == "10^7 points")) continue;
    const double ms = measure_jobs({job}, straightedge::best_kernels(), run)[0];
    std::printf("| %s | %s | %s | %s | a %s |\n", job.name.c_str(), job.size.c_str(), number(ms).c_str(),
                number(1e6 * ms / job.items).c_str(), job.item);
    std::fflush(stdout);
  }
}

void print_stages(const Run& run) {
  std::printf("table stages\n| job, 640x480 | stage | ms | share |\n| --- | --- | ---: | ---: |\n");
  for (const Stages& stage : stages()) {
    std::vector<Job> jobs = stage.parts;
    jobs.push_back(stage.whole);
    const std::vector<double> times = measure_jobs(jobs, straightedge::best_kernels(), run);
    double rest = times.back();
    const auto print = [&](const char* name, double ms) {
      std::printf("| %s | %s | %s | %.0f %% |\n", stage.name.c_str(), name, number(ms).c_str(),
                  times.back() > 0 ? 100 * ms / times.back() : 0);
    };
    for (std::size_t i = 0; i < stage.parts.size(); ++i) {
      print(stage.parts[i].name.c_str(), times[i]);
      rest -= times[i];
    }
    print("the rest", rest > 0 ? rest : 0);
    print("all", times.back());
  }
}

void print_floors(const Run& run) {
  std::printf("table floor\n| job | no program can do without | ms | the job, ms | times the floor |\n");
  std::printf("| --- | --- | ---: | ---: | ---: |\n");
  for (const Floor& floor : floors()) {
    if (run.left_out(floor.job.items)) continue;
    double least = 0, job = 0;
    if (run.mode != Mode::shape) {
      const auto times = measure({floor.least, floor.job.prepare(straightedge::best_kernels())}, run);
      least = times[0];
      job = times[1];
    }
    std::printf("| %s | %s | %s | %s | %s |\n", floor.job.name.c_str(), floor.what.c_str(),
                number(least).c_str(), number(job).c_str(), number(least > 0 ? job / least : 0).c_str());
  }
}

void print_fused(const Run& run) {
  std::printf(
      "table fma\n| loop, AVX2 | as it is, ms | fused, ms | times faster |\n| --- | ---: | ---: | ---: |\n");
  for (const Fused& loop : fused_loops()) {
    const auto times =
        run.mode == Mode::shape ? std::vector<double>{0, 0} : measure({loop.separate, loop.fused}, run);
    std::printf("| %s | %s | %s | %.2f |\n", loop.loop.c_str(), number(times[0]).c_str(),
                number(times[1]).c_str(), times[1] > 0 ? times[0] / times[1] : 0);
  }
}

}  // namespace

int main(int argc, char** argv) {
  Run run;
  const char* const given = argc > 1 ? argv[1] : "200";
  if (std::strcmp(given, "--small") == 0) {
    run.mode = Mode::small;
  } else if (std::strcmp(given, "--shape") == 0) {
    run.mode = Mode::shape;
  } else {
    run.row_ms = std::atof(given);
  }
  if (argc > 2 || !(run.row_ms > 0)) {
    std::fprintf(stderr, "bench_speed [MILLISECONDS A ROW | --small | --shape]\n");
    return 2;
  }
  print_jobs(run);
  print_growth(run);
  print_stages(run);
  print_floors(run);
  print_fused(run);
}
