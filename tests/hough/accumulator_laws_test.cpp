// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <set>
#include <vector>

#include "plane_scene.hpp"
#include "straightedge/hough_accumulator_directions.hpp"
#include "support/catch.hpp"

using namespace straightedge;

namespace {

struct Grid {
  Grid(HoughCells kind, std::int32_t rows) {
    Arena counted = Arena::measure();
    HoughDirections().take(counted, kind, rows);
    memory.resize(counted.used());
    Arena arena(memory);
    REQUIRE(directions.take(arena, kind, rows));
    directions.fill(kind);
  }
  std::set<std::int32_t> neighbours(std::int32_t cell) const {
    std::set<std::int32_t> found;
    directions.for_neighbours(cell, [&](std::int32_t other) { found.insert(other); });
    return found;
  }

  std::vector<std::byte> memory;
  HoughDirections directions;
};

/// Anywhere, or close to a pole, or close to the seam.
Vector3 tricky_direction(Pcg32& random) {
  const Vector3 anywhere = test::random_direction(random);
  switch (random.below(4)) {
    case 0:
      return normalized({0.1 * anywhere.x, 0.1 * anywhere.y, anywhere.z < 0 ? -1.0 : 1.0});
    case 1:
      return normalized({-1, 0.02 * anywhere.y, anywhere.z});
    default:
      return anywhere;
  }
}

/// A direction at this angle, to a random side.
Vector3 turned(const Vector3& n, double angle, Pcg32& random) {
  Vector3 side = cross(n, test::random_direction(random));
  while (squared_length(side) < 1e-6) side = cross(n, test::random_direction(random));
  const SineCosine turn = sine_cosine(angle);
  return normalized(turn.cosine * n + turn.sine * normalized(side));
}

}  // namespace

TEST_CASE("two directions within one cell size lie in one cell or in neighbours") {
  const std::uint64_t seed = 20260101;
  Pcg32 random(seed);
  for (const HoughCells kind : {HoughCells::array, HoughCells::ball}) {
    for (const int rows : {4, 5, 12, 45}) {
      const Grid grid(kind, rows);
      std::vector<std::set<std::int32_t>> neighbours;
      for (std::int32_t cell = 0; cell < grid.directions.size(); ++cell) {
        neighbours.push_back(grid.neighbours(cell));
      }
      for (int i = 0; i < 40'000; ++i) {
        const Vector3 a = tricky_direction(random);
        const double angle = grid.directions.cell_size() * (i % 2 == 0 ? 1 : test::uniform(random));
        const Vector3 b = turned(a, angle, random);
        const std::int32_t cell = grid.directions.cell(a), other = grid.directions.cell(b);
        INFO("seed " << seed << " pair " << i << " rows " << rows << " kind " << static_cast<int>(kind));
        REQUIRE(neighbours[static_cast<std::size_t>(cell)].count(other) == 1);
      }
    }
  }
}

TEST_CASE("no cell that comes within an angle is left out, none comes twice") {
  const std::uint64_t seed = 20260102;
  Pcg32 random(seed);
  for (const HoughCells kind : {HoughCells::array, HoughCells::ball}) {
    const Grid grid(kind, 24);
    for (int i = 0; i < 2'000; ++i) {
      const Vector3 n = i == 0 ? Vector3{0, 0, 1} : tricky_direction(random);
      const double angle = 0.01 + 1.4 * test::uniform(random) * test::uniform(random);
      std::set<std::int32_t> near;
      INFO("seed " << seed << " direction " << i);
      grid.directions.for_near(n, angle, [&](std::int32_t cell) { REQUIRE(near.insert(cell).second); });
      for (int k = 0; k < 30; ++k) {
        const Vector3 inside = turned(n, angle * 0.999999 * test::uniform(random), random);
        REQUIRE(near.count(grid.directions.cell(inside)) == 1);
      }
    }
  }
}
