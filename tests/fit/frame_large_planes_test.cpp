// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstdint>
#include <vector>

#include "frame_testing.hpp"

using namespace frame;

namespace {

constexpr Size size{320, 240};

}  // namespace

TEST_CASE("larger cells find the walls of a room as well, with less memory") {
  const std::vector<Plane> planes = support::box_planes();
  const DepthScene scene = support::box_room(size, planes);
  const std::vector<InverseDepthPlane> truth = seen_by(scene.camera(), planes);
  std::size_t bytes = FramePlanes::workspace_bytes(size, {});
  for (const std::int32_t cell : {8, 16}) {
    INFO("cells of " << cell);
    const FramePlanesOptions options{.cell = cell};
    CHECK(FramePlanes::workspace_bytes(size, options) < bytes);
    bytes = FramePlanes::workspace_bytes(size, options);
    const DepthFrame frame = support::frame_of(scene, {}, 3);
    const FoundFrame result = find(frame, truth, options);
    CHECK(result.status == Status::ok);
    CHECK(result.planes.size() == planes.size());
    for (const Plane& plane : planes) CHECK(count_of(result.planes, plane) == 1);
    CHECK(agreement(result, frame, scene.truth()) > 0.96);
    check_counts(result, frame);
  }
}

TEST_CASE("the options for large planes leave small ones out") {
  const std::vector<Plane> planes = support::box_planes();
  const DepthScene scene = support::box_room(size, planes);
  const DepthFrame frame = support::frame_of(scene, {}, 5);
  for (const double share : {0.05, 0.2, 1.0}) {
    INFO("share " << share);
    const FramePlanesOptions options = for_large_planes(size, share);
    const FoundFrame result = find(frame, seen_by(scene.camera(), planes), options);
    check_counts(result, frame);
    CHECK(result.calls == 1);
    for (const FoundPlane& plane : result.planes) CHECK(plane.inliers >= share * size.width * size.height);
    std::size_t large = 0;
    for (std::size_t k = 1; k <= planes.size(); ++k) {
      std::uint32_t pixels = 0;
      for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
          pixels += scene.truth().at(x, y) == k && frame.raw.at(x, y) != 0 ? 1U : 0U;
        }
      }
      large += pixels > 1.1 * share * size.width * size.height ? 1U : 0U;
    }
    CHECK(result.planes.size() >= large);
  }
}

TEST_CASE("cells are 4, 8 or 16 pixels, and there are kernels") {
  for (const std::int32_t cell : {-4, 0, 1, 5, 12, 32}) {
    CHECK(FramePlanes::workspace_bytes(size, {.cell = cell}) == 0);
    FramePlanes planes;
    CHECK(planes.prepare(size, {.cell = cell}, {}) == Status::invalid_option);
  }
  CHECK(FramePlanes::workspace_bytes(size, {.kernels = nullptr}) == 0);
}
