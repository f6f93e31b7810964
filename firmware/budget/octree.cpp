// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// An octree over one pixel in sixteen of a depth frame.
#include "straightedge/octree.hpp"
#include "budget/cloud_input.hpp"

namespace {

using namespace straightedge;

constexpr OctreeOptions options{.grid = {.origin = {}, .leaf_m = 0.05}, .max_leaves = 0};
constexpr std::size_t nth_point = 8;  // is asked for its nearest neighbour
[[gnu::section(".big.workspace")]] alignas(
    64) std::array<std::byte, Octree::workspace_bytes(firmware::most_points, options)> workspace;

bool measure(Size size) noexcept {
  const auto capacity = firmware::points_of(size);
  const std::size_t bytes = Octree::workspace_bytes(capacity, options);
  const PointsView points = firmware::room_points(size);
  Octree octree;
  if (Octree::prepare(octree, capacity, options, std::span(workspace).first(bytes)) != Status::ok)
    return false;
  if (!firmware::count("Octree/build", size, bytes,
                       [&] { return octree.build(points).status == Status::ok; })) {
    return false;
  }
  return firmware::count("Octree/nearest", size, bytes, [&] {
    bool good = true;
    OctreeNeighbour found;
    for (std::size_t i = 0; i < points.count; i += nth_point) {
      good &= octree.nearest(points.at(i) + Vector3{0.01, 0.02, 0.03}, found).found == 1;
    }
    return good;
  });
}

}  // namespace

int main() {
  for (const Size size : firmware::budget_sizes) {
    if (!measure(size)) return 1;
  }
}
