// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <array>

#include "cases.hpp"
#include "hash_results.hpp"
#include "inputs.hpp"
#include "memory.hpp"
#include "straightedge/ransac_planes.hpp"
#include "straightedge/ransac_stop.hpp"

namespace same_bits {
namespace {

using namespace straightedge;

constexpr std::size_t depth_pixels = std::size_t{depth_size.width} * depth_size.height;

template <class Change>
constexpr RansacOptions options_of(Change change) noexcept {
  RansacOptions options;
  options.subset = 300;
  options.max_iterations = 150;
  options.max_planes = 6;
  options.min_inliers = 60;
  options.seed = 3;
  change(options);
  return options;
}

constexpr RansacOptions in_metres = options_of([](RansacOptions& o) { o.gate.fixed_m = 0.02; });
constexpr RansacOptions in_pieces = options_of(
    [](RansacOptions& o) { o.gate.fixed_m = 0.02, o.near_radius = 1, o.split = true, o.piece_cell_m = 0.3; });
constexpr RansacOptions by_sensor = options_of([](RansacOptions&) {});
constexpr RansacOptions near_by_sensor =
    options_of([](RansacOptions& o) { o.near_radius = 20, o.split = true; });
static_assert(RansacPlanes::workspace_bytes(depth_pixels, near_by_sensor) + depth_pixels * sizeof(float) <=
              most_workspace);

SAME_BITS_LARGE std::array<std::uint16_t, depth_pixels> labels;
SAME_BITS_LARGE std::array<FoundPlane, 32> planes;

void add_result(Hash& hash, const RansacPlanesResult& result) noexcept {
  hash.add(result.status, result.found, std::span<const FoundPlane>(planes).first(result.found.planes));
}

void cloud_row(const Report& report, const PointsView& points, const RansacOptions& options,
               const char* name) noexcept {
  RansacPlanes ransac;
  const auto labels_here = std::span(labels).first(points.count);
  Hash hash;
  hash.add(RansacPlanes::prepare(ransac, points.count, options, workspace()));
  const RansacPlanesResult result = ransac.run(points, planes, labels_here);
  add_result(hash, result);
  hash.add(labels_here);
  report.row({"ransac.cloud.", name}, hash);

  // The same planes once more, by the two steps alone that end every search of a cloud.
  Hash nearest, refitted;
  std::uint32_t labelled = 0;
  const auto found = std::span(planes).first(result.found.planes);
  nearest.add(label_nearest(points, found, options.gate, labels_here, labelled), labelled, labels_here);
  refitted.add(refit_labelled(points, labels_here, options.gate, found), found);
  report.row({"ransac.label_nearest.", name}, nearest);
  report.row({"ransac.refit_labelled.", name}, refitted);
}

void frame_row(const Report& report, const DepthView& depth, const RansacOptions& options,
               const char* name) noexcept {
  const std::span<std::byte> memory = workspace();
  const ImageView<float> inverse(reinterpret_cast<float*>(memory.data()), depth_size);
  const ImageView<std::uint16_t> label_view(labels.data(), depth_size);
  RansacPlanes ransac;
  Hash hash;
  hash.add(inverse_depth_image(depth, inverse));
  hash.add(
      RansacPlanes::prepare(ransac, depth_pixels, options, memory.subspan(depth_pixels * sizeof(float))));
  add_result(hash, ransac.run(inverse, depth.camera, planes, label_view));
  hash.add(label_view);
  report.row({"ransac.frame.", name}, hash);
}

void stop_row(const Report& report) noexcept {
  Hash hash;
  for (std::uint32_t k = 0; k < 400; k += 7) {
    const double p = triple_probability(k, 390);
    hash.add(p, miss_probability(p, k), draws_needed(p, 0.999, 1'000'000));
  }
  report.row({"ransac.stop"}, hash);
}

}  // namespace

void ransac_cases(const Report& report, const Kernels& kernels) noexcept {
  stop_row(report);
  const auto with_kernels = [&](RansacOptions options) {
    options.kernels = kernels.ransac;
    return options;
  };
  cloud_row(report, room_cloud(), with_kernels(in_metres), "room");
  cloud_row(report, room_cloud(), with_kernels(in_pieces), "pieces");
  cloud_row(report, seen_cloud(), with_kernels(by_sensor), "seen");
  frame_row(report, depth_picture(), with_kernels(by_sensor), "anywhere");
  frame_row(report, depth_picture(), with_kernels(near_by_sensor), "near");
  frame_row(report, blank_depth(), with_kernels(by_sensor), "blank");
}

}  // namespace same_bits
