// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "octree/merge_points.hpp"

#include <bit>

#include "octree/code_reader.hpp"
#include "straightedge/octree_point.hpp"

namespace straightedge::octree {
namespace {

// The memory of the nodes is made of nodes; a node has room for a point's four words.
OctreeNode lend(const OctreePoint& p) noexcept {
  return {std::bit_cast<std::uint32_t>(p.x) | std::uint64_t{std::bit_cast<std::uint32_t>(p.y)} << 32U,
          std::bit_cast<std::uint32_t>(p.z), p.index};
}
OctreePoint take_back(const OctreeNode& node) noexcept {
  return {std::bit_cast<float>(static_cast<std::uint32_t>(node.key)),
          std::bit_cast<float>(static_cast<std::uint32_t>(node.key >> 32U)), std::bit_cast<float>(node.first),
          node.next};
}

/// From the last place to the first, so that no point is written over that has not been moved. What is left
/// of the old points when the piece is used up is where it belongs.
void merge_piece(const OctreeGrid& grid, std::span<std::uint32_t> words, std::uint32_t old_count,
                 std::span<const OctreeNode> piece) noexcept {
  CodeReader old_codes(grid), new_codes(grid);
  std::size_t place = old_count + piece.size();
  for (std::size_t i = piece.size(); i > 0; --i) {
    const OctreePoint point = take_back(piece[i - 1]);
    const std::uint64_t code = new_codes.code_of(point.position());
    for (; old_count > 0; --old_count) {
      const OctreePoint old = OctreePoint::read(words, old_count - 1);
      if (old_codes.code_of(old.position()) <= code) break;
      old.write(words, --place);
    }
    point.write(words, --place);
  }
}

}  // namespace

void merge_points(const OctreeGrid& grid, std::span<std::uint32_t> words, std::uint32_t old_count,
                  std::uint32_t new_place, std::uint32_t new_count, std::span<OctreeNode> lent) noexcept {
  while (new_count > 0) {
    const auto room = static_cast<std::uint32_t>(lent.size());
    const std::uint32_t piece = new_count < room ? new_count : room;
    for (std::uint32_t i = 0; i < piece; ++i) lent[i] = lend(OctreePoint::read(words, new_place + i));
    merge_piece(grid, words, old_count, lent.first(piece));
    old_count += piece;
    new_place += piece;
    new_count -= piece;
  }
}

}  // namespace straightedge::octree
