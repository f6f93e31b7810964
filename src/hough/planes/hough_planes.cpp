// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/hough_planes.hpp"

#include "hough/planes/cloud_job.hpp"

namespace straightedge {
namespace {

using hough::CloudJob;

/// A box round the points that have readings; they are listed in `free`.
struct Box {
  Vector3 low, high;
  std::size_t points = 0;

  void add(const Vector3& p) noexcept {
    if (points++ == 0) low = high = p;
    low = {p.x < low.x ? p.x : low.x, p.y < low.y ? p.y : low.y, p.z < low.z ? p.z : low.z};
    high = {p.x > high.x ? p.x : high.x, p.y > high.y ? p.y : high.y, p.z > high.z ? p.z : high.z};
  }
};

/// Step 1.
void list_points(CloudJob& job) noexcept {
  detail::HoughPlaneMemory& m = job.memory;
  const bool fixed = job.options.gate.fixed_m > 0;
  Box box;
  for (std::size_t i = 0; i < job.points.count; ++i) {
    const Vector3 p = job.points.at(i);
    job.labels[i] = 0;
    if (!finite(p) || (!fixed && p.z <= 0)) continue;
    m.free[box.points] = static_cast<std::uint32_t>(i);
    box.add(p);
  }
  job.left = box.points;
  job.origin = 0.5 * (box.low + box.high);
  for (std::size_t i = 0; i < job.left; ++i) {
    const Vector3 p = job.points.at(m.free[i]) - job.origin;
    m.x[i] = static_cast<float>(p.x);
    m.y[i] = static_cast<float>(p.y);
    m.z[i] = static_cast<float>(p.z);
  }
  double step = job.options.distance_step_m;
  if (step == 0) step = length(box.high - box.low) / 2 / job.options.accumulator.distances;
  // Equal points have no extent; any step serves.
  m.accumulator.clear(step > 1e-9 ? step : 1e-9);
}

/// Planes with many points first; ties keep their order.
void sort(std::span<FoundPlane> planes) noexcept {
  for (std::size_t i = 1; i < planes.size(); ++i) {
    const FoundPlane plane = planes[i];
    std::size_t place = i;
    for (; place > 0 && planes[place - 1].inliers < plane.inliers; --place) planes[place] = planes[place - 1];
    planes[place] = plane;
  }
}

/// Step 7.
Status settle(CloudJob& job, std::uint32_t& labelled) noexcept {
  const PlaneGate& gate = job.options.gate;
  for (int turn = 0; turn < 2; ++turn) {
    const auto planes = job.planes.first(job.found);
    Status status = label_nearest(job.points, planes, gate, job.labels, labelled);
    if (status != Status::ok) return status;
    status = refit_labelled(job.points, job.labels, gate, planes);
    if (status != Status::ok) return status;
    std::uint32_t kept = 0;
    for (const FoundPlane& plane : planes) {
      if (plane.inliers >= job.options.min_points) job.planes[kept++] = plane;
    }
    job.found = kept;
    sort(job.planes.first(kept));
  }
  const auto planes = job.planes.first(job.found);
  const Status status = label_nearest(job.points, planes, gate, job.labels, labelled);
  if (status != Status::ok) return status;
  for (FoundPlane& plane : planes) plane.inliers = 0;
  for (const std::uint16_t label : job.labels) {
    if (label != 0) ++planes[label - 1U].inliers;
  }
  return Status::ok;
}

}  // namespace

Status HoughPlanes::prepare(HoughPlanes& search, std::size_t points, const HoughPlaneOptions& options,
                            std::span<std::byte> workspace) noexcept {
  search = {};
  if (points == 0) return Status::invalid_image;
  if (points > most_points) return Status::too_large;
  if (!detail::valid(options)) return Status::invalid_option;
  Arena arena(workspace);
  detail::HoughPlaneMemory memory;
  memory.take(arena, points, options);
  if (arena.failed()) return Status::workspace_too_small;
  memory.accumulator.fill(options.accumulator.cells);
  search.memory_ = memory;
  search.options_ = options;
  search.capacity_ = points;
  return Status::ok;
}

Status HoughPlanes::run(const PointsView& points, std::span<std::uint16_t> labels,
                        std::span<FoundPlane> planes, PlanesFound& found, HoughPlaneTrace trace) noexcept {
  found = {.seed = options_.seed};
  if (capacity_ == 0) return Status::not_prepared;
  if (!points.valid()) return Status::invalid_image;
  if (points.count > capacity_) return Status::too_large;
  if (labels.size() != points.count) return Status::size_mismatch;
  const std::size_t room = planes.size() < options_.max_planes ? planes.size() : options_.max_planes;
  CloudJob job{points, options_, memory_, labels, planes.first(room), trace, {}};
  // Step 1.
  list_points(job);
  found.readings = static_cast<std::uint32_t>(job.left);
  origin_ = job.origin;
  // Steps 2 to 6.
  const bool standard = options_.voting == HoughPlaneVoting::standard;
  const Status status = standard ? hough::vote_standard(job) : hough::vote_randomized(job);
  confident_ = job.confident;
  // Step 7.
  const Status settled = settle(job, found.labelled);
  found.planes = job.found;
  found.iterations = job.votes;
  return status != Status::ok ? status : settled;
}

}  // namespace straightedge
