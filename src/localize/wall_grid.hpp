// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "localize/wall.hpp"

namespace straightedge::localize {

/// Squares of a metre (larger in maps of more than a square kilometre), and in each the walls that come
/// within `reach` of it.
class WallGrid {
 public:
  WallGrid(const std::vector<Wall>& walls, double reach_m);

  /// The walls near the point; none outside of the grid.
  std::span<const std::uint32_t> at(double x, double y) const;

  /// Calls visit(walls, leave) for the squares that a ray along the unit vector (dx, dy) meets within
  /// `limit`, one after another; `leave` is the distance at which the ray leaves the square. Stops when visit
  /// says false. (J. Amanatides, A. Woo, Eurographics 1987, doi:10.2312/egtp.19871000.)
  template <class Visit>
  void walk(double x, double y, double dx, double dy, double limit, const Visit& visit) const {
    double from = 0, to = limit;
    clip(x, dx, left_, left_ + columns_ * cell_, from, to);
    clip(y, dy, bottom_, bottom_ + rows_ * cell_, from, to);
    if (!(from <= to)) return;
    int c = column(x + from * dx), r = row(y + from * dy);
    while (c >= 0 && r >= 0 && c < columns_ && r < rows_) {
      const double leave_x = leave(x, dx, left_, c), leave_y = leave(y, dy, bottom_, r);
      const double at = std::min(leave_x, leave_y);
      if (!visit(cell(c, r), at) || at >= to) return;
      if (leave_x < leave_y) {
        c += dx > 0 ? 1 : -1;
      } else {
        r += dy > 0 ? 1 : -1;
      }
    }
  }

 private:
  void frame(const std::vector<Wall>& walls, double reach_m);
  template <class Visit>
  void for_cells_near(const Wall& wall, double reach_m, const Visit& visit) const;
  std::size_t index(int c, int r) const {
    return static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(c);
  }
  std::span<const std::uint32_t> cell(int c, int r) const {
    const std::size_t i = index(c, r);
    return {items_.data() + starts_[i], starts_[i + 1] - starts_[i]};
  }
  int column(double x) const { return std::clamp(static_cast<int>((x - left_) / cell_), 0, columns_ - 1); }
  int row(double y) const { return std::clamp(static_cast<int>((y - bottom_) / cell_), 0, rows_ - 1); }

  static void clip(double at, double way, double low, double high, double& from, double& to) {
    if (way > -1e-12 && way < 1e-12) {
      if (at < low || at > high) to = -1;
      return;
    }
    const double a = (low - at) / way, b = (high - at) / way;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  double leave(double at, double way, double low, int i) const {
    if (way > -1e-12 && way < 1e-12) return 1e300;
    return (low + (i + (way > 0 ? 1 : 0)) * cell_ - at) / way;
  }

  double cell_ = 1, left_ = 0, bottom_ = 0;
  int columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> starts_, items_;  // walls of square i: items_[starts_[i] .. starts_[i + 1])
};

}  // namespace straightedge::localize
