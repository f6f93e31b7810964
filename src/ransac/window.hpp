// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "ransac/lattice.hpp"
#include "straightedge/inverse_depth.hpp"

namespace straightedge::ransac {

/// Windows are squares of 13 cells.
inline constexpr std::int32_t window_half = 6;

using Window = detail::RansacWindow;

inline SearchReadings readings_of(const Window& w) noexcept {
  return {w.u, w.v, w.q, w.w};
}
constexpr std::uint32_t padded(const Window& w) noexcept {
  return (w.count + search_lanes - 1) / search_lanes * search_lanes;
}

/// Free readings of a window's cells and of some to the right of it: where there are few, it need not be
/// gathered.
std::uint32_t count_free(const Lattice& lattice, std::int32_t column, std::int32_t row) noexcept;

void gather(const Lattice& lattice, std::int32_t column, std::int32_t row, Window& window) noexcept;

/// What a search in one window found.
struct WindowPlane {
  InverseDepthPlane plane;  ///< counted from pixel (0, 0)
  SearchPlane local;        ///< the same, as the window counts
  std::uint32_t inliers = 0;
  std::uint32_t draws = 0;
  double rms = 0;  ///< of their residuals, gates
};

/// RANSAC among the readings of a window: triples from `stream`, sixteen at a time, their MSAC cost, local
/// optimisation of the best of them, stop rule. No inliers: nothing found.
WindowPlane best_of_window(const Lattice& lattice, const Window& window, const RansacSearchOptions& options,
                           std::uint64_t stream) noexcept;

}  // namespace straightedge::ransac
