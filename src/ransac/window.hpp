// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "ransac/lattice.hpp"
#include "ransac/rows.hpp"
#include "straightedge/inverse_depth.hpp"

namespace straightedge::ransac {

/// Windows of one size: squares of 2 half + 1 cells, of which every step-th column and row is looked at.
struct WindowShape {
  std::int32_t half = 0;
  std::int32_t step = 1;
};

/// Every shape's readings fit: at most 17 columns and rows are looked at.
using Window = detail::RansacWindow;

/// `widening`: the gate is so many times as wide as the lattice says.
void gather(const Lattice& lattice, std::int32_t column, std::int32_t row, const WindowShape& shape,
            float widening, Window& window) noexcept;

/// What a search in one window found.
struct WindowPlane {
  InverseDepthPlane plane;  ///< counted from pixel (0, 0)
  std::uint32_t inliers = 0;
  std::uint32_t draws = 0;
};

/// RANSAC among the readings of a window: triples from `stream`, MSAC cost, local optimisation of each new
/// best, stop rule. No inliers: nothing found.
WindowPlane best_of_window(const Window& window, const RansacSearchOptions& options,
                           std::uint64_t stream) noexcept;

}  // namespace straightedge::ransac
