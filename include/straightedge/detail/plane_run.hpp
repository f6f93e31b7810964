// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

/// What PlaneMapBuilder::add sums in while a frame comes in. Kernels include this: no functions here.
namespace straightedge::detail {

/// Readings of one frame plane that go to one leaf, without their weight: one line of the cache. Empty ones
/// are all zeros.
struct alignas(64) PlaneRun {
  enum Sum : std::uint8_t { xx, xy, zz, x, yy, yz, xz, y, sums };

  std::int32_t sum[sums];  ///< of places from the leaf's centre and of their products, quanta
  std::int64_t z;
  std::int64_t residual;  ///< squares, quanta²
  std::uint64_t leaf;     ///< place x | y << 21 | z << 42 in the grid of leaves
  std::int32_t readings;
  std::uint32_t label;

  static constexpr std::int32_t most_readings = 1 << 15;  ///< of 2^14 each: sums stay below 2^30
};

/// The runs of a frame in the order of their first readings, and where to look for one.
struct PlaneRunTable {
  PlaneRun* runs = nullptr;
  std::uint32_t* slots = nullptr;  ///< 2^(64 − shift): index + 1 of a run, 0 is free
  std::uint32_t used = 0;
  std::uint32_t shift = 64;
};

}  // namespace straightedge::detail
