// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/line_grid.hpp"

#include <algorithm>
#include <cmath>

namespace straightedge {
namespace {

constexpr double cell = 32;

std::int64_t key_of(std::int64_t column, std::int64_t row) {
  return column * (std::int64_t{1} << 32) + row;
}

/// Calls visit(column, row) for the cells that the line passes through, some of them more than once.
template <class Visit>
void walk_cells(const WallLine& line, const Visit& visit) {
  const int steps = static_cast<int>(line.length() / (0.5 * cell)) + 1;
  for (int k = 0; k <= steps; ++k) {
    const double s = line.begin + line.length() * k / steps;
    visit(static_cast<std::int64_t>(std::floor(line.x_at(s) / cell)),
          static_cast<std::int64_t>(std::floor(line.y_at(s) / cell)));
  }
}

}  // namespace

LineGrid::LineGrid(const std::vector<WallLine>& lines, double reach) : reach_(reach), lines_(lines.size()) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    walk_cells(lines[i], [&](std::int64_t column, std::int64_t row) {
      std::vector<std::size_t>& here = cells_[key_of(column, row)];
      if (here.empty() || here.back() != i) here.push_back(i);
    });
  }
}

std::vector<std::size_t> LineGrid::near(const WallLine& line) const {
  // A line is sampled every half cell, so it may touch a cell that was not noted: one ring more.
  const auto ring = static_cast<std::int64_t>(std::ceil(reach_ / cell)) + 1;
  std::vector<std::size_t> found;
  std::vector<char> listed(lines_);
  walk_cells(line, [&](std::int64_t column, std::int64_t row) {
    for (std::int64_t dc = -ring; dc <= ring; ++dc) {
      for (std::int64_t dr = -ring; dr <= ring; ++dr) {
        const auto at = cells_.find(key_of(column + dc, row + dr));
        if (at == cells_.end()) continue;
        for (const std::size_t i : at->second) {
          if (listed[i] == 0) found.push_back(i);
          listed[i] = 1;
        }
      }
    }
  });
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace straightedge
