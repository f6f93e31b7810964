// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "localize/wall_grid.hpp"

#include <cmath>

namespace straightedge::localize {
namespace {

constexpr double smallest_cell_m = 1;
constexpr double most_cells = 1e6;

}  // namespace

/// Where the squares lie.
void WallGrid::frame(const std::vector<Wall>& walls, double reach_m) {
  double right = -1e300, top = -1e300;
  left_ = bottom_ = 1e300;
  for (const Wall& wall : walls) {
    for (const double s : {wall.begin, wall.end}) {
      left_ = std::min(left_, wall.x_at(s));
      right = std::max(right, wall.x_at(s));
      bottom_ = std::min(bottom_, wall.y_at(s));
      top = std::max(top, wall.y_at(s));
    }
  }
  left_ -= reach_m;
  bottom_ -= reach_m;
  const double width = right + reach_m - left_, height = top + reach_m - bottom_;
  cell_ = std::max(smallest_cell_m, std::sqrt(width * height / most_cells));
  columns_ = static_cast<int>(width / cell_) + 1;
  rows_ = static_cast<int>(height / cell_) + 1;
}

template <class Visit>
void WallGrid::for_cells_near(const Wall& wall, double reach_m, const Visit& visit) const {
  const double near = reach_m + 0.71 * cell_;  // from the square's centre; 0.71 is half its diagonal
  const double x0 = wall.x_at(wall.begin), x1 = wall.x_at(wall.end);
  const double y0 = wall.y_at(wall.begin), y1 = wall.y_at(wall.end);
  const int c0 = column(std::min(x0, x1) - reach_m), c1 = column(std::max(x0, x1) + reach_m);
  const int r0 = row(std::min(y0, y1) - reach_m), r1 = row(std::max(y0, y1) + reach_m);
  for (int r = r0; r <= r1; ++r) {
    for (int c = c0; c <= c1; ++c) {
      const double x = left_ + (c + 0.5) * cell_, y = bottom_ + (r + 0.5) * cell_;
      if (squared_distance(wall, x, y) <= near * near) visit(index(c, r));
    }
  }
}

WallGrid::WallGrid(const std::vector<Wall>& walls, double reach_m) {
  frame(walls, reach_m);
  // Counted first, then filled in: two passes, no list a square.
  starts_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  for (const Wall& wall : walls)
    for_cells_near(wall, reach_m, [&](std::size_t cell) { ++starts_[cell + 1]; });
  for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
  items_.resize(starts_.back());
  std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
  for (std::uint32_t i = 0; i < walls.size(); ++i)
    for_cells_near(walls[i], reach_m, [&](std::size_t cell) { items_[next[cell]++] = i; });
}

std::span<const std::uint32_t> WallGrid::at(double x, double y) const {
  const double u = (x - left_) / cell_, v = (y - bottom_) / cell_;
  if (!(u >= 0 && v >= 0 && u < columns_ && v < rows_)) return {};
  return cell(static_cast<int>(u), static_cast<int>(v));
}

}  // namespace straightedge::localize
