// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <array>

#include "cases.hpp"
#include "hash_results.hpp"
#include "inputs.hpp"
#include "memory.hpp"
#include "straightedge/frame_planes.hpp"
#include "straightedge/hough_plane_patches.hpp"
#include "straightedge/ransac_search.hpp"

namespace same_bits {
namespace {

using namespace straightedge;

constexpr std::size_t pixels = std::size_t{depth_size.width} * depth_size.height;
constexpr FramePlanesOptions frame_options{};
constexpr RansacSearchOptions ransac_options = for_frame(RansacSearchOptions{}, depth_size, frame_options);
constexpr HoughPatchOptions hough_options =
    for_frame(HoughPatchOptions{.accumulator = {HoughCells::ball, 24, 48}}, depth_size, frame_options);
constexpr std::size_t frame_bytes = FramePlanes::workspace_bytes(depth_size, frame_options);
constexpr std::size_t ransac_bytes = RansacSearch::workspace_bytes(depth_size, ransac_options);
constexpr std::size_t hough_bytes = HoughPatchSearch::workspace_bytes(depth_size, hough_options);
static_assert(frame_bytes + (ransac_bytes > hough_bytes ? ransac_bytes : hough_bytes) <= most_workspace);

SAME_BITS_LARGE std::array<std::uint16_t, pixels> labels;
SAME_BITS_LARGE std::array<FoundPlane, 64> planes;

void rows_of(const Report& report, const DepthView& depth, const PlaneSearch& search,
             const FramePlanesOptions& options, std::span<std::byte> memory, const char* name) noexcept {
  const ImageView<std::uint16_t> label_view(labels.data(), depth_size);
  FramePlanes frame;
  PlanesFound found;
  Hash cells, planes_hash, labels_hash;
  planes_hash.add(frame.prepare(depth_size, options, memory));
  planes_hash.add(frame.run(depth, search, label_view, planes, found), found);
  planes_hash.add(std::span<const FoundPlane>(planes).first(found.planes));
  for (int level = 0; level < DepthCells::levels; ++level) cells.add(frame.cell_labels(level));
  labels_hash.add(label_view, frame.inverse_depth());
  report.row({"frame_planes.cells.", name}, cells);
  report.row({"frame_planes.labels.", name}, labels_hash);
  report.row({"frame_planes.planes.", name}, planes_hash);
}

}  // namespace

void frame_plane_cases(const Report& report, const Kernels& kernels) noexcept {
  FramePlanesOptions frame = frame_options;
  frame.kernels = kernels.depth;
  RansacSearchOptions ransac_search = ransac_options;
  ransac_search.kernels = kernels.plane_search;
  HoughPatchOptions hough_search = hough_options;
  hough_search.kernels = kernels.depth;
  RansacSearch ransac;
  HoughPatchSearch hough;
  Hash ready;
  std::span<std::byte> memory = workspace();
  ready.add(RansacSearch::prepare(ransac, depth_size, ransac_search, memory.subspan(frame_bytes)));
  rows_of(report, depth_picture(), plane_search(ransac), frame, memory.first(frame_bytes), "ransac");
  rows_of(report, blank_depth(), plane_search(ransac), frame, memory.first(frame_bytes), "blank");
  memory = workspace();
  ready.add(HoughPatchSearch::prepare(hough, depth_size, hough_search, memory.subspan(frame_bytes)));
  rows_of(report, depth_picture(), plane_search(hough), frame, memory.first(frame_bytes), "hough");
  report.row({"frame_planes.prepare"}, ready);
}

}  // namespace same_bits
