// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/consensus.hpp"
#include "ransac/frame_labels.hpp"
#include "ransac/pieces.hpp"
#include "ransac/verify.hpp"
#include "ransac/win.hpp"
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
  ransac::Labels labels;
  std::span<FoundPlane> out;
  RansacPlanesResult& result;
  std::uint32_t least = 0;  ///< readings of a plane
  std::uint32_t left = 0;   ///< readings of a cloud without a label
  bool guessed = false;     ///< left: every point of the cloud is taken for a reading

  ransac::Verify verify() const noexcept { return {readings, labels, *options.kernels}; }
  /// The labels as one row, which those of several planes are.
  std::span<std::uint16_t> all_labels() const noexcept { return {labels.data, readings.count()}; }
};

/// What remains of a plane when there are fewer: nothing.
std::uint32_t least_inliers(const RansacOptions& o, std::uint32_t readings) noexcept {
  const double share = o.min_share * readings;
  const auto whole = static_cast<std::uint32_t>(share);
  const std::uint32_t by_share = whole < share ? whole + 1 : whole;
  return by_share > o.min_inliers ? by_share : o.min_inliers;
}

/// Step 7. False: no plane of enough readings.
bool verify(Job& job, const LinearPlane& plane, FoundPlane& found) noexcept {
  const ransac::Verify all = job.verify();
  std::uint32_t seen = 0;
  const ransac::ModelSums sums = all.sum_inliers(plane, 1, seen);
  const std::uint32_t index = job.result.found.planes;
  if (index == 0) {
    job.result.found.readings = seen;
    if (job.guessed && seen < job.left) return false;
    job.least = least_inliers(job.options, seen);
  }
  found.inliers = static_cast<std::uint32_t>(sums.count());
  if (found.inliers < job.least || !ransac::fit_found(sums, job.readings, found.fit)) return false;
  if (job.labels.kept()) all.label_inliers(plane, static_cast<std::uint16_t>(index + 1));
  return true;
}

/// Steps 6 and 7. False: no plane, or no room for it. A function of its own, whose memory on the stack is
/// free while the search lasts.
[[gnu::noinline]] bool settle(Job& job, const ransac::Subset& subset,
                              const ransac::Consensus& best) noexcept {
  PlanesFound& total = job.result.found;
  FoundPlane found;
  if (best.inliers < 3 || !verify(job, ransac::win(job.verify(), subset, best), found)) return false;
  if (total.planes == job.out.size()) {
    job.result.status = Status::output_full;
    job.labels.change([&](std::uint16_t l) { return l == total.planes + 1 ? std::uint16_t{0} : l; });
    return false;
  }
  found.iterations = best.iterations;
  found.confidence = 1 - miss_probability(best.probability, best.iterations);
  found.score = static_cast<double>(subset.count) - static_cast<double>(best.candidates[best.best].cost);
  job.out[total.planes++] = found;
  total.labelled += found.inliers;
  job.left -= found.inliers;
  return true;
}

/// Steps 1 to 7 once. False: the search is over.
[[gnu::noinline]] bool next_plane(Job& job) noexcept {
  const std::uint32_t number = job.result.found.planes;
  // Step 1.
  ransac::Subset subset{job.readings, job.memory};
  if (!ransac::draw_subset(subset, job.labels, job.options, job.left, subset_stream(number))) return false;
  // Steps 2 to 5.
  const ransac::Consensus best = ransac::find_consensus(subset, job.options, number);
  job.result.found.iterations += best.iterations;
  if (best.cancelled) job.result.status = Status::cancelled;
  return !best.cancelled && settle(job, subset, best);
}

void refit(Job& job, std::span<FoundPlane> planes) noexcept {
  if (job.readings.is_frame()) {
    ransac::refit_labelled_pixels(job.readings, job.all_labels(), planes);
  } else {
    (void)refit_labelled(job.readings.points, job.all_labels(), job.options.gate, planes);
  }
}

/// Step 8.
void label(Job& job) noexcept {
  const std::span<FoundPlane> planes = job.out.first(job.result.found.planes);
  if (job.readings.is_frame()) {
    job.result.found.labelled = ransac::label_nearest_pixels(job.readings, planes, job.all_labels());
  } else {
    (void)label_nearest(job.readings.points, planes, job.options.gate, job.all_labels(),
                        job.result.found.labelled);
  }
  refit(job, planes);
}

