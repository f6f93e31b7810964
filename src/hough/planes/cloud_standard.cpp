// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <array>
#include <span>

#include "hough/planes/cloud_job.hpp"

namespace straightedge::hough {
namespace {

constexpr std::size_t most_peaks = 8;

/// The point's number decides whether it votes: so it takes back what it gave, however the list has shrunk.
bool votes(const CloudJob& job, std::size_t i) noexcept {
  return job.memory.free[i] % job.options.every == 0;
}

/// Points that vote together.
struct Voters {
  std::span<float> x, y, z;
  std::size_t count = 0;
};

Voters no_voters(const CloudJob& job) noexcept {
  const std::span<float> all = job.memory.voters;
  const std::size_t room = all.size() / 3;
  return {all.first(room), all.subspan(room, room), all.last(room)};
}

/// Step 2 for points that vote together: every direction is looked up once for all of them. `vote` is +1 or,
/// to take votes back, −1 (as an unsigned number).
void cast(const Voters& voters, std::uint32_t vote, HoughAccumulator& accumulator) noexcept {
  const HoughDirections& directions = accumulator.directions();
  for (std::int32_t direction = 0; direction < directions.size(); ++direction) {
    const Vector3& n = directions.centre(direction);
    const auto nx = static_cast<float>(n.x), ny = static_cast<float>(n.y), nz = static_cast<float>(n.z);
    for (std::size_t i = 0; i < voters.count; ++i) {
      const float d = nx * voters.x[i] + ny * voters.y[i] + nz * voters.z[i];
      if (d >= 0) accumulator.votes(direction, accumulator.distance_cell(static_cast<double>(d))) += vote;
    }
  }
}

/// The same for all free points that vote and that `takes` says.
template <class Takes>
void cast_all(CloudJob& job, std::uint32_t vote, Takes takes) noexcept {
  Voters voters = no_voters(job);
  for (std::size_t i = 0; i < job.left; ++i) {
    if (!votes(job, i) || !takes(i)) continue;
    voters.x[voters.count] = job.memory.x[i];
    voters.y[voters.count] = job.memory.y[i];
    voters.z[voters.count] = job.memory.z[i];
    if (++voters.count < voters.x.size()) continue;
    cast(voters, vote, job.memory.accumulator);
    voters.count = 0;
  }
  cast(voters, vote, job.memory.accumulator);
}

Status first_votes(CloudJob& job) noexcept {
  cast_all(job, 1, [](std::size_t) noexcept { return true; });
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
  if (const Status status = first_votes(job); status != Status::ok) return status;
  while (job.left >= job.options.min_points && job.found < job.planes.size()) {
    // Steps 3 and 4.
    bool more = false;
    if (const Status status = next_plane(job, more); status != Status::ok) return status;
    if (!more) break;
    // Step 5.
    cast_all(job, ~std::uint32_t{0},
             [&](std::size_t i) noexcept { return job.labels[job.memory.free[i]] != 0; });
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
