// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/consensus.hpp"
#include "ransac/frame_labels.hpp"
#include "ransac/pieces.hpp"
#include "ransac/verify.hpp"
#include "straightedge/ransac_planes.hpp"
#include "straightedge/ransac_stop.hpp"

namespace straightedge {
namespace {

using ransac::LinearPlane;
using ransac::Readings;

/// The stream of a plane's subset: above those of its hypotheses, which are fewer than 2^31.
constexpr std::uint64_t subset_stream(std::uint32_t plane) noexcept {
  return (std::uint64_t{plane} << 32U) + (std::uint64_t{1} << 31U);
}

struct Job {
  const Readings& readings;
  const RansacOptions& options;
  const detail::RansacPlanesMemory& memory;
  std::span<std::uint16_t> labels;
  std::span<FoundPlane> out;
  RansacPlanesResult& result;
  std::uint32_t least = 0;  ///< readings of a plane
};

/// What remains of a plane when there are fewer: nothing.
std::uint32_t least_inliers(const RansacOptions& o, std::uint32_t readings) noexcept {
  const double share = o.min_share * readings;
  const auto whole = static_cast<std::uint32_t>(share);
  const std::uint32_t by_share = whole < share ? whole + 1 : whole;
  return by_share > o.min_inliers ? by_share : o.min_inliers;
}

/// Step 6. False: no plane of enough readings.
bool verify(Job& job, const LinearPlane& plane, FoundPlane& found) noexcept {
  const ransac::ModelSums sums = ransac::sum_inliers(job.readings, job.labels, plane);
  if (!ransac::fit_found(sums, job.readings, found.fit)) return false;
  const std::uint32_t index = job.result.found.planes;
  const auto label = static_cast<std::uint16_t>(index + 1);
  found.inliers = ransac::label_inliers(job.readings, ransac::to_linear(found.fit.plane, job.readings), label,
                                        job.labels);
  if (found.inliers >= job.least) return true;
  for (std::uint16_t& l : job.labels) l = l == label ? std::uint16_t{0} : l;
  return false;
}

/// Steps 1 to 6 once. False: the search is over.
bool next_plane(Job& job) noexcept {
  PlanesFound& total = job.result.found;
  // Step 1.
  ransac::Subset subset{job.readings, job.memory};
  ransac::draw_subset(subset, job.labels, job.options.subset, job.options.seed, subset_stream(total.planes));
  // Steps 2 to 5.
  const ransac::Consensus best = ransac::find_consensus(subset, job.options, total.planes);
  total.iterations += best.iterations;
  if (best.cancelled) {
    job.result.status = Status::cancelled;
    return false;
  }
  // Step 6.
  FoundPlane found;
  if (best.inliers < 3 || !verify(job, best.plane, found)) return false;
  if (total.planes == job.out.size()) {
    job.result.status = Status::output_full;
    for (std::uint16_t& l : job.labels) l = l == total.planes + 1 ? std::uint16_t{0} : l;
    return false;
  }
  found.iterations = best.iterations;
  found.confidence = 1 - miss_probability(best.probability, best.iterations);
  found.score = static_cast<double>(subset.count) - static_cast<double>(best.cost);
  job.out[total.planes++] = found;
  total.labelled += found.inliers;
  return true;
}

void refit(Job& job, std::span<FoundPlane> planes) noexcept {
  if (job.readings.is_frame()) {
    ransac::refit_labelled_pixels(job.readings, job.labels, planes);
  } else {
    (void)refit_labelled(job.readings.points, job.labels, job.options.gate, planes);
  }
}

/// Step 7.
void label(Job& job) noexcept {
  const std::span<FoundPlane> planes = job.out.first(job.result.found.planes);
  if (job.readings.is_frame()) {
    for (std::uint16_t& l : job.labels) l = 0;
    job.result.found.labelled = ransac::label_nearest_pixels(job.readings, planes, job.labels);
  } else {
    (void)label_nearest(job.readings.points, planes, job.options.gate, job.labels, job.result.found.labelled);
  }
  refit(job, planes);
}

/// Planes of which no piece was large enough leave; the others move up.
void drop_empty(Job& job) noexcept {
  std::uint32_t& planes = job.result.found.planes;
  for (std::uint32_t i = planes; i-- > 0;) {
    if (job.out[i].inliers > 0) continue;
    for (std::uint32_t j = i; j + 1 < planes; ++j) job.out[j] = job.out[j + 1];
    for (std::uint16_t& l : job.labels) l = l > i + 1 ? static_cast<std::uint16_t>(l - 1) : l;
    --planes;
  }
}

/// Step 8.
void split(Job& job) noexcept {
  PlanesFound& total = job.result.found;
  bool full = false;
  total.planes = ransac::split_pieces(job.readings, job.memory, job.options.piece_cell_m, job.least,
                                      total.planes, job.out, full);
  if (full && job.result.status == Status::ok) job.result.status = Status::output_full;
  const std::span<FoundPlane> planes = job.out.first(total.planes);
  refit(job, planes);
  total.labelled = 0;
  for (const FoundPlane& plane : planes) total.labelled += plane.inliers;
  drop_empty(job);
}

void find_planes(Job& job) noexcept {
  for (std::uint16_t& l : job.labels) l = 0;
  job.result.status = Status::ok;
  job.result.found.seed = job.options.seed;
  job.result.found.readings = ransac::count_readings(job.readings, job.labels);
  job.least = least_inliers(job.options, job.result.found.readings);
  while (job.result.found.planes < job.options.max_planes && next_plane(job)) {
  }
  if (job.result.found.planes > 1) label(job);
  if (job.options.split) split(job);
}

/// A point near which floats resolve the others.
Vector3 first_reading(const PointsView& points) noexcept {
  for (std::size_t i = 0; i < points.count; ++i)
    if (finite(points.at(i))) return points.at(i);
  return {};
}

}  // namespace

Status RansacPlanes::prepare(RansacPlanes& planes, std::size_t readings, const RansacOptions& options,
                             std::span<std::byte> workspace) noexcept {
  planes.readings_ = 0;
  if (!detail::valid(options)) return Status::invalid_option;
  if (readings < 1 || readings > (std::size_t{1} << 31U)) return Status::too_large;
  Arena arena(workspace);
  planes.memory_ = detail::RansacPlanesMemory::take(arena, readings, options);
  if (arena.failed()) return Status::workspace_too_small;
  planes.options_ = options;
  planes.readings_ = readings;
  return Status::ok;
}

RansacPlanesResult RansacPlanes::run(const PointsView& points, std::span<FoundPlane> out,
                                     std::span<std::uint16_t> labels) noexcept {
  RansacPlanesResult result;
  if (readings_ == 0) return result;
  result.status = !points.valid() ? Status::invalid_image : Status::size_mismatch;
  if (!points.valid() || points.count > readings_ || (!labels.empty() && labels.size() != points.count))
    return result;
  Readings readings;
  readings.points = points;
  readings.camera = {1, 1, 0, 0};
  readings.gate = options_.gate;
  if (options_.gate.fixed_m > 0) readings.origin = first_reading(points);
  Job job{readings, options_, memory_, memory_.label.first(points.count), out, result};
  find_planes(job);
  for (std::size_t i = 0; i < labels.size(); ++i) labels[i] = job.labels[i];
  return result;
}

RansacPlanesResult RansacPlanes::run(ImageView<const float> inverse_depth, const PinholeCamera& camera,
                                     std::span<FoundPlane> out, ImageView<std::uint16_t> labels) noexcept {
  RansacPlanesResult result;
  if (readings_ == 0) return result;
  const bool labelled = labels.data != nullptr;
  result.status = Status::invalid_image;
  if (!inverse_depth.valid() || !camera.valid() || (labelled && !labels.valid())) return result;
  result.status = Status::size_mismatch;
  const std::size_t pixels =
      static_cast<std::size_t>(inverse_depth.width) * static_cast<std::size_t>(inverse_depth.height);
  if (pixels > readings_ || (labelled && labels.size() != inverse_depth.size())) return result;
  Readings readings;
  readings.frame = inverse_depth;
  readings.camera = camera;
  readings.gate = options_.gate;
  Job job{readings, options_, memory_, memory_.label.first(pixels), out, result};
  find_planes(job);
  if (labelled) {
    const std::uint16_t* from = job.labels.data();
    for (std::int32_t v = 0; v < labels.height; ++v) {
      std::uint16_t* to = labels.row(v);
      for (std::int32_t u = 0; u < labels.width; ++u) to[u] = *from++;
    }
  }
  return result;
}

}  // namespace straightedge