/// Planes of which no piece was large enough leave; the others move up.
void drop_empty(Job& job) noexcept {
  std::uint32_t& planes = job.result.found.planes;
  for (std::uint32_t i = planes; i-- > 0;) {
    if (job.out[i].inliers > 0) continue;
    for (std::uint32_t j = i; j + 1 < planes; ++j) job.out[j] = job.out[j + 1];
    job.labels.change([&](std::uint16_t l) { return l > i + 1 ? static_cast<std::uint16_t>(l - 1) : l; });
    --planes;
  }
}

/// Step 9.
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
  job.labels.change([](std::uint16_t) { return std::uint16_t{0}; });
  job.result.status = Status::ok;
  PlanesFound& found = job.result.found;
  found.seed = job.options.seed;
  while (found.planes < job.options.max_planes && next_plane(job)) {
  }
  if (found.planes == 0) found.readings = job.verify().count_free();
  if (found.planes > 1) label(job);
  if (job.options.split) split(job);
}

/// Of a cloud nearly always every point is a reading, and to count them is a pass over all. So that is taken
/// for granted until verifying has counted them: if there are fewer, all begins again with their number.
/// Who watches the search gets the true one at once, and so sees every hypothesis once.
void find_planes_of_cloud(Job& job, Readings& readings, detail::CloudBlock* block) noexcept {
  job.left = readings.count();
  job.guessed = job.options.trace.event == nullptr;
  if (job.guessed) find_planes(job);
  const std::uint32_t counted = job.guessed ? job.result.found.readings : job.verify().count_free();
  if (job.guessed && counted == readings.count()) return;
  job.left = counted;
  job.guessed = false;
  if (counted < readings.count()) readings.block = block;
  job.result = {};
  find_planes(job);
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
  const bool own = !memory_.label.empty();
  Job job{readings, options_, memory_, {}, out, result};
  job.labels = {own ? memory_.label.data() : labels.data(), points.count, 1, 0};
  find_planes_of_cloud(job, readings, memory_.block.empty() ? nullptr : memory_.block.data());
  if (own) {
    for (std::size_t i = 0; i < labels.size(); ++i) labels[i] = job.labels.data[i];
  }
  return result;
}

RansacPlanesResult RansacPlanes::run(ImageView<const float> inverse_depth, const PinholeCamera& camera,
                                     std::span<FoundPlane> out, ImageView<std::uint16_t> labels) noexcept {
  if (!inverse_depth.valid() || !camera.valid()) return refused(Status::invalid_image);
  Readings readings;
  readings.frame = inverse_depth;
  readings.camera = camera;
  return find(readings, out, labels);
}

RansacPlanesResult RansacPlanes::run(const DepthView& depth, std::span<FoundPlane> out,
                                     ImageView<std::uint16_t> labels) noexcept {
  if (!depth.valid()) return refused(Status::invalid_image);
  const double units_per_metre = 1 / depth.metres_per_unit;
  // Every quotient is a float of full precision then.
  if (!(units_per_metre > 1e-30 && units_per_metre < 1e38)) return refused(Status::invalid_option);
  Readings readings;
  readings.raw = depth.raw;
  readings.scale = static_cast<float>(units_per_metre);
  readings.camera = depth.camera;
  return find(readings, out, labels);
}

RansacPlanesResult RansacPlanes::find(ransac::Readings& readings, std::span<FoundPlane> out,
                                      ImageView<std::uint16_t> labels) noexcept {
  const bool labelled = labels.data != nullptr;
  if (labelled && !labels.valid()) return refused(Status::invalid_image);
  const Size size = readings.size();
  const std::size_t pixels = readings.count();
  if (pixels > readings_ || (labelled && labels.size() != size)) return refused(Status::size_mismatch);
  readings.gate = options_.gate;
  const bool own = !memory_.label.empty();
  const auto width = static_cast<std::size_t>(size.width), height = static_cast<std::size_t>(size.height);
  RansacPlanesResult result;
  Job job{readings, options_, memory_, {}, out, result};
  if (own) {
    job.labels = {memory_.label.data(), width, height, static_cast<std::ptrdiff_t>(2 * width)};
  } else if (labelled) {
    job.labels = {labels.data, width, height, labels.stride};
  }
  find_planes(job);
  for (std::int32_t v = 0; own && labelled && v < size.height; ++v) {
    const std::uint16_t* const from = job.labels.row(static_cast<std::size_t>(v));
    std::uint16_t* const to = labels.row(v);
    for (std::int32_t u = 0; u < size.width; ++u) to[u] = from[u];
  }
  return result;
}

RansacPlanesResult RansacPlanes::refused(Status status) const noexcept {
  RansacPlanesResult result;
  if (readings_ > 0) result.status = status;
  return result;
}

}  // namespace straightedge
