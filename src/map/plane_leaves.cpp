// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/plane_leaves.hpp"

#include <algorithm>

namespace straightedge {
namespace {

constexpr std::size_t first_slots = 1024;

// Multiplication carries every bit of the key upwards; the upper bits choose the slot.
std::size_t slot_of(const PlaneLeafKey& key, std::size_t slots) {
  const std::uint64_t mixed =
      (key.leaf ^ (std::uint64_t{key.surface} << 32U) ^ key.surface) * 0x9E3779B97F4A7C15U;
  return static_cast<std::size_t>((mixed ^ (mixed >> 32U)) & (slots - 1));
}

}  // namespace

void PlaneLeafSums::add(const PlaneLeafSums& o) noexcept {
  readings += o.readings;
  weight += o.weight;
  x += o.x;
  y += o.y;
  z += o.z;
  xx += o.xx;
  xy += o.xy;
  xz += o.xz;
  yy += o.yy;
  yz += o.yz;
  zz += o.zz;
  nx += o.nx;
  ny += o.ny;
  nz += o.nz;
  tilt += o.tilt;
  residual += o.residual;
  sightings += o.sightings;
  spacing = std::min(spacing, o.spacing);
}

std::size_t PlaneLeaves::place(const PlaneLeafKey& key) {
  if (2 * (leaves_.size() + 1) > slots_.size()) grow();
  std::size_t slot = slot_of(key, slots_.size());
  while (slots_[slot] != 0) {
    const std::size_t found = slots_[slot] - 1;
    if (leaves_[found].key == key) return found;
    slot = (slot + 1) & (slots_.size() - 1);
  }
  leaves_.push_back({key, {}});
  slots_[slot] = static_cast<std::uint32_t>(leaves_.size());
  return leaves_.size() - 1;
}

void PlaneLeaves::grow() {
  slots_.assign(std::max(first_slots, 2 * slots_.size()), 0);
  for (std::size_t i = 0; i < leaves_.size(); ++i) {
    std::size_t slot = slot_of(leaves_[i].key, slots_.size());
    while (slots_[slot] != 0) slot = (slot + 1) & (slots_.size() - 1);
    slots_[slot] = static_cast<std::uint32_t>(i + 1);
  }
}

std::vector<PlaneLeaf> PlaneLeaves::sorted() const {
  std::vector<PlaneLeaf> leaves = leaves_;
  std::sort(leaves.begin(), leaves.end(),
            [](const PlaneLeaf& a, const PlaneLeaf& b) { return a.key < b.key; });
  return leaves;
}

bool PlaneLeaves::merge(const PlaneLeaves& other) {
  if (fullest_ + other.fullest_ > plane_grid::most_readings) return false;
  const std::size_t count = other.leaves_.size();  // the other may be this one
  for (std::size_t i = 0; i < count; ++i) {
    const PlaneLeaf leaf = other.leaves_[i];
    PlaneLeafSums& sums = at(place(leaf.key));
    sums.add(leaf.sums);
    note_fullest(sums.readings);
  }
  frames += other.frames;
  return true;
}

}  // namespace straightedge
