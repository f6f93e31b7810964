// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "straightedge/image.hpp"

namespace straightedge::detail {

/// The pieces that all planes are in: cells with the same label that touch, side by side or one above the
/// other. One pass over the cells; runs of a row are joined with those of the row above (union-find).
struct CellPieces {
  Size size;
  std::span<const std::uint16_t> labels;
  std::span<std::uint16_t> length;  ///< an entry for each cell: at the first one of a run its cells
  /// An entry for each cell. At the first one of a run: where another run of its piece begins, or minus the
  /// piece's cells.
  std::span<std::int32_t> of_run;

  void find() const noexcept;
  /// Calls visit(first cell, cell after the last, label) for every run with a label.
  template <class Visit>
  void for_runs(const Visit& visit) const noexcept {
    for (std::int32_t begin = 0, end = 0; begin < size.width * size.height; begin = end) {
      end = end_of(begin);
      const std::uint16_t label = label_at(begin);
      if (label != 0) visit(begin, end, label);
    }
  }
  /// Of the piece that the run with this first cell is of.
  std::int32_t cells_of(std::int32_t run) const noexcept { return -at(root(run)); }

 private:
  std::uint16_t label_at(std::int32_t cell) const noexcept { return labels[static_cast<std::size_t>(cell)]; }
  std::int32_t& at(std::int32_t run) const noexcept { return of_run[static_cast<std::size_t>(run)]; }
  std::int32_t end_of(std::int32_t run) const noexcept { return run + length[static_cast<std::size_t>(run)]; }
  std::int32_t root(std::int32_t run) const noexcept;
  void join(std::int32_t a, std::int32_t b) const noexcept;
  void find_runs(std::int32_t row) const noexcept;
  void join_rows(std::int32_t row) const noexcept;
};

}  // namespace straightedge::detail
