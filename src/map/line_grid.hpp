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
  struct Cell {
    std::int32_t column = 0, row = 0;
    bool operator==(const Cell&) const = default;
  };
  template <class Visit>
  void walk(const WallLine& line, const Visit& visit) const;
  std::size_t number_of(Cell cell) const {
    return static_cast<std::size_t>(cell.row - first_.row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(cell.column - first_.column);
  }
  void mark(std::int32_t row, std::int32_t from, std::int32_t to);

  std::int32_t ring_;
  // A table over the lines' bounding box.
  Cell first_;
  std::int32_t columns_ = 1, rows_ = 1;
  std::vector<std::uint32_t> starts_;   ///< of each cell's lines, and the end
  std::vector<std::uint32_t> indices_;  ///< of lines, cell by cell
  std::vector<std::uint64_t> marks_;    ///< a bit a line, none set between questions
  std::vector<std::uint32_t> found_;
};

}  // namespace straightedge
