// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "hough/planes/patch_cells.hpp"
#include "hough/planes/patch_growth.hpp"
#include "hough/planes/patch_rivals.hpp"
#include "hough/planes/patch_tree.hpp"
#include "hough/planes/patch_votes.hpp"
#include "straightedge/hough_plane_patches.hpp"

namespace straightedge {
namespace {

using hough::PatchScene;

std::uint32_t sum_levels(const hough::DepthInput& input, HoughPatchSearch::Memory& memory,
                         std::int32_t largest) noexcept {
  hough::sum_cells(input, memory.levels[0]);
  double readings = 0;
  for (const InverseDepthMoments& cell : memory.levels[0]) readings += cell.n;
  std::int32_t side = hough_patch_side;
  for (std::size_t level = 1; 2 * side <= largest; ++level) {
    const Size cells{(input.inverse_depth.width + side - 1) / side,
                     (input.inverse_depth.height + side - 1) / side};
    hough::sum_four(memory.levels[level - 1], cells, memory.levels[level]);
    side *= 2;
  }
  return static_cast<std::uint32_t>(readings);
}

std::uint32_t vote(std::span<const HoughPatch> patches, double step_m,
                   HoughAccumulator& accumulator) noexcept {
  accumulator.clear(step_m);
  const double area = accumulator.directions().cell_size() * accumulator.directions().cell_size();
  std::uint32_t votes = 0;
  for (const HoughPatch& patch : patches) {
    if (!patch.votes || patch.candidate != 0) continue;
    hough::cast_vote(patch, area, accumulator);
    ++votes;
  }
  return votes;
}

/// Takes out candidates that others explain, those with few readings first. Returns how many are left.
std::uint32_t drop_explained(const PatchScene& scene, const hough::DepthInput& input,
                             std::span<HoughPatch> patches,
                             std::span<HoughPlaneCandidate> candidates) noexcept {
  std::uint32_t last = 0;
  for (;;) {
    // The next one in order of (readings, index).
    std::uint32_t next = 0;
    bool any = false;
    for (std::uint32_t i = 0; i < candidates.size(); ++i) {
      if (candidates[i].pixels <= last) continue;
      if (!any || candidates[i].pixels < candidates[next].pixels) next = i;
      any = true;
    }
    if (!any) break;
    last = candidates[next].pixels;
    if (hough::explained_by_rivals(scene, input, patches, candidates, next)) candidates[next].pixels = 0;
  }
  std::uint32_t left = 0;
  for (const HoughPlaneCandidate& candidate : candidates) {
    if (candidate.pixels != 0) candidates[left++] = candidate;
  }
  return left;
}

/// Candidates with many readings first; ties keep their order.
void sort(std::span<HoughPlaneCandidate> candidates) noexcept {
  for (std::size_t i = 1; i < candidates.size(); ++i) {
    const HoughPlaneCandidate moved = candidates[i];
    std::size_t place = i;
    for (; place > 0 && candidates[place - 1].pixels < moved.pixels; --place) {
      candidates[place] = candidates[place - 1];
    }
    candidates[place] = moved;
  }
}

}  // namespace

Status HoughPatchSearch::prepare(HoughPatchSearch& search, Size size, const HoughPatchOptions& options,
                                 std::span<std::byte> workspace) noexcept {
  search = {};
  if (size.width < 1 || size.height < 1) return Status::invalid_image;
  if (!fits(size)) return Status::too_large;
  if (!valid(options)) return Status::invalid_option;
  Arena arena(workspace);
  Memory memory;
  memory.take(arena, size, options);
  if (arena.failed()) return Status::workspace_too_small;
  memory.accumulator.fill(options.accumulator.cells);
  search.memory_ = memory;
  search.options_ = options;
  search.size_ = size;
  return Status::ok;
}

HoughPatchResult HoughPatchSearch::run(ImageView<const float> inverse_depth, const PinholeCamera& camera,
                                       const PlaneGate& gate, ImageView<const std::uint16_t> mask,
                                       std::span<HoughPlaneCandidate> candidates) noexcept {
  HoughPatchResult result;
  patches_ = 0;
  if (size_.width == 0) return result;
  result.status = Status::invalid_image;
  if (!inverse_depth.valid() || !camera.valid()) return result;
  if (mask.data != nullptr && !mask.valid()) return result;
  result.status = Status::size_mismatch;
  if (inverse_depth.size() != size_ || (mask.data != nullptr && mask.size() != size_)) return result;
  result.status = Status::invalid_option;
  if (!gate.valid()) return result;
  result.status = Status::ok;

  const PatchScene scene{size_, camera, gate, options_, memory_.accumulator.directions().cell_size()};
  result.readings = sum_levels({inverse_depth, mask}, memory_, options_.largest_patch);
  patches_ = hough::make_patches(scene, memory_.levels, memory_.patches);
  const std::span<HoughPatch> patches = memory_.patches.first(patches_);
  for (HoughPatch& patch : patches) hough::shape_vote(scene, patch);
  result.patches = static_cast<std::uint32_t>(patches_);
  const double step = options_.max_distance_m / options_.accumulator.distances;

  std::uint32_t found = 0;
  for (std::int32_t round = 0; round < options_.rounds; ++round) {
    const std::uint32_t votes = vote(patches, step, memory_.accumulator);
    if (votes == 0) break;
    result.votes += votes;
    std::uint32_t peaks = 0;
    const std::uint32_t least = options_.min_pixels * hough_patch_vote / 64;
    const Status status = find_plane_peaks(memory_.accumulator, memory_.accumulator.votes(), least,
                                           memory_.peaks, peaks);
    static_cast<void>(status);
    const std::uint32_t before = found;
    for (const HoughPlanePeak& peak : memory_.peaks.first(peaks)) {
      if (found == memory_.candidates.size()) break;
      HoughPlaneCandidate& candidate = memory_.candidates[found];
      const Plane plane = memory_.accumulator.plane(peak.direction, peak.distance);
      if (!hough::grow(scene, plane, step, patches, static_cast<std::uint16_t>(found + 1), candidate)) continue;
      candidate.votes = peak.votes;
      ++found;
    }
    if (found == before) break;
  }
  found = drop_explained(scene, {inverse_depth, mask}, patches, memory_.candidates.first(found));
  sort(memory_.candidates.first(found));
  for (std::uint32_t i = 0; i < found; ++i) {
    if (i == candidates.size()) {
      result.status = Status::output_full;
      break;
    }
    candidates[i] = memory_.candidates[i];
    ++result.candidates;
  }
  return result;
}

}  // namespace straightedge
