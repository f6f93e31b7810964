// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "straightedge/arena.hpp"
#include "straightedge/depth_cells.hpp"
#include "straightedge/frame_planes_search.hpp"
#include "straightedge/image.hpp"
#include "straightedge/ransac_search_options.hpp"

/// What RansacSearch (ransac_search.hpp) works in.
namespace straightedge::detail {

/// The free readings of a window, ready to be drawn from and scored. Pixels count from (u0, v0). What fills
/// the last group of sixteen up is far from every plane. A row of thirteen may be written as sixteen.
struct RansacWindow {
  static constexpr std::uint32_t capacity = 176;
  float u[capacity], v[capacity], q[capacity], w[capacity];
  std::uint32_t count;
  std::int32_t u0, v0;
};

/// A plane whose readings fill the gate, and the window in which it was found.
struct RansacRoughPlane {
  float a, b, c;
  std::int16_t column, row;  ///< cells
  std::int16_t level;
};

/// Cells of one size in rows with a border of at least one, on the left of sixteen: rows begin where vectors
/// do.
struct RansacSearchLevel {
  std::span<float> u, v, q, w;  ///< a cell's reading: pixel, 1/z unless it is taken, 1 / gate
  std::span<std::uint8_t> hit, core, aside;
};

struct RansacSearchMemory {
  std::array<RansacSearchLevel, DepthCells::levels> levels;  ///< those of DepthCells
  std::span<float> row;                                      ///< of the smallest cells
  std::span<std::uint8_t> counts, columns;
  std::span<ProposedPlane> candidates;
  std::span<RansacRoughPlane> rough;
  std::span<RansacWindow> window;  ///< one

  /// Cells from one row to the next.
  static constexpr std::size_t stride_of(Size cells) noexcept {
    return (static_cast<std::size_t>(cells.width) + 15) / 16 * 16 + 16;
  }
  static constexpr RansacSearchMemory take(Arena& arena, Size size,
                                           const RansacSearchOptions& options) noexcept {
    const std::size_t overrun = search_overrun;
    RansacSearchMemory m;
    for (int i = finest_level(options); i <= coarsest_level(options); ++i) {
      const Size cells = DepthCells::size_of(size, i);
      const std::size_t count = stride_of(cells) * (static_cast<std::size_t>(cells.height) + 2) + overrun;
      RansacSearchLevel& level = m.levels[static_cast<std::size_t>(i)];
      for (std::span<float>* plane : {&level.u, &level.v, &level.q, &level.w})
        *plane = arena.take<float>(count);
      for (std::span<std::uint8_t>* marks : {&level.hit, &level.core, &level.aside})
        *marks = arena.take<std::uint8_t>(count);
    }
    const std::size_t longest = stride_of(DepthCells::size_of(size, finest_level(options))) + overrun;
    m.row = arena.take<float>(longest);
    m.counts = arena.take<std::uint8_t>(longest);
    m.columns = arena.take<std::uint8_t>(longest);
    m.candidates = arena.take<ProposedPlane>(static_cast<std::size_t>(options.max_candidates));
    m.rough = arena.take<RansacRoughPlane>(2 * static_cast<std::size_t>(options.max_candidates));
    m.window = arena.take<RansacWindow>(1);
    return m;
  }
};

}  // namespace straightedge::detail
