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

using hough::DepthInput;
using hough::PatchScene;

// Patches that know their normal badly spread their votes thin: a plane has at least this part of them in its
// best cell.
constexpr std::uint32_t thinnest = 16;
// A patch with less than this part of the readings that a plane needs is small change, spread over many
// cells.
constexpr std::uint32_t smallest_voter = 64;

/// What the steps of one run share.
struct Search {
  const PatchScene& scene;
  detail::HoughPatchMemory& memory;
  hough::PatchPool pool;
  HoughPlaneTrace trace;
  std::uint32_t found = 0;
  std::uint32_t votes = 0;
};

Status check(Size size, const DepthInput& input, const PinholeCamera& camera) noexcept {
  if (size.width == 0) return Status::not_prepared;
  const bool masked = input.mask.data != nullptr;
  if (!input.inverse_depth.valid() || !camera.valid() || (masked && !input.mask.valid())) {
    return Status::invalid_image;
  }
  const bool fits = input.inverse_depth.size() == size && (!masked || input.mask.size() == size);
  return fits ? Status::ok : Status::size_mismatch;
}

std::uint32_t count_readings(const hough::PatchLevels& levels) noexcept {
  constexpr std::int32_t coarsest = hough::PatchLevels::count - 1;
  const Size squares = levels.squares(coarsest);
  double readings = 0;
  for (std::size_t i = 0; i < DepthCells::cell_count(squares); ++i) {
    readings += static_cast<double>(levels.readings(coarsest)[i]);
  }
  return static_cast<std::uint32_t>(readings);
}

/// Step 2.
std::span<HoughPatch> cut(const PatchScene& scene, const hough::PatchLevels& levels,
                          detail::HoughPatchMemory& memory) noexcept {
  const std::size_t count = hough::make_patches(scene, levels, memory.patches);
  const std::span<HoughPatch> patches = memory.patches.first(count);
  for (HoughPatch& patch : patches) {
    hough::shape_vote(scene, patch);
    patch.votes = patch.votes && hough::readings_of(patch) * smallest_voter >= scene.options.min_pixels;
  }
  return patches;
}

/// Step 3. How many voted; cancelled: the trace wants to stop.
Status vote(Search& search, std::uint32_t& voters) noexcept {
  HoughAccumulator& accumulator = search.memory.accumulator;
  voters = 0;
  for (const HoughPatchMean& mean : search.pool.free) {
    const HoughPatch& patch = search.pool.of(mean);
    if (!patch.votes) continue;
    if (voters == 0) accumulator.clear(search.scene.step_m);
    hough::cast_vote(patch, accumulator);
    ++voters;
    if (!search.trace({.step = HoughPlaneStep::vote, .plane = patch.space, .voter = mean.patch})) {
      return Status::cancelled;
    }
  }
  return Status::ok;
}

/// Steps 4 and 5.
Status grow_peaks(Search& search) noexcept {
  detail::HoughPatchMemory& memory = search.memory;
  const HoughAccumulator& accumulator = memory.accumulator;
  const std::uint32_t least = search.scene.options.min_pixels / thinnest * hough_patch_vote;
  std::uint32_t peaks = 0;
  const Status status = find_plane_peaks(accumulator, accumulator.votes(), least, memory.peaks, peaks);
  // Peaks that had no room are lower than those that had; what they stand for votes again.
  static_cast<void>(status);
  for (const HoughPlanePeak& peak : memory.peaks.first(peaks)) {
    if (search.found == memory.candidates.size()) break;
    ProposedPlane& candidate = memory.candidates[search.found];
    candidate = {};
    const Plane plane = accumulator.plane(peak.direction, peak.distance);
    if (!search.trace({.step = HoughPlaneStep::peak, .plane = plane, .votes = peak.votes})) {
      return Status::cancelled;
    }
    const auto number = static_cast<std::uint16_t>(search.found + 1);
    if (!hough::grow(search.scene, plane, search.pool, number, candidate)) continue;
    candidate.score = peak.votes;
    ++search.found;
    if (!search.trace({HoughPlaneStep::plane, search.scene.space(candidate.fit.plane), number, peak.votes})) {
      return Status::cancelled;
    }
  }
  return Status::ok;
}

