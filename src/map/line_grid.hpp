// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "map/wall_line.hpp"

namespace straightedge {

/// Which lines come near one another, without comparing each with each: squares of 64 pixels, and in each
/// the lines that pass through it.
class LineGrid {
 public:
  /// `reach`: lines that come no nearer to one another than this need not be found.
  LineGrid(const std::vector<WallLine>& lines, double reach);

  /// Indices of all lines that may come within reach of this one, itself included if it was put in;
  /// ascending, each once. Valid until the next question.
  const std::vector<std::uint32_t>& near(const WallLine& line);

 private:
  /// Cells from left to right and from top to bottom, all four inside.
  struct CellSquare {
    std::int32_t left = 0, right = 0, top = 0, bottom = 0;
  };
  template <class Visit>
  static void cover(const WallLine& line, double reach, const Visit& visit);
  std::size_t number_of(std::int32_t column, std::int32_t row) const {
    return static_cast<std::size_t>(row - table_.top) *
               static_cast<std::size_t>(table_.right - table_.left + 1) +
           static_cast<std::size_t>(column - table_.left);
  }

  double reach_;
  CellSquare table_;                    ///< over all lines
  std::vector<std::uint32_t> starts_;   ///< of each cell's lines, and the end
  std::vector<std::uint32_t> indices_;  ///< of lines, cell by cell
  std::vector<std::uint64_t> marks_;    ///< a bit a line, none set between questions
  std::vector<std::uint32_t> found_;
};

}  // namespace straightedge
