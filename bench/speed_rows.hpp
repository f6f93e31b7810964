// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "straightedge/host/kernels.hpp"
#include "straightedge/image.hpp"

/// What the rows of bench_speed are made of. A job is prepared outside the time and then called again and
/// again.
namespace bench::speed {

using Call = std::function<void()>;
using Prepare = std::function<Call(const straightedge::KernelSet&)>;

struct Job {
  std::string name;
  std::string size;  ///< "640x480", "10^5 points"
  double items = 0;  ///< pixels, points or queries that a call works on
  const char* item = "pixel";
  Prepare prepare;
};

// Pictures: a tiled photo; the line map has a drawn floor plan.
Job canny_job(straightedge::Size size);
Job hough_job(straightedge::Size size);
Job line_map_job(straightedge::Size size);
Job fast_line_map_job(straightedge::Size size);
// Frames of a depth camera in a room.
Job first_plane_job(straightedge::Size size);
Job ransac_planes_job(straightedge::Size size);
Job hough_planes_job(straightedge::Size size);
Job large_ransac_planes_job(straightedge::Size size);
Job large_hough_planes_job(straightedge::Size size);
Job register_job(straightedge::Size size);
// The same room as points without order, as many as a power of ten.
Job cloud_plane_job(int power);
Job octree_job(int power);
Job nearest_job(int power);

/// A whole job and what it is made of, each stage as it stands alone.
struct Stages {
  std::string name;
  Job whole;
  std::vector<Job> parts;
};
std::vector<Stages> stages();

/// What no program can do without, and the job that it is the floor of.
struct Floor {
  std::string what;
  Call least;
  Job job;
};
std::vector<Floor> floors();

/// A loop as it is, and as it would be with fused multiply-add. Empty when the processor has none.
struct Fused {
  std::string loop;
  Call separate, fused;
};
std::vector<Fused> fused_loops();

[[noreturn]] inline void fail(const char* what) {
  std::fprintf(stderr, "bench_speed: %s\n", what);
  std::exit(70);
}
inline void need(bool good, const char* what) {
  if (!good) fail(what);
}

inline double pixels_of(straightedge::Size size) {
  return static_cast<double>(size.width) * static_cast<double>(size.height);
}
inline std::string text_of(straightedge::Size size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

}  // namespace bench::speed
