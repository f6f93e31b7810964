// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <array>
#include <vector>

#include "clouds.hpp"

using namespace straightedge;

namespace {

/// Two leaves in one node of level 1, one more below the same node of level 2, one far away.
const std::vector<std::uint64_t> few_codes = {8, 8, 9, 17, std::uint64_t{1} << 40U};

OctreeNodes build(const std::vector<std::uint64_t>& codes, std::vector<OctreeNode>& memory) {
  memory.assign(OctreeNodes::nodes_for(codes.size()), OctreeNode{});
  OctreeNodes nodes;
  REQUIRE(OctreeNodes::build(nodes, codes, memory) == Status::ok);
  return nodes;
}

}  // namespace

TEST_CASE("a small tree, node by node") {
  std::vector<OctreeNode> memory;
  const OctreeNodes nodes = build(few_codes, memory);
  REQUIRE(nodes.size() == 7);
  CHECK(nodes.leaves() == 4);
  CHECK(nodes.points() == 5);
  struct Expected {
    int level;
    std::uint64_t code;
    std::uint32_t first, count, next;
  };
  // Root of the two parts, node of level 2, node of level 1, its leaves, third leaf, far leaf.
  const Expected expected[] = {{14, 0, 0, 5, 7}, {2, 0, 0, 4, 6},  {1, 8, 0, 3, 5},           {0, 8, 0, 2, 4},
                               {0, 9, 2, 1, 5},  {0, 17, 3, 1, 6}, {0, few_codes[4], 4, 1, 7}};
  for (std::uint32_t i = 0; i < 7; ++i) {
    INFO("node " << i);
    CHECK(nodes[i].level() == expected[i].level);
    CHECK(nodes[i].code() == expected[i].code);
    CHECK(nodes[i].first == expected[i].first);
    CHECK(nodes.count_of(i) == expected[i].count);
    CHECK(nodes[i].next == expected[i].next);
    CHECK(nodes.is_leaf(i) == (expected[i].level == 0));
  }
}

TEST_CASE("leaves are found by their codes, others are not") {
  std::vector<OctreeNode> memory;
  const OctreeNodes nodes = build(few_codes, memory);
  CHECK(nodes.find(8) == 3);
  CHECK(nodes.find(9) == 4);
  CHECK(nodes.find(17) == 5);
  CHECK(nodes.find(few_codes[4]) == 6);
  for (const std::uint64_t code : {std::uint64_t{0}, std::uint64_t{7}, std::uint64_t{16}, morton_codes - 1})
    CHECK(nodes.find(code) == nodes.size());
}

TEST_CASE("nodes that are left out are seen like others") {
  std::vector<OctreeNode> memory;
  const OctreeNodes nodes = build(few_codes, memory);
  const OctreeCell middle = nodes.cell(9, 5);  // only the node of level 2 is below it
  CHECK(middle.code == 0);
  CHECK(middle.first == 0);
  CHECK(middle.count == 4);
  CHECK(nodes.cell(few_codes[4] + 5, 3).count == 1);
  CHECK(nodes.cell(64, 2).count == 0);
  CHECK(nodes.cell(0, morton_levels).count == 5);
}

TEST_CASE("no codes, one code, the first and the last code") {
  std::vector<OctreeNode> memory;
  const OctreeNodes none = build({}, memory);
  CHECK(none.size() == 0);
  CHECK(none.points() == 0);
  CHECK(none.find(0) == 0);
  CHECK(none.cell(0, morton_levels).count == 0);
  for (const OctreeCell& cell : none.level(3)) CHECK(cell.count == 0);
  const OctreeNodes one = build({77}, memory);
  CHECK(one.size() == 1);
  CHECK(one.is_leaf(0));
  CHECK(one.cell(0, morton_levels).count == 1);
  const OctreeNodes ends = build({0, morton_codes - 1}, memory);
  CHECK(ends.size() == 3);
  CHECK(ends[0].level() == morton_levels);
  CHECK(ends[0].code() == 0);
  CHECK(ends.find(morton_codes - 1) == 2);
}

TEST_CASE("codes out of order, too large, too many leaves") {
  std::vector<OctreeNode> memory(8);
  OctreeNodes nodes;
  REQUIRE(OctreeNodes::build(nodes, few_codes, memory) == Status::ok);
  const std::array<std::uint64_t, 2> falling = {5, 4}, large = {5, morton_codes};
  const std::array<std::uint64_t, 5> five = {1, 2, 3, 4, 5};
  CHECK(OctreeNodes::build(nodes, falling, memory) == Status::invalid_image);
  CHECK(OctreeNodes::build(nodes, large, memory) == Status::invalid_image);
  CHECK(OctreeNodes::build(nodes, five, memory) == Status::workspace_too_small);
  CHECK(OctreeNodes::build(nodes, {}, {}) == Status::workspace_too_small);
  CHECK(nodes.size() == 7);
  CHECK(nodes.find(17) == 5);
}

TEST_CASE("neighbours by face, edge and corner, also at the border of the grid") {
  // The eight cells in the grid's first corner.
  std::vector<std::uint64_t> codes;
  for (std::uint64_t code = 0; code < 8; ++code) codes.push_back(code);
  std::vector<OctreeNode> memory;
  const OctreeNodes nodes = build(codes, memory);
  std::array<std::uint32_t, 26> out{};
  CHECK(nodes.neighbours(0, OctreeAdjacency::faces, out) == 3);
  CHECK(nodes[out[0]].code() == 1);
  CHECK(nodes[out[1]].code() == 2);
  CHECK(nodes[out[2]].code() == 4);
  CHECK(nodes.neighbours(0, OctreeAdjacency::edges, out) == 6);
  CHECK(nodes.neighbours(0, OctreeAdjacency::corners, out) == 7);
  CHECK(nodes.neighbours(0, OctreeAdjacency::corners, std::span(out).first(2)) == 7);
  CHECK(nodes.neighbours(morton_encode({2, 0, 0}), OctreeAdjacency::faces, out) == 1);
  CHECK(nodes[out[0]].code() == 1);
}