/// Have the free patches together as many readings as a candidate needs?
bool enough_left(const Search& search) noexcept {
  double readings = 0;
  for (const HoughPatchMean& mean : search.pool.free) readings += hough::readings_of(search.pool.of(mean));
  return readings >= search.scene.options.min_pixels;
}

/// Step 6.
Status search_rounds(Search& search) noexcept {
  for (std::int32_t round = 0; round < search.scene.options.rounds && enough_left(search); ++round) {
    std::uint32_t voters = 0;
    if (const Status status = vote(search, voters); status != Status::ok) return status;
    search.votes += voters;
    if (voters == 0) break;
    const std::uint32_t before = search.found;
    if (const Status status = grow_peaks(search); status != Status::ok) return status;
    if (search.found == before) break;
  }
  return Status::ok;
}

/// Candidates with many readings first; ties keep their order.
void sort(std::span<ProposedPlane> candidates) noexcept {
  for (std::size_t i = 1; i < candidates.size(); ++i) {
    const ProposedPlane moved = candidates[i];
    std::size_t place = i;
    for (; place > 0 && candidates[place - 1].readings < moved.readings; --place) {
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
  if (!detail::valid(options)) return Status::invalid_option;
  Arena arena(workspace);
  detail::HoughPatchMemory memory;
  memory.take(arena, size, options);
  if (arena.failed()) return Status::workspace_too_small;
  memory.accumulator.fill(options.accumulator.cells);
  search.memory_ = memory;
  search.options_ = options;
  search.size_ = size;
  return Status::ok;
}

HoughPatchResult HoughPatchSearch::run(ImageView<const float> inverse_depth, const PinholeCamera& camera,
                                       ImageView<const std::uint16_t> mask,
                                       std::span<ProposedPlane> candidates, HoughPlaneTrace trace,
                                       const DepthCells* cells) noexcept {
  const DepthInput input{inverse_depth, mask};
  HoughPatchResult result;
  patches_ = 0;
  result.status = check(size_, input, camera);
  if (result.status != Status::ok) return result;
  const PatchScene scene{size_,
                         camera,
                         options_.gate,
                         options_,
                         memory_.accumulator.directions().cell_size(),
                         options_.max_distance_m / options_.accumulator.distances};
  // Step 1.
  const hough::PatchLevels levels = hough::sum_squares(input, cells, *options_.kernels, memory_);
  result.readings = count_readings(levels);
  // Step 2.
  const std::span<HoughPatch> patches = cut(scene, levels, memory_);
  patches_ = patches.size();
  result.patches = static_cast<std::uint32_t>(patches.size());
  // Steps 3 to 6.
  Search search{scene, memory_, hough::make_pool(patches, memory_.means), trace};
  result.status = search_rounds(search);
  result.votes = search.votes;
  // Step 7.
  const std::uint32_t left =
      hough::drop_explained(scene, input, patches, memory_.candidates.first(search.found), memory_.contests);
  sort(memory_.candidates.first(left));
  for (const ProposedPlane& candidate : memory_.candidates.first(left)) {
    if (result.candidates == candidates.size()) {
      result.status = Status::output_full;
      break;
    }
    candidates[result.candidates] = candidate;
    candidates[result.candidates++].iterations = result.votes;
  }
  return result;
}

PlaneSearch plane_search(HoughPatchSearch& search) noexcept {
  return {&search, [](void* user, ImageView<const float> inverse_depth, const DepthCells& cells,
                      ImageView<const std::uint16_t> labels, const PinholeCamera& camera,
                      std::span<ProposedPlane> out, std::uint32_t& count) noexcept {
            const HoughPatchResult result =
                static_cast<HoughPatchSearch*>(user)->run(inverse_depth, camera, labels, out, {}, &cells);
            count = result.candidates;
            return result.status;
          }};
}

}  // namespace straightedge
