// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "straightedge/morton.hpp"

namespace straightedge {

/// The grid on which a plane map is summed. Space is cut into quanta and these into cubic leaves, the same
/// everywhere and for every map, so that the sums of two maps of one world frame can simply be added.
/// Quantum i of an axis stands for the coordinate (i + 1/2) · quantum_m.
namespace plane_grid {
inline constexpr double quanta_per_m = 2048;
inline constexpr double quantum_m = 1 / quanta_per_m;
inline constexpr int leaf_bits = 8;                                 ///< 256 quanta: a leaf has sides of 1/8 m
inline constexpr std::int32_t leaf_side = 1 << leaf_bits;           ///< quanta
inline constexpr double leaf_m = leaf_side * quantum_m;             ///< metres
inline constexpr int axis_bits = morton_levels;                     ///< leaves along an axis: 2^21
inline constexpr double reach_m = leaf_m * (1 << (axis_bits - 1));  ///< the grid covers ±131072 m
inline constexpr double weight_unit = 16;                           ///< one unit of weight, 1/m²
inline constexpr std::int64_t most_weight = 1 << 16;                ///< of one reading: sigma 1 mm
inline constexpr double normal_unit = 1.0 / 16384;                  ///< of a unit normal's coordinates
inline constexpr double tilt_unit = 1.0 / (1 << 24);                ///< of a normal's variance, radians²
inline constexpr std::int64_t most_tilt = 1 << 14;                  ///< 1.8 degrees
inline constexpr std::uint16_t no_spacing = 65535;                  ///< quanta
/// Every reading adds at most 2^30 to a sum, so this many fit into 63 bits with room to spare.
inline constexpr std::uint64_t most_readings = std::uint64_t{1} << 32U;
}  // namespace plane_grid

/// Which leaf, and which of the surfaces that pass through it.
struct PlaneLeafKey {
  std::uint64_t leaf = 0;     ///< Morton code of the leaf's place
  std::uint32_t surface = 0;  ///< bin of the direction from which it was seen and of its offset in the leaf

  constexpr auto operator<=>(const PlaneLeafKey&) const noexcept = default;
};

/// Integer sums over the readings of one surface in one leaf. All but `spacing` are sums, `spacing` is a
/// minimum: in whatever order readings come, the result is the same.
struct PlaneLeafSums {
  std::uint64_t readings = 0;
  std::int64_t weight = 0;                                      ///< w = 1/sigma², in weight_unit
  std::int64_t x = 0, y = 0, z = 0;                             ///< w · place, quanta from the leaf's centre
  std::int64_t xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;  ///< w · products of them
  std::int64_t nx = 0, ny = 0, nz = 0;  ///< w · the frame plane's normal towards the camera, in normal_unit
  std::int64_t tilt = 0;                ///< w · variance of that normal, in tilt_unit
  std::int64_t residual = 0;    ///< w · squared distance of the reading from its frame's plane, quanta²
  std::uint32_t sightings = 0;  ///< frame planes that count here (docs/plane-map.md)
  std::uint16_t spacing = plane_grid::no_spacing;  ///< quanta between neighbouring readings, closest view

  void add(const PlaneLeafSums& o) noexcept;
  constexpr bool operator==(const PlaneLeafSums&) const noexcept = default;
};

struct PlaneLeaf {
  PlaneLeafKey key;
  PlaneLeafSums sums;

  constexpr bool operator==(const PlaneLeaf&) const noexcept = default;
};

/// The leaves of a linear octree: a table from keys to sums. Time to find or add one does not depend on how
/// many there are; 150 to 170 bytes a leaf.
class PlaneLeaves {
 public:
  /// Where the leaf with this key stands in `unordered`; new ones come last, with empty sums.
  std::size_t place(const PlaneLeafKey& key);
  PlaneLeafSums& at(std::size_t place) noexcept { return leaves_[place].sums; }
  const PlaneLeaf& leaf(std::size_t place) const noexcept { return leaves_[place]; }

  /// Adds the sums to the leaf with this key.
  void add(const PlaneLeafKey& key, const PlaneLeafSums& sums);

  /// Say that `add` will come with this key soon; the second one a little later. What is far away in memory
  /// comes closer meanwhile.
  void expect(const PlaneLeafKey& key) const noexcept;
  void expect_sums(const PlaneLeafKey& key) const noexcept;

  std::size_t size() const noexcept { return leaves_.size(); }
  /// In the order of first readings, which depends on the order of frames.
  std::span<const PlaneLeaf> unordered() const noexcept { return leaves_; }
  /// By key, that is along the Morton curve: the same whatever came first.
  std::vector<PlaneLeaf> sorted() const;
  /// Readings of the fullest leaf, or more.
  std::uint64_t fullest() const noexcept { return fullest_; }
  void note_fullest(std::uint64_t readings) noexcept { fullest_ = readings > fullest_ ? readings : fullest_; }

  /// Adds the other's sums. False, and nothing done, when a sum could overflow.
  bool merge(const PlaneLeaves& other);

  std::uint64_t frames = 0;  ///< how many were added

 private:
  std::uint32_t& slot_for(const PlaneLeafKey& key);
  void grow();

  std::vector<PlaneLeaf> leaves_;
  std::vector<std::uint32_t> slots_;  // place + 1, 0 is free; a power of two, at most half full
  std::uint64_t fullest_ = 0;
};

}  // namespace straightedge
