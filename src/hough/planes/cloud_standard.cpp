// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <array>

#include "hough/planes/cloud_job.hpp"

namespace straightedge::hough {
namespace {

constexpr std::size_t most_peaks = 8;

/// The point's number decides whether it votes: so it takes back what it gave, however the list has shrunk.
bool votes(const CloudJob& job, std::size_t i) noexcept {
  return job.memory.free[i] % job.options.every == 0;
}

/// Step 2 for the free points that have this label: +1 or, to take votes back, −1 (as an unsigned number).
/// One direction after another, so that its distance cells stay near.
template <class Takes>
void cast(CloudJob& job, std::uint32_t vote, Takes takes) noexcept {
  HoughAccumulator& accumulator = job.memory.accumulator;
  for (std::int32_t direction = 0; direction < accumulator.directions().size(); ++direction) {
    const Vector3& n = accumulator.directions().centre(direction);
    for (std::size_t i = 0; i < job.left; ++i) {
      if (!votes(job, i) || !takes(i)) continue;
      const double d = dot(n, job.at(i));
      if (d >= 0) accumulator.votes(direction, accumulator.distance_cell(d)) += vote;
    }
  }
}

Status cast_all(CloudJob& job) noexcept {
  cast(job, 1, [](std::size_t) noexcept { return true; });
  for (std::size_t i = 0; i < job.left; ++i) {
    if (!votes(job, i)) continue;
    ++job.votes;
    if (!job.trace({.step = HoughPlaneStep::vote, .plane = {}, .voter = job.memory.free[i]}))
      return Status::cancelled;
  }
  return Status::ok;
}

/// Steps 3 and 4. `more`: a plane was found.
Status next_plane(CloudJob& job, bool& more) noexcept {
  detail::HoughPlaneMemory& memory = job.memory;
  std::array<HoughPlanePeak, most_peaks> peaks;
  std::uint32_t count = 0;
  more = false;
  Status status = low_pass_votes(memory.accumulator, memory.smooth);
  if (status != Status::ok) return status;
  // Low-passed votes count eight times; a plane on the border of cells has an eighth of its votes in each.
  const std::uint32_t least = job.options.min_points / job.options.every;
  status = find_plane_peaks(memory.accumulator, memory.smooth, least, peaks, count);
  if (status != Status::ok && status != Status::output_full) return status;
  for (const HoughPlanePeak& peak : std::span(peaks).first(count)) {
    const Plane plane = memory.accumulator.plane(peak.direction, peak.distance);
    const Plane seen = job.in_input_frame(plane);
    if (!job.trace({.step = HoughPlaneStep::peak, .plane = seen, .votes = peak.votes})) {
      return Status::cancelled;
    }
    if (!refit_peak(job, plane)) continue;
    job.planes[job.found].score = memory.accumulator.votes(peak.direction, peak.distance);
    more = true;
    break;
  }
  return Status::ok;
}

}  // namespace

Status vote_standard(CloudJob& job) noexcept {
  // Step 2.
  if (const Status status = cast_all(job); status != Status::ok) return status;
  while (job.left >= job.options.min_points && job.found < job.planes.size()) {
    // Steps 3 and 4.
    bool more = false;
    if (const Status status = next_plane(job, more); status != Status::ok) return status;
    if (!more) break;
    // Step 5.
    cast(job, ~std::uint32_t{0}, [&](std::size_t i) noexcept { return job.labels[job.memory.free[i]] != 0; });
    drop_labelled(job);
    FoundPlane& plane = job.planes[job.found++];
    plane.iterations = job.votes;
    if (!job.trace({HoughPlaneStep::plane, plane.fit.plane, job.found, plane.inliers})) {
      return Status::cancelled;
    }
  }
  return Status::ok;
}

}  // namespace straightedge::hough
