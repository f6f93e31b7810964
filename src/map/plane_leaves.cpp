// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/plane_leaves.hpp"

#include <algorithm>
#include <array>

namespace straightedge {
namespace {

constexpr std::size_t first_slots = 1024;

// Multiplication carries every bit of the key upwards; the upper bits choose the slot.
std::size_t slot_of(const PlaneLeafKey& key, std::size_t slots) {
  const std::uint64_t mixed =
      (key.leaf ^ (std::uint64_t{key.surface} << 32U) ^ key.surface) * 0x9E3779B97F4A7C15U;
  return static_cast<std::size_t>((mixed ^ (mixed >> 32U)) & (slots - 1));
}

void expect_leaf(const PlaneLeaf& leaf) {
  const auto* const bytes = reinterpret_cast<const std::byte*>(&leaf);
  for (std::size_t at = 0; at < sizeof(PlaneLeaf); at += 64) __builtin_prefetch(bytes + at);
}

/// A key, and where its leaf stands.
struct Place {
  std::uint64_t leaf;
  std::uint32_t surface, place;
};

/// Radix sort, the lowest digit first.
void sort_by_leaf(std::vector<Place>& places) {
  constexpr unsigned bits = 11;
  constexpr std::uint64_t values = 1U << bits;
  std::vector<Place> sorted(places.size());
  for (unsigned shift = 0; shift < 3 * morton_levels; shift += bits) {
    std::array<std::uint32_t, values + 1> starts{};
    const auto digit = [shift](const Place& p) { return p.leaf >> shift & (values - 1); };
    for (const Place& p : places) ++starts[digit(p) + 1];
    for (std::size_t value = 0; value < values; ++value) starts[value + 1] += starts[value];
    for (const Place& p : places) sorted[starts[digit(p)]++] = p;
    places.swap(sorted);
  }
}

/// Of each leaf.
void sort_surfaces(std::vector<Place>& places) {
  const auto lower = [](const Place& a, const Place& b) { return a.surface < b.surface; };
  for (auto first = places.begin(), end = first; first != places.end(); first = end) {
    while (end != places.end() && end->leaf == first->leaf) ++end;
    if (end - first > 1) std::sort(first, end, lower);
  }
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

void PlaneLeaves::expect(const PlaneLeafKey& key) const noexcept {
  if (!slots_.empty()) __builtin_prefetch(&slots_[slot_of(key, slots_.size())]);
}

void PlaneLeaves::expect_sums(const PlaneLeafKey& key) const noexcept {
  if (slots_.empty()) return;
  const std::uint32_t found = slots_[slot_of(key, slots_.size())];
  if (found == 0) return;
  expect_leaf(leaves_[found - 1]);
}

std::uint32_t& PlaneLeaves::slot_for(const PlaneLeafKey& key) {
  if (2 * (leaves_.size() + 1) > slots_.size()) grow();
  std::size_t slot = slot_of(key, slots_.size());
  while (slots_[slot] != 0 && leaves_[slots_[slot] - 1].key != key) slot = (slot + 1) & (slots_.size() - 1);
  return slots_[slot];
}

std::size_t PlaneLeaves::place(const PlaneLeafKey& key) {
  std::uint32_t& slot = slot_for(key);
  if (slot == 0) {
    leaves_.push_back({key, {}});
    slot = static_cast<std::uint32_t>(leaves_.size());
  }
  return slot - 1;
}

void PlaneLeaves::add(const PlaneLeafKey& key, const PlaneLeafSums& sums) {
  std::uint32_t& slot = slot_for(key);
  if (slot != 0) {
    PlaneLeafSums& all = leaves_[slot - 1].sums;
    all.add(sums);
    note_fullest(all.readings);
    return;
  }
  leaves_.push_back({key, sums});
  slot = static_cast<std::uint32_t>(leaves_.size());
  note_fullest(sums.readings);
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
  std::vector<Place> places;
  places.reserve(leaves_.size());
  for (const PlaneLeaf& leaf : leaves_)
    places.push_back({leaf.key.leaf, leaf.key.surface, static_cast<std::uint32_t>(places.size())});
  sort_by_leaf(places);
  sort_surfaces(places);
  std::vector<PlaneLeaf> leaves;
  leaves.reserve(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    constexpr std::size_t ahead = 8;
    if (i + ahead < places.size()) expect_leaf(leaves_[places[i + ahead].place]);
    leaves.push_back(leaves_[places[i].place]);
  }
  return leaves;
}

bool PlaneLeaves::merge(const PlaneLeaves& other) {
  if (fullest_ + other.fullest_ > plane_grid::most_readings) return false;
  const std::size_t count = other.leaves_.size();  // the other may be this one
  for (std::size_t i = 0; i < count; ++i) {
    const PlaneLeaf leaf = other.leaves_[i];
    add(leaf.key, leaf.sums);
  }
  frames += other.frames;
  return true;
}

}  // namespace straightedge
