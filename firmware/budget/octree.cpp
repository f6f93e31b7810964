// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// An octree over one pixel in sixteen of a depth frame.
#include "straightedge/octree.hpp"
#include "budget/case.hpp"
#include "scenes/room.hpp"

namespace {

using namespace straightedge;

struct Point {
  float x = 0, y = 0, z = 0;
};

constexpr OctreeOptions options{.grid = {.origin = {}, .leaf_m = 0.05}, .max_leaves = 0};
constexpr std::size_t nth_point = 8;  // is asked for its nearest neighbour
constexpr std::uint32_t most_points = firmware::most_pixels / 16;
[[gnu::section(".big.depth")]] std::array<std::uint16_t, firmware::most_pixels> depth;
[[gnu::section(".big.points")]] std::array<Point, most_points> cloud;
[[gnu::section(".big.workspace")]] alignas(
    64) std::array<std::byte, Octree::workspace_bytes(most_points, options)> workspace;

PointsView take_points(Size size) noexcept {
  const ImageView<std::uint16_t> frame(depth.data(), size);
  firmware::draw_room(frame);
  const PinholeCamera camera = firmware::kinect(size);
  std::size_t count = 0;
  for (std::int32_t y = 0; y < size.height; y += 4) {
    for (std::int32_t x = 0; x < size.width; x += 4) {
      const Vector3 p = (frame.at(x, y) / 1000.0) * camera.ray(x, y);
      cloud[count++] = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
    }
  }
  return {&cloud[0].x, &cloud[0].y, &cloud[0].z, count, sizeof(Point)};
}

bool measure(Size size) noexcept {
  const auto capacity = static_cast<std::uint32_t>(firmware::pixels_of(size) / 16);
  const std::size_t bytes = Octree::workspace_bytes(capacity, options);
  const PointsView points = take_points(size);
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
