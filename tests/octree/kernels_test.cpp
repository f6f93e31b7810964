// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <string>

#include "clouds.hpp"
#include "straightedge/host/kernels.hpp"

using namespace straightedge;

namespace {

constexpr OctreeAxis axis{0.3, 20, octree_origin_cell, morton_side};

/// Coordinates in a room, at the borders of the cube, and some that are nowhere.
float coordinate(Pcg32& random) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  constexpr float odd[] = {-34952.2F, -34952.25F, 69905.4F,
                           69905.39F, 1e30F,      -1e30F,
                           infinity,  -infinity,  std::numeric_limits<float>::quiet_NaN(),
                           0.3F};
  return random.below(10) == 0 ? odd[random.below(10)] : 8 * test::unit(random);
}

/// Cells of points that mostly stay where the one before was; some are outside the cube.
void next_batch(Pcg32& random, OctreeCellBatch& cells) {
  constexpr auto size = OctreeCellBatch::size;
  const auto next = [&](std::int32_t(&to)[size + 1]) {
    to[0] = to[size];
    for (std::size_t i = 1; i <= size; ++i) {
      const std::uint32_t chance = random.below(40);
      to[i] = chance == 0   ? -1
              : chance == 1 ? static_cast<std::int32_t>(random.below(morton_side))
              : chance < 8 ? static_cast<std::int32_t>(octree_origin_cell) + static_cast<std::int32_t>(chance)
                           : to[i - 1];
    }
  };
  next(cells.x);
  next(cells.y);
  next(cells.z);
}

MortonCell cell_at(const OctreeCellBatch& cells, std::size_t i) {
  return {static_cast<std::uint32_t>(cells.x[i + 1]), static_cast<std::uint32_t>(cells.y[i + 1]),
          static_cast<std::uint32_t>(cells.z[i + 1])};
}

/// What starts say, found point by point.
void require_starts(const OctreeCellBatch& cells, std::size_t points, const OctreeRunStarts& found,
                    std::uint64_t& differs, std::uint32_t& cell_differs) {
  constexpr std::uint32_t part_bits = (1U << 27U) - 1;
  const MortonCell first = found.first;
  std::size_t k = 0;
  for (std::size_t i = 0; i < points; ++i) {
    const MortonCell cell = cell_at(cells, i);
    if (cell == cell_at(cells, i - 1)) continue;
    CAPTURE(i, k);
    REQUIRE(k < found.count);
    const bool outside = cells.x[i + 1] < 0 || cells.y[i + 1] < 0 || cells.z[i + 1] < 0;
    REQUIRE(found.at[k] == i);
    REQUIRE(found.outside[k] == (outside ? 1U : 0U));
    if (!outside) {
      REQUIRE(found.part[k] == (morton_encode(cell) & part_bits));
      differs |= morton_encode(cell) ^ morton_encode(first);
      cell_differs |= (cell.x ^ first.x) | (cell.y ^ first.y) | (cell.z ^ first.z);
    }
    ++k;
  }
  REQUIRE(k == found.count);
  REQUIRE(found.part_differs == (differs & part_bits));
  REQUIRE(found.cell_differs == cell_differs);
}

}  // namespace

TEST_CASE("every set of kernels finds the runs that are found point by point") {
  for (const KernelSet& set : kernel_sets()) {
    for (std::size_t last = 1; last <= OctreeCellBatch::size; ++last) {
      CAPTURE(std::string(set.name), last);
      Pcg32 random(last);
      OctreeCellBatch cells;
      OctreeRunStarts starts;
      starts.first = {random.below(morton_side), random.below(morton_side), random.below(morton_side)};
      std::uint64_t differs = 0;
      std::uint32_t cell_differs = 0;
      for (const std::size_t points : {OctreeCellBatch::size, OctreeCellBatch::size, last}) {
        next_batch(random, cells);
        set.octree->starts(cells, points, starts);
        require_starts(cells, points, starts, differs, cell_differs);
      }
    }
  }
}

