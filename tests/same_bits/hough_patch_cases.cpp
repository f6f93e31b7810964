// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <array>

#include "cases.hpp"
#include "hash_results.hpp"
#include "inputs.hpp"
#include "memory.hpp"
#include "straightedge/hough_plane_patches.hpp"

namespace same_bits {
namespace {

using namespace straightedge;

constexpr HoughPatchOptions options{.accumulator = {HoughCells::ball, 24, 48}, .min_pixels = 100};
constexpr HoughPatchOptions array_options{.accumulator = {HoughCells::array, 24, 48},
                                          .largest_patch = 16,
                                          .warp_sigmas = 0,
                                          .min_pixels = 100,
                                          .rounds = 1};
constexpr std::size_t search_bytes = HoughPatchSearch::workspace_bytes(depth_size, array_options);
constexpr std::size_t depth_pixels = std::size_t{depth_size.width} * depth_size.height;
static_assert(depth_pixels * sizeof(float) + search_bytes <= most_workspace);
static_assert(HoughPatchSearch::workspace_bytes(depth_size, options) <= search_bytes);

SAME_BITS_LARGE std::array<ProposedPlane, 64> candidates;

void rows_of(const Report& report, const DepthView& depth, const HoughPatchOptions& chosen,
             const char* name) noexcept {
  const std::span<std::byte> memory = workspace();
  const ImageView<float> inverse(reinterpret_cast<float*>(memory.data()), depth_size);
  HoughPatchSearch search;
  Hash patches, votes, found;
  found.add(inverse_depth_image(depth, inverse));
  found.add(
      HoughPatchSearch::prepare(search, depth_size, chosen, memory.subspan(depth_pixels * sizeof(float))));
  const HoughPatchResult result = search.run(inverse, depth.camera, {}, candidates);
  found.add(result, std::span<const ProposedPlane>(candidates).first(result.candidates));
  patches.add(search.patches());
  votes.add(search.accumulator().votes());
  report.row({"hough_patches.patches", name}, patches);
  report.row({"hough_patches.votes", name}, votes);
  report.row({"hough_patches.candidates", name}, found);
}

}  // namespace

void hough_patch_cases(const Report& report, const Kernels& kernels) noexcept {
  const auto with_kernels = [&](HoughPatchOptions chosen) {
    chosen.kernels = kernels.depth;
    return chosen;
  };
  rows_of(report, depth_picture(), with_kernels(options), ".ball");
  rows_of(report, depth_picture(), with_kernels(array_options), ".array");
  rows_of(report, blank_depth(), with_kernels(options), ".blank");
}

}  // namespace same_bits
