// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/plane_patches.hpp"

#include <algorithm>

#include "map/plane_key.hpp"

namespace straightedge {
namespace {

constexpr int block_level = 3;

// A patch is estimated anew when it has become so much heavier, and at last.
constexpr double anew = 1.25;

std::uint64_t block_of(const PlaneLeaf& leaf) {
  return leaf.key.leaf >> (3 * block_level);
}

struct LeafWeight {
  std::int64_t weight;
  std::uint32_t leaf;

  /// The heavier first, equals in the order of leaves.
  bool operator<(const LeafWeight& o) const { return weight != o.weight ? weight > o.weight : leaf < o.leaf; }
};

void patches_of_block(std::span<const PlaneLeaf> leaves, std::uint32_t first, std::uint32_t end,
                      const PlaneMapOptions& options, std::vector<LeafWeight>& heaviest_first,
                      std::vector<PlanePatch>& patches) {
  const std::size_t before = patches.size();
  const Vector3 origin = cube_centre(leaves[first].key.leaf, block_level);
  heaviest_first.clear();
  std::vector<double> estimated_weights;
  for (std::uint32_t i = first; i < end; ++i) heaviest_first.push_back({leaves[i].sums.weight, i});
  std::sort(heaviest_first.begin(), heaviest_first.end());
  for (const LeafWeight& next : heaviest_first) {
    const std::uint32_t i = next.leaf;
    const Surface piece = surface_of(leaves[i], origin);
    const SurfaceEstimate where = estimate(piece, options);
    PlanePatch* best = nullptr;
    double least = 0;
    for (std::size_t p = before; p < patches.size(); ++p) {
      // A patch is seen from one side: what is seen from behind may be the back of a thin wall.
      if (dot(patches[p].estimate.normal, where.normal) < 0) continue;
      const Agreement a = agree(patches[p].estimate, where, options);
      if (!a.possible || (best != nullptr && a.miss >= least)) continue;
      best = &patches[p];
      least = a.miss;
    }
    if (best == nullptr) {
      patches.push_back({piece, where, {i}});
      estimated_weights.push_back(piece.moments.weight);
      continue;
    }
    best->surface.add(piece);
    best->leaves.push_back(i);
    const auto which = static_cast<std::size_t>(best - (patches.data() + before));
    if (best->surface.moments.weight < anew * estimated_weights[which]) continue;
    best->estimate = estimate(best->surface, options);
    estimated_weights[which] = best->surface.moments.weight;
  }
  for (std::size_t p = before; p < patches.size(); ++p) {
    if (patches[p].leaves.size() > 1) patches[p].estimate = estimate(patches[p].surface, options);
  }
}

}  // namespace

std::vector<PlanePatch> make_patches(std::span<const PlaneLeaf> leaves, const PlaneMapOptions& options) {
  std::vector<PlanePatch> patches;
  std::vector<LeafWeight> order;
  std::size_t first = 0;
  while (first < leaves.size()) {
    std::size_t end = first + 1;
    while (end < leaves.size() && block_of(leaves[end]) == block_of(leaves[first])) ++end;
    patches_of_block(leaves, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(end), options,
                     order, patches);
    first = end;
  }
  std::stable_sort(patches.begin(), patches.end(), [](const PlanePatch& a, const PlanePatch& b) {
    return a.surface.moments.weight > b.surface.moments.weight;
  });
  return patches;
}

}  // namespace straightedge
