// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "hough/planes/cloud_job.hpp"
#include "hough/vote_bound.hpp"
#include "straightedge/random.hpp"

namespace straightedge::hough {
namespace {

// Draws for the second point and for the third, until one is neither too near nor too far.
constexpr int tries = 16;
// Triangles with a flatter angle say little about their plane: sine, squared.
constexpr double flattest = 0.04;

bool apart(const CloudJob& job, const Vector3& a, const Vector3& b) noexcept {
  const double squared = squared_length(b - a);
  const double least = job.options.triple_min_m, most = job.options.triple_max_m;
  return squared > 0 && squared >= least * least && (most == 0 || squared <= most * most);
}

/// Step 2. False: the draw is void.
bool draw_triple(const CloudJob& job, Pcg32& random, Plane& plane) noexcept {
  const auto left = static_cast<std::uint32_t>(job.left);
  const Vector3 a = job.at(random.below(left));
  Vector3 b, c;
  bool good = false;
  for (int i = 0; i < tries && !good; ++i) {
    b = job.at(random.below(left));
    good = apart(job, a, b);
  }
  if (!good) return false;
  good = false;
  for (int i = 0; i < tries && !good; ++i) {
    c = job.at(random.below(left));
    good = apart(job, a, c) && apart(job, b, c);
  }
  const Vector3 normal = cross(b - a, c - a);
  if (!good || !(squared_length(normal) > flattest * squared_length(b - a) * squared_length(c - a))) {
    return false;
  }
  const Vector3 unit = normalized(normal);
  plane = canonical({unit, dot(unit, a)});
  return true;
}

/// Steps 2 to 4 for one draw. `taken`: planes[found] is a new plane.
Status one_draw(CloudJob& job, std::uint32_t draw, bool& taken) noexcept {
  Pcg32 random(job.options.seed, draw);
  HoughAccumulator& accumulator = job.memory.accumulator;
  Plane plane;
  taken = false;
  if (!draw_triple(job, random, plane)) return Status::ok;
  std::uint32_t& cell = accumulator.votes(accumulator.directions().cell(plane.normal),
                                          accumulator.distance_cell(plane.distance));
  const std::uint32_t votes = ++cell;
  const Plane seen = job.in_input_frame(plane);
  if (!job.trace({HoughPlaneStep::vote, seen, draw, votes})) return Status::cancelled;
  if (votes < job.options.triple_threshold) return Status::ok;
  if (!job.trace({HoughPlaneStep::peak, seen, draw, votes})) return Status::cancelled;
  cell = 0;
  taken = refit_peak(job, plane);
  if (taken) job.planes[job.found].score = votes;
  return Status::ok;
}

}  // namespace

Status vote_randomized(CloudJob& job) noexcept {
  std::uint64_t fruitless = 0;
  std::uint64_t limit = triples_needed(job.left, job.options);
  while (job.left >= job.options.min_points && job.found < job.planes.size()) {
    // Step 6.
    if (fruitless >= limit) break;
    if (job.votes >= job.options.max_draws) {
      job.confident = false;
      break;
    }
    // Steps 2 to 4.
    bool taken = false;
    if (const Status status = one_draw(job, job.votes, taken); status != Status::ok) return status;
    ++job.votes;
    ++fruitless;
    if (!taken) continue;
    // Step 5.
    drop_labelled(job);
    job.memory.accumulator.clear(job.memory.accumulator.step_m());
    FoundPlane& plane = job.planes[job.found++];
    plane.iterations = job.votes;
    fruitless = 0;
    limit = triples_needed(job.left, job.options);
    if (!job.trace({HoughPlaneStep::plane, plane.fit.plane, job.found, plane.inliers})) {
      return Status::cancelled;
    }
  }
  return Status::ok;
}

}  // namespace straightedge::hough

namespace straightedge {

std::uint64_t triples_needed(std::size_t points_left, const HoughPlaneOptions& options) noexcept {
  constexpr double cells = 8;
  const auto all = static_cast<double>(points_left);
  const double some = options.min_points;
  if (all < some || all < 3) return 0;
  const double hit = some / all * ((some - 1) / (all - 1)) * ((some - 2) / (all - 2));
  const double draws = hough::mean_votes_needed(options.confidence, options.triple_threshold) * cells / hit;
  if (draws >= 4e18) return std::uint64_t{4'000'000'000'000'000'000};
  return static_cast<std::uint64_t>(draws) + 1;
}

}  // namespace straightedge
