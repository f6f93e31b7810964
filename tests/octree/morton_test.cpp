// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/morton.hpp"
#include "straightedge/random.hpp"
#include "support/catch.hpp"

using namespace straightedge;

namespace {

/// Bit by bit, as step 2 says.
std::uint64_t slow_code(const MortonCell& cell) {
  std::uint64_t code = 0;
  for (unsigned bit = 0; bit < 21; ++bit) {
    code |= std::uint64_t{cell.x >> bit & 1U} << (3 * bit);
    code |= std::uint64_t{cell.y >> bit & 1U} << (3 * bit + 1);
    code |= std::uint64_t{cell.z >> bit & 1U} << (3 * bit + 2);
  }
  return code;
}

MortonCell random_cell(Pcg32& random) {
  return {random.below(morton_side), random.below(morton_side), random.below(morton_side)};
}

static_assert(morton_encode({1, 0, 0}) == 1);
static_assert(morton_encode({0, 1, 0}) == 2);
static_assert(morton_encode({0, 0, 1}) == 4);
static_assert(morton_encode({morton_side - 1, morton_side - 1, morton_side - 1}) == morton_codes - 1);

}  // namespace

TEST_CASE("codes interleave bits, and are undone") {
  Pcg32 random(1);
  for (int i = 0; i < 2000; ++i) {
    const MortonCell cell = random_cell(random);
    INFO(cell.x << ' ' << cell.y << ' ' << cell.z);
    REQUIRE(morton_encode(cell) == slow_code(cell));
    REQUIRE(morton_decode(morton_encode(cell)) == cell);
  }
}

TEST_CASE("the common level is the lowest at which ancestors are equal") {
  Pcg32 random(2);
  for (int i = 0; i < 2000; ++i) {
    const std::uint64_t a = morton_encode(random_cell(random));
    const std::uint64_t b = a ^ (std::uint64_t{random.next()} >> random.below(33) << random.below(31));
    int level = 0;
    while (morton_ancestor(a, level) != morton_ancestor(b, level)) ++level;
    INFO(a << ' ' << b);
    REQUIRE(morton_common_level(a, b) == level);
  }
  CHECK(morton_common_level(0, morton_codes - 1) == morton_levels);
}

TEST_CASE("a neighbour is the code of the neighbouring cell, at every level") {
  Pcg32 random(3);
  for (int i = 0; i < 5000; ++i) {
    const int level = static_cast<int>(random.below(21));
    const std::uint32_t last = (morton_side >> static_cast<unsigned>(level)) - 1;
    // A third of the cells lie on a border of the grid.
    const auto draw = [&] {
      return random.below(6) == 0 ? 0 : random.below(5) == 0 ? last : random.below(last + 1);
    };
    const auto draw_step = [&] { return static_cast<int>(random.below(3)) - 1; };
    const std::uint32_t at[] = {draw(), draw(), draw()};
    const int step[] = {draw_step(), draw_step(), draw_step()};
    bool inside = true;
    std::uint32_t to[3];
    for (int axis = 0; axis < 3; ++axis) {
      const std::int64_t moved = std::int64_t{at[axis]} + step[axis];
      inside = inside && moved >= 0 && moved <= last;
      to[axis] = static_cast<std::uint32_t>(moved) << static_cast<unsigned>(level);
    }
    const auto shift = static_cast<unsigned>(level);
    const std::uint64_t code = morton_encode({at[0] << shift, at[1] << shift, at[2] << shift});
    const std::uint64_t within = code | (level > 0 ? random.below(8) : 0);
    const MortonNeighbour found = morton_neighbour(within, level, step[0], step[1], step[2]);
    INFO("level " << level << " cell " << at[0] << ' ' << at[1] << ' ' << at[2] << " step " << step[0] << ' '
                  << step[1] << ' ' << step[2]);
    REQUIRE(found.inside == inside);
    if (inside) REQUIRE(found.code == morton_encode({to[0], to[1], to[2]}));
  }
}