TEST_CASE("every set of kernels finds the points that the plain one finds near, and the nearest is of them") {
  Pcg32 random(5);
  std::vector<std::uint32_t> blocks(octree_point_words * 64);
  for (int round = 0; round < 2000; ++round) {
    const std::uint32_t count = 1 + random.below(OctreeNearTask::most_blocks);
    // Some in a small place, so that many are as near as others; some lanes hold no point.
    const float wide = random.below(2) == 0 ? 1.0F : 1e-4F;
    std::vector<OctreePoint> points(4 * std::size_t{count});
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      const float nowhere = std::numeric_limits<float>::infinity();
      points[i] = {wide * test::unit(random), wide * test::unit(random), wide * test::unit(random), i};
      if (i > 0 && random.below(20) == 0) points[i] = {nowhere, nowhere, nowhere, UINT32_MAX};
      points[i].write(blocks, i);
    }
    const double slack = 1 + 0x1p-10, loss = 1e-14;
    const float limit = random.below(3) == 0 ? 0.05F : std::numeric_limits<float>::infinity();
    const OctreeNearTask task{
        blocks.data(), count, test::unit(random), test::unit(random), test::unit(random), limit, slack, loss};
    const std::uint64_t near = plain_octree_kernels.near(task);
    for (const KernelSet& set : kernel_sets()) {
      CAPTURE(std::string(set.name), round, count);
      REQUIRE(set.octree->near(task) == near);
    }
    const auto squared = [&task](const OctreePoint& p) {
      const float x = p.x - task.x, y = p.y - task.y, z = p.z - task.z;
      return x * x + y * y + z * z;
    };
    float least = squared(points[0]);
    for (const OctreePoint& p : points) least = std::min(least, squared(p));
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double here = static_cast<double>(squared(points[i]));
      const bool asked = here <= static_cast<double>(limit) && least <= limit;
      CAPTURE(round, i, here, least);
      if (asked && here <= static_cast<double>(least) * slack) REQUIRE((near >> i & 1U) == 1);
      if (!asked || here > static_cast<double>(least) * (slack + 1e-6) + 2 * loss)
        REQUIRE((near >> i & 1U) == 0);
    }
  }
}

TEST_CASE("every set of kernels finds the cells that the plain one finds") {
  for (const KernelSet& set : kernel_sets()) {
    for (std::size_t count = 0; count <= 200; ++count) {
      CAPTURE(std::string(set.name), count);
      Pcg32 random(count);
      std::vector<float> coordinates(count);
      for (float& c : coordinates) c = coordinate(random);
      std::vector<std::int32_t> cells(count + 1, 7), expected(count + 1, 7);
      set.octree->cells(coordinates.data(), count, axis, cells.data());
      plain_octree_kernels.cells(coordinates.data(), count, axis, expected.data());
      REQUIRE(cells == expected);
    }
  }
}

TEST_CASE("kernels find the cells that a grid finds") {
  const OctreeGrid grid{.origin = {0.3, 0.3, 0.3}, .leaf_m = 0.05};
  Pcg32 random(1);
  for (int i = 0; i < 20'000; ++i) {
    const float c = coordinate(random);
    std::int32_t found = 0;
    plain_octree_kernels.cells(&c, 1, {0.3, 1 / grid.leaf_m, octree_origin_cell, morton_side}, &found);
    MortonCell cell;
    const bool inside = grid.cell_of({static_cast<double>(c), 0, 0}, cell);
    CAPTURE(i, c);
    REQUIRE(found == (inside ? static_cast<std::int32_t>(cell.x) : -1));
  }
}

TEST_CASE("an octree is the same with every set of kernels") {
  Pcg32 random(2);
  test::Points points;
  for (int i = 0; i < 5000; ++i)
    points.push_back({coordinate(random), test::unit(random), test::unit(random)});
  test::Tree plain(points.size());
  const OctreeBuildResult expected = plain.octree.build(test::view(points));
  REQUIRE(expected.status == Status::ok);
  for (const KernelSet& set : kernel_sets()) {
    CAPTURE(std::string(set.name));
    test::Tree tree(points.size(), {.grid = {.leaf_m = 0.125}, .kernels = set.octree});
    const OctreeBuildResult result = tree.octree.build(test::view(points));
    CHECK(result.points == expected.points);
    CHECK(result.leaves == expected.leaves);
    REQUIRE(tree.octree.size() == plain.octree.size());
    for (std::uint32_t i = 0; i < plain.octree.size(); ++i)
      REQUIRE(tree.octree.point(i) == plain.octree.point(i));
    for (int i = 0; i < 300; ++i) {
      const Vector3 at{8 * static_cast<double>(test::unit(random)), static_cast<double>(test::unit(random)),
                       static_cast<double>(test::unit(random))};
      OctreeNeighbour nearest, wanted;
      REQUIRE(tree.octree.nearest(at, nearest).found == plain.octree.nearest(at, wanted).found);
      REQUIRE(nearest == wanted);
    }
  }
}
