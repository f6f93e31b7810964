// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/line_grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace straightedge {
namespace {

constexpr double side = 64;
// Cells; no picture is larger. What lies outside counts as in the outermost cells: neighbours stay
// neighbours.
constexpr double before_first = -8;
constexpr double behind_last = 520;

/// Rounded down.
std::int32_t cell_at(double position) {
  const double cell = std::clamp(position / side, before_first, behind_last);
  const auto towards_zero = static_cast<std::int32_t>(cell);
  return towards_zero - (cell < towards_zero ? 1 : 0);
}

}  // namespace

/// Calls visit(cell) for the cells that the line passes through, some of them more than once.
template <class Visit>
void LineGrid::walk(const WallLine& line, const Visit& visit) const {
  const int steps = static_cast<int>(std::min(line.length() / (0.5 * side), 1e6)) + 1;
  for (int k = 0; k <= steps; ++k) {
    const double s = line.begin + line.length() * k / steps;
    visit(Cell{cell_at(line.x_at(s)), cell_at(line.y_at(s))});
  }
}

LineGrid::LineGrid(const std::vector<WallLine>& lines, double reach)
    // A line is sampled every half cell: no place of it, or of the one asked for, is further than a quarter
    // of a cell from a sample.
    : ring_(static_cast<std::int32_t>(std::ceil((reach + 0.5 * side) / side))),
      marks_((lines.size() + 63) / 64) {
  std::vector<std::pair<Cell, std::uint32_t>> passes;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto index = static_cast<std::uint32_t>(i);
    walk(lines[i], [&](Cell cell) {
      if (passes.empty() || passes.back() != std::pair(cell, index)) passes.emplace_back(cell, index);
    });
  }
  if (!passes.empty()) {
    Cell last = first_ = passes.front().first;
    for (const auto& [cell, line] : passes) {
      first_ = {std::min(first_.column, cell.column), std::min(first_.row, cell.row)};
      last = {std::max(last.column, cell.column), std::max(last.row, cell.row)};
    }
    columns_ = last.column - first_.column + 1;
    rows_ = last.row - first_.row + 1;
  }
  // A counting sort: sizes, then starts, then each pass to its place.
  starts_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1);
  for (const auto& [cell, line] : passes) ++starts_[number_of(cell) + 1];
  for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
  indices_.resize(passes.size());
  std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
  for (const auto& [cell, line] : passes) indices_[next[number_of(cell)]++] = line;
}

/// Marks the lines of the cells of one row, from one column to another.
void LineGrid::mark(std::int32_t row, std::int32_t from, std::int32_t to) {
  if (from > to) return;
  // The cells of a row lie one behind the other, and so do their lines.
  const std::uint32_t end = starts_[number_of({to, row}) + 1];
  for (std::uint32_t k = starts_[number_of({from, row})]; k < end; ++k)
    marks_[indices_[k] / 64] |= std::uint64_t{1} << indices_[k] % 64;
}

const std::vector<std::uint32_t>& LineGrid::near(const WallLine& line) {
  std::int32_t left = 0, right = -1, top = 0, bottom = -1;  // what was looked at last
  walk(line, [&](Cell cell) {
    const std::int32_t old_left = left, old_right = right, old_top = top, old_bottom = bottom;
    left = std::max(cell.column - ring_, first_.column);
    right = std::min(cell.column + ring_, first_.column + columns_ - 1);
    top = std::max(cell.row - ring_, first_.row);
    bottom = std::min(cell.row + ring_, first_.row + rows_ - 1);
    for (std::int32_t row = top; row <= bottom; ++row) {
      const bool known = row >= old_top && row <= old_bottom && old_left <= old_right;
      mark(row, left, known ? std::min(right, old_left - 1) : right);
      if (known) mark(row, std::max(left, old_right + 1), right);
    }
  });
  found_.clear();
  for (std::size_t word = 0; word < marks_.size(); ++word) {
    for (; marks_[word] != 0; marks_[word] &= marks_[word] - 1)
      found_.push_back(static_cast<std::uint32_t>(word * 64) +
                       static_cast<std::uint32_t>(std::countr_zero(marks_[word])));
  }
  return found_;
}

}  // namespace straightedge
