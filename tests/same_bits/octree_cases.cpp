// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <array>

#include "cases.hpp"
#include "hash_results.hpp"
#include "inputs.hpp"
#include "memory.hpp"
#include "straightedge/octree.hpp"
#include "straightedge/random.hpp"

namespace same_bits {
namespace {

using namespace straightedge;

constexpr OctreeOptions options{.grid = {.origin = {0.3, -0.2, 0.1}, .leaf_m = 0.19}, .max_leaves = 0};
static_assert(Octree::workspace_bytes(room_points, options) <= most_workspace);

void morton_row(const Report& report) noexcept {
  Pcg32 random(71);
  Hash hash;
  for (int i = 0; i < 300; ++i) {
    const std::uint32_t x = random.below(morton_side), y = random.below(morton_side), z = random.below(64);
    const std::uint64_t code = morton_encode({x, y, z});
    const MortonCell cell = morton_decode(code * 3);
    const MortonNeighbour beside = morton_neighbour(code, i % 5, i % 3 - 1, i / 3 % 3 - 1, 1);
    hash.add(code, cell.x, cell.y, cell.z, beside.inside, beside.code, morton_common_level(code, code * 3));
  }
  report.row({"octree.morton"}, hash);
}

void grid_row(const Report& report) noexcept {
  Hash hash;
  for (const PointsView& points : {room_cloud(), seen_cloud()}) {
    const OctreeFit fit = fit_octree_grid(points, 0.07);
    hash.add(fit.status, fit.grid.origin, fit.grid.leaf_m, fit.box.min, fit.box.max, fit.points);
  }
  report.row({"octree.fit_grid"}, hash);
}

/// Nodes and the points in their order.
Hash hash_of(const Octree& octree) noexcept {
  Hash hash;
  for (std::uint32_t i = 0; i < octree.nodes().size(); ++i) {
    hash.add(octree.nodes()[i].key, octree.nodes()[i].first, octree.nodes()[i].next);
  }
  for (std::uint32_t i = 0; i < octree.size(); ++i) hash.add(octree.point(i));
  return hash;
}

void build_rows(const Report& report, Octree& octree) noexcept {
  PointsView first = room_cloud(), second = room_cloud();
  first.count = 901;
  const std::ptrdiff_t floats = 901 * first.stride / std::ptrdiff_t{sizeof(float)};
  second = {first.x + floats, first.y + floats, first.z + floats, room_points - 901, first.stride, 0};
  Hash built, inserted;
  built.add(Octree::prepare(octree, room_points, options, workspace()));
  built.add(octree.build(first));
  built.add(hash_of(octree).value());
  inserted.add(octree.insert(second));
  inserted.add(hash_of(octree).value());
  report.row({"octree.build"}, built);
  report.row({"octree.insert"}, inserted);
}

void near_rows(const Report& report, const Octree& octree) noexcept {
  Pcg32 random(72);
  Hash nearest, several, balls, boxes;
  std::array<OctreeNeighbour, 80> near;
  std::array<std::uint32_t, 80> inside{};
  const auto metres = [&] { return random.below(5000) / 1000.0 - 0.4; };
  for (int i = 0; i < 120; ++i) {
    const double x = metres(), y = metres(), z = metres();
    const Vector3 at{x, y, z};
    near.fill({});
    nearest.add(octree.nearest(at, near[0], i % 4 == 0 ? 0.2 : octree_unlimited), near[0]);
    near.fill({});
    several.add(octree.k_nearest(at, std::span(near).first(static_cast<std::size_t>(i % 13))), near);
    near.fill({});
    balls.add(octree.radius(at, 0.01 * (i % 60), near), near);
    inside.fill(0);
    boxes.add(octree.box({at, at + Vector3{0.4, 0.6, 0.3}}, inside), inside);
  }
  report.row({"octree.nearest"}, nearest);
  report.row({"octree.k_nearest"}, several);
  report.row({"octree.radius"}, balls);
  report.row({"octree.box"}, boxes);
}

void ray_rows(const Report& report, const Octree& octree) noexcept {
  Pcg32 random(73);
  Hash rays, hits;
  std::array<OctreeCrossing, 80> crossed;
  const auto part = [&] { return random.below(5000) / 1000.0 - 2.5; };
  for (int i = 0; i < 120; ++i) {
    OctreeRay ray;
    ray.origin = {0.1 * (i % 40), 0.07 * (i % 23), 1.5};
    const double x = part(), y = i % 5 == 0 ? 0 : part();
    ray.direction = {x, y, part()};
    crossed.fill({});
    rays.add(octree.ray(ray, crossed), crossed);
    ray.max_distance_m = 1.1;
    crossed.fill({});
    hits.add(octree.first_hit(ray, crossed[0]), crossed[0]);
  }
  report.row({"octree.ray"}, rays);
  report.row({"octree.first_hit"}, hits);
}

}  // namespace

void octree_cases(const Report& report) noexcept {
  morton_row(report);
  grid_row(report);
  Octree octree;
  build_rows(report, octree);
  near_rows(report, octree);
  ray_rows(report, octree);
}

}  // namespace same_bits
