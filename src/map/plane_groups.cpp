// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/plane_groups.hpp"

#include <algorithm>

#include "map/plane_copies.hpp"

namespace straightedge {
namespace {

constexpr std::uint32_t nobody = 0xFFFFFFFF;
constexpr int most_rounds = 4;
constexpr double first_reach = 1.5;   // metres
constexpr double last_reach = 200e3;  // beyond the grid

using Owners = std::vector<std::uint32_t>;

void take(PlaneGroup& group, std::span<const PlanePatch> patches, std::uint32_t patch) {
  if (group.patches.empty()) {
    group.surface = patches[patch].surface;
  } else {
    group.surface.add(patches[patch].surface);
  }
  group.patches.push_back(patch);
}

/// (a)
PlaneGroup grow(std::span<const PlanePatch> patches, std::uint32_t seed, std::uint32_t name, Owners& owners,
                const PlaneMapOptions& options) {
  PlaneGroup group;
  take(group, patches, seed);
  owners[seed] = name;
  group.estimate = patches[seed].estimate;
  double reach = first_reach;
  while (reach < last_reach) {
    bool grown = false, beyond = false;
    for (std::uint32_t i = seed + 1; i < patches.size(); ++i) {
      if (owners[i] != nobody) continue;
      const Agreement a = agree(group.estimate, patches[i].estimate, options);
      if (!a.possible) continue;
      if (squared_length(patches[i].estimate.centroid - group.estimate.centroid) > reach * reach) {
        beyond = true;
        continue;
      }
      take(group, patches, i);
      owners[i] = name;
      grown = true;
    }
    if (grown) {
      group.estimate = estimate(group.surface, options);
    } else if (!beyond) {
      break;
    }
    reach *= 1.5;
  }
  return group;
}

/// Sums in the order of the patches, whatever way they came.
void sum_anew(PlaneGroup& group, std::span<const PlanePatch> patches, const PlaneMapOptions& options) {
  std::vector<std::uint32_t> members;
  members.swap(group.patches);
  std::sort(members.begin(), members.end());
  for (const std::uint32_t i : members) take(group, patches, i);
  if (!group.patches.empty()) group.estimate = estimate(group.surface, options);
}

/// (b)
bool join_wholes(std::vector<PlaneGroup>& groups, std::span<const PlanePatch> patches,
                 const PlaneMapOptions& options) {
  bool joined = false;
  heaviest_first(groups);
  for (std::size_t i = 0; i < groups.size(); ++i) {
    for (std::size_t j = i + 1; j < groups.size(); ++j) {
      if (groups[i].patches.empty() || groups[j].patches.empty()) continue;
      if (!agree(groups[i].estimate, groups[j].estimate, options).possible) continue;
      absorb(groups[i], groups[j], patches, options);
      joined = true;
    }
  }
  heaviest_first(groups);
  return joined;
}

/// (c)
bool reassign(std::vector<PlaneGroup>& groups, std::span<const PlanePatch> patches,
              const PlaneMapOptions& options) {
  Owners owners(patches.size(), nobody);
  for (std::uint32_t g = 0; g < groups.size(); ++g) {
    for (const std::uint32_t i : groups[g].patches) owners[i] = g;
    groups[g].patches.clear();
  }
  bool changed = false;
  for (std::uint32_t i = 0; i < patches.size(); ++i) {
    std::uint32_t best = nobody;
    double least = 0;
    for (std::uint32_t g = 0; g < groups.size(); ++g) {
      const Agreement a = agree(groups[g].estimate, patches[i].estimate, options);
      if (!a.possible || (best != nobody && a.miss >= least)) continue;
      best = g;
      least = a.miss;
    }
    if (best == nobody) best = owners[i];
    changed = changed || best != owners[i];
    groups[best].patches.push_back(i);
  }
  for (PlaneGroup& group : groups) sum_anew(group, patches, options);
  heaviest_first(groups);
  return changed;
}

}  // namespace

void absorb(PlaneGroup& whole, PlaneGroup& part, std::span<const PlanePatch> patches,
            const PlaneMapOptions& options) {
  whole.patches.insert(whole.patches.end(), part.patches.begin(), part.patches.end());
  part.patches.clear();
  sum_anew(whole, patches, options);
}

void heaviest_first(std::vector<PlaneGroup>& groups) {
  std::erase_if(groups, [](const PlaneGroup& g) { return g.patches.empty(); });
  std::stable_sort(groups.begin(), groups.end(), [](const PlaneGroup& a, const PlaneGroup& b) {
    if (a.surface.moments.weight != b.surface.moments.weight)
      return a.surface.moments.weight > b.surface.moments.weight;
    return a.patches.front() < b.patches.front();
  });
}

std::vector<PlaneGroup> group_patches(std::span<const PlanePatch> patches, std::span<const PlaneLeaf> leaves,
                                      const PlaneMapOptions& options) {
  std::vector<PlaneGroup> groups;
  Owners owners(patches.size(), nobody);
  for (std::uint32_t i = 0; i < patches.size(); ++i) {
    if (owners[i] != nobody) continue;
    groups.push_back(grow(patches, i, static_cast<std::uint32_t>(groups.size()), owners, options));
  }
  for (PlaneGroup& group : groups) sum_anew(group, patches, options);
  for (int round = 0; round < most_rounds; ++round) {
    const bool joined = join_wholes(groups, patches, options);
    if (!reassign(groups, patches, options) && !joined) break;
  }
  for (int round = 0; round < most_rounds && join_copies(groups, patches, leaves, options); ++round) {
  }
  return groups;
}

}  // namespace straightedge
