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

/// Calls visit(square) for rectangles of cells that the line lies in, each no further than a cell from it:
/// of lines along a row or a column one is enough.
template <class Visit>
void LineGrid::cover(const WallLine& line, double reach, const Visit& visit) {
  const double x0 = line.x_at(line.begin), y0 = line.y_at(line.begin);
  const double dx = line.length() * line.tx(), dy = line.length() * line.ty();
  const double oblique = std::min(std::fabs(dx), std::fabs(dy));
  const int pieces = static_cast<int>(std::min(oblique / side, 1e6)) + 1;
  for (int k = 0; k < pieces; ++k) {
    const double from = static_cast<double>(k) / pieces, to = static_cast<double>(k + 1) / pieces;
    const auto [left, right] = std::minmax({x0 + from * dx, x0 + to * dx});
    const auto [top, bottom] = std::minmax({y0 + from * dy, y0 + to * dy});
    visit(CellSquare{cell_at(left - reach), cell_at(right + reach), cell_at(top - reach),
                     cell_at(bottom + reach)});
  }
}

LineGrid::LineGrid(const std::vector<WallLine>& lines, double reach)
    : reach_(reach), marks_((lines.size() + 63) / 64) {
  std::vector<std::pair<CellSquare, std::uint32_t>> passes;
  for (std::size_t i = 0; i < lines.size(); ++i)
    cover(lines[i], 0,
          [&](const CellSquare& square) { passes.emplace_back(square, static_cast<std::uint32_t>(i)); });
  if (!passes.empty()) table_ = passes.front().first;
  for (const auto& [square, line] : passes) {
    table_ = {std::min(table_.left, square.left), std::max(table_.right, square.right),
              std::min(table_.top, square.top), std::max(table_.bottom, square.bottom)};
  }
  // A counting sort: sizes, then starts, then each pass to its places.
  starts_.resize(number_of(table_.right, table_.bottom) + 2);
  const auto for_each_cell = [&](const auto& visit) {
    for (const auto& [square, line] : passes) {
      for (std::int32_t row = square.top; row <= square.bottom; ++row)
        for (std::int32_t column = square.left; column <= square.right; ++column)
          visit(number_of(column, row), line);
    }
  };
  for_each_cell([&](std::size_t cell, std::uint32_t) { ++starts_[cell + 1]; });
  for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
  indices_.resize(starts_.back());
  std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
  for_each_cell([&](std::size_t cell, std::uint32_t line) { indices_[next[cell]++] = line; });
}

const std::vector<std::uint32_t>& LineGrid::near(const WallLine& line) {
  cover(line, reach_, [&](const CellSquare& square) {
    const std::int32_t left = std::max(square.left, table_.left),
                       right = std::min(square.right, table_.right);
    if (left > right) return;
    const std::int32_t bottom = std::min(square.bottom, table_.bottom);
    for (std::int32_t row = std::max(square.top, table_.top); row <= bottom; ++row) {
      // The cells of a row lie one behind the other, and so do their lines.
      const std::uint32_t end = starts_[number_of(right, row) + 1];
      for (std::uint32_t k = starts_[number_of(left, row)]; k < end; ++k)
        marks_[indices_[k] / 64] |= std::uint64_t{1} << indices_[k] % 64;
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
