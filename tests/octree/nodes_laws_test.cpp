// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <set>

#include "clouds.hpp"

using namespace straightedge;

namespace {

/// Sorted codes: near one another, far apart, or both; some more than once.
std::vector<std::uint64_t> random_codes(Pcg32& random) {
  std::vector<std::uint64_t> codes(1 + random.below(300));
  const unsigned bits = 3 + random.below(61);
  for (std::uint64_t& code : codes) {
    code = ((std::uint64_t{random.next()} << 32U | random.next()) >> (64 - bits)) & (morton_codes - 1);
    if (random.below(4) == 0) code &= 0xff;
  }
  std::sort(codes.begin(), codes.end());
  return codes;
}

/// Points of every node at a level, by code.
std::map<std::uint64_t, std::uint32_t> counts_at(const std::vector<std::uint64_t>& codes, int level) {
  std::map<std::uint64_t, std::uint32_t> counts;
  for (const std::uint64_t code : codes) ++counts[morton_ancestor(code, level)];
  return counts;
}

struct Built {
  explicit Built(const std::vector<std::uint64_t>& codes) : memory(OctreeNodes::nodes_for(codes.size())) {
    REQUIRE(OctreeNodes::build(nodes, codes, memory) == Status::ok);
  }
  std::vector<OctreeNode> memory;
  OctreeNodes nodes;
};

}  // namespace

TEST_CASE("every level has the nodes and counts of a plain count") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Pcg32 random(seed);
    const std::vector<std::uint64_t> codes = random_codes(random);
    const Built built(codes);
    INFO("seed " << seed);
    for (int level = 0; level <= morton_levels; ++level) {
      const auto expected = counts_at(codes, level);
      std::map<std::uint64_t, std::uint32_t> found;
      std::uint32_t first = 0;
      std::uint64_t last = 0;
      for (const OctreeCell& cell : built.nodes.level(level)) {
        REQUIRE(cell.level == level);
        REQUIRE(cell.first == first);
        REQUIRE((found.empty() || cell.code > last));
        last = cell.code;
        first += cell.count;
        found[cell.code] = cell.count;
      }
      REQUIRE(found == expected);
      for (int i = 0; i < 20; ++i) {
        const std::uint64_t code = i < 10 ? codes[random.below(static_cast<std::uint32_t>(codes.size()))]
                                          : std::uint64_t{random.next()} << random.below(32);
        const auto there = expected.find(morton_ancestor(code, level));
        REQUIRE(built.nodes.cell(code, level).count == (there == expected.end() ? 0 : there->second));
      }
    }
  }
}

TEST_CASE("inner nodes have two children or more, which lie in them, in order, and fill them") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Pcg32 random(seed);
    const std::vector<std::uint64_t> codes = random_codes(random);
    const Built built(codes);
    const OctreeNodes& nodes = built.nodes;
    INFO("seed " << seed);
    const std::set<std::uint64_t> leaves(codes.begin(), codes.end());
    REQUIRE(nodes.leaves() == leaves.size());
    REQUIRE(nodes.size() < 2 * leaves.size());
    REQUIRE(nodes[0].next == nodes.size());
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
      if (nodes.is_leaf(i)) {
        REQUIRE(leaves.contains(nodes[i].code()));
        REQUIRE(nodes.find(nodes[i].code()) == i);
        continue;
      }
      int children = 0;
      std::uint32_t points = 0, child = i + 1;
      for (; child < nodes[i].next; child = nodes[child].next) {
        REQUIRE(nodes[child].level() < nodes[i].level());
        REQUIRE(morton_ancestor(nodes[child].code(), nodes[i].level()) == nodes[i].code());
        points += nodes.count_of(child);
        ++children;
      }
      REQUIRE(child == nodes[i].next);
      REQUIRE(children >= 2);
      REQUIRE(children <= 8);
      REQUIRE(points == nodes.count_of(i));
    }
  }
}

TEST_CASE("neighbours are the leaves whose cells are next to it") {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Pcg32 random(seed);
    std::vector<std::uint64_t> codes;
    const std::uint32_t base = seed % 2 == 0 ? 0 : morton_side - 6;  // both ends of the grid
    for (int i = 0; i < 80; ++i)
      codes.push_back(
          morton_encode({base + random.below(6), base + random.below(6), base + random.below(6)}));
    std::sort(codes.begin(), codes.end());
    const Built built(codes);
    const auto apart = [](std::uint32_t a, std::uint32_t b) { return a < b ? b - a : a - b; };
    for (const auto adjacency : {OctreeAdjacency::faces, OctreeAdjacency::edges, OctreeAdjacency::corners}) {
      const std::uint64_t code =
          morton_encode({base + random.below(6), base + random.below(6), base + random.below(6)});
      const MortonCell centre = morton_decode(code);
      std::set<std::uint64_t> expected, found;
      for (const std::uint64_t other : codes) {
        const MortonCell cell = morton_decode(other);
        const std::uint32_t dx = apart(cell.x, centre.x), dy = apart(cell.y, centre.y),
                            dz = apart(cell.z, centre.z);
        const bool touches = dx <= 1 && dy <= 1 && dz <= 1 && other != code;
        if (touches && dx + dy + dz <= static_cast<std::uint32_t>(adjacency)) expected.insert(other);
      }
      std::uint32_t out[26];
      const std::size_t count = built.nodes.neighbours(code, adjacency, out);
      for (std::size_t i = 0; i < count; ++i) found.insert(built.nodes[out[i]].code());
      INFO("seed " << seed);
      REQUIRE(count == found.size());
      REQUIRE(found == expected);
    }
  }
}
