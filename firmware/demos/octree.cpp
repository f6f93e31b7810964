// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// An octree on a microcontroller: points come in two lots, then the nearest of them are asked for and
// compared with a search through all. Exit code 0: they agree.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "kit/semihosting.hpp"
#include "straightedge/octree.hpp"
#include "straightedge/random.hpp"

namespace {

using straightedge::Octree;
using straightedge::OctreeNeighbour;
using straightedge::OctreeOptions;
using straightedge::Pcg32;
using straightedge::PointsView;
using straightedge::Status;
using straightedge::Vector3;

struct Point {
  float x = 0, y = 0, z = 0;
};

constexpr std::uint32_t points = 1000;
constexpr OctreeOptions options{.grid = {.origin = {}, .leaf_m = 0.25}, .max_leaves = 0};

// The size is a constant expression: memory that a board does not have is a link error.
alignas(64) std::array<std::byte, Octree::workspace_bytes(points, options)> workspace;
std::array<Point, points> cloud;

PointsView view(std::span<const Point> part) noexcept {
  return {&part[0].x, &part[0].y, &part[0].z, part.size(), sizeof(Point)};
}

float metres(Pcg32& random) noexcept {
  return static_cast<float>(random.below(4096)) / 1024;
}

OctreeNeighbour nearest_of_all(const Vector3& position) noexcept {
  OctreeNeighbour best{0, straightedge::octree_unlimited};
  const PointsView all = view(cloud);
  for (std::uint32_t i = 0; i < points; ++i) {
    const Vector3 apart = all.at(i) - position;
    const OctreeNeighbour here{i, dot(apart, apart)};
    if (here.before(best)) best = here;
  }
  return best;
}

}  // namespace

int main() {
  Pcg32 random(1);
  for (Point& point : cloud) {
    const float x = metres(random), y = metres(random), z = metres(random);
    point = {x, y, z};
  }
  Octree octree;
  if (Octree::prepare(octree, points, options, workspace) != Status::ok) return 1;
  const std::span<const Point> all(cloud);
  if (octree.build(view(all.first(points / 2))).status != Status::ok) return 2;
  const auto grown = octree.insert(view(all.subspan(points / 2)));
  if (grown.status != Status::ok || octree.size() != points) return 3;

  std::uint32_t different = 0;
  for (int query = 0; query < 200; ++query) {
    const double x = static_cast<double>(metres(random)), y = static_cast<double>(metres(random));
    const Vector3 position{x, y, static_cast<double>(metres(random))};
    OctreeNeighbour found;
    if (octree.nearest(position, found).found != 1 || !(found == nearest_of_all(position))) ++different;
  }
  firmware::write(octree.size());
  firmware::write(" points in ");
  firmware::write(grown.leaves);
  firmware::write(" leaves; nearest points that differ from a search through all: ");
  firmware::write(different);
  firmware::write("; stack ");
  firmware::write(firmware::stack_used());
  firmware::write(" bytes\n");
  return different == 0 ? 0 : 4;
}
