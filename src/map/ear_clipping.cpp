// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/ear_clipping.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace straightedge {
namespace {

/// Corners sorted into square cells.
class CornerGrid {
 public:
  CornerGrid(const Borders& borders, const std::vector<std::uint32_t>& corners) {
    low_ = high_ = borders.at(corners.front());
    for (const std::uint32_t corner : corners) {
      const GridPoint& p = borders.at(corner);
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
    }
    choose_cells(corners.size());
    starts_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
    for (const std::uint32_t corner : corners) ++starts_[cell_of(borders.at(corner)) + 1];
    for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
    members_.resize(corners.size());
    for (const std::uint32_t corner : corners) members_[next[cell_of(borders.at(corner))]++] = corner;
  }

  /// Whether `wanted` says yes to a corner in the cells that the box touches.
  template <class Wanted>
  bool any_in_box(const GridPoint& low, const GridPoint& high, const Wanted& wanted) const {
    for (std::int64_t row = row_of(low.y); row <= row_of(high.y); ++row) {
      const auto first = static_cast<std::size_t>(row * columns_ + column_of(low.x));
      const auto last = static_cast<std::size_t>(row * columns_ + column_of(high.x));
      for (std::size_t i = starts_[first]; i < starts_[last + 1]; ++i) {
        if (wanted(members_[i])) return true;
      }
    }
    return false;
  }

 private:
  /// About two corners a cell, and never many more cells than corners.
  void choose_cells(std::size_t corners) {
    const auto width = static_cast<double>(high_.x - low_.x + 1);
    const auto height = static_cast<double>(high_.y - low_.y + 1);
    const double share = 2 / static_cast<double>(corners);
    const double side = std::max(std::sqrt(width * height * share), std::max(width, height) * share);
    side_ = static_cast<std::int64_t>(std::ceil(side));
    columns_ = (high_.x - low_.x) / side_ + 1;
    rows_ = (high_.y - low_.y) / side_ + 1;
  }
  std::int64_t column_of(std::int64_t x) const { return (x - low_.x) / side_; }
  std::int64_t row_of(std::int64_t y) const { return (y - low_.y) / side_; }
  std::size_t cell_of(const GridPoint& p) const {
    return static_cast<std::size_t>(row_of(p.y) * columns_ + column_of(p.x));
  }

  GridPoint low_, high_;
  std::int64_t side_ = 1, columns_ = 1, rows_ = 1;
  std::vector<std::uint32_t> starts_, members_;
};

class EarClipper {
 public:
  EarClipper(Borders& borders, std::uint32_t first, std::vector<Triangle>& triangles)
      : borders_(borders),
        triangles_(triangles),
        waiting_(borders.corners.size()),
        gone_(borders.corners.size()) {
    std::uint32_t corner = first;
    do {
      queue_.push_back(corner);
      corner = borders_.corners[corner].after;
    } while (corner != first);
    left_ = queue_.size();
  }

  void run() {
    while (left_ >= 3) {
      const std::vector<std::uint32_t> corners = queue_;
      run_queue(CornerGrid(borders_, corners), left_ / 2);
      if (left_ == corners.size()) cut_any(corners);
      queue_ = remaining(corners);
    }
  }

 private:
  /// Until the queue is empty, or so few are left that the grid has become too fine.
  void run_queue(const CornerGrid& grid, std::size_t enough) {
    for (const std::uint32_t corner : queue_) waiting_[corner] = 1;
    for (std::size_t next = 0; next < queue_.size() && left_ >= 3 && left_ > enough; ++next) {
      const std::uint32_t corner = queue_[next];
      waiting_[corner] = 0;
      if (gone_[corner] != 0) continue;
      const std::int64_t turning = borders_.turn_at(corner);
      if (turning == 0) {
        drop(corner);
      } else if (turning > 0 && is_ear(corner, grid)) {
        cut(corner);
      }
    }
  }

  bool is_ear(std::uint32_t corner, const CornerGrid& grid) const {
    const GridPoint& a = borders_.before(corner);
    const GridPoint& b = borders_.at(corner);
    const GridPoint& c = borders_.after(corner);
    const GridPoint low{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y})};
    const GridPoint high{std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y})};
    return !grid.any_in_box(low, high, [&](std::uint32_t other) {
      const GridPoint& p = borders_.at(other);
      if (turn(c, a, p) < 0 || turn(a, b, p) < 0 || turn(b, c, p) < 0) return false;
      // Borders that touch in a corner do not get into one another's ears.
      if (gone_[other] != 0 || p == a || p == b || p == c) return false;
      return borders_.turn_at(other) <= 0;
    });
  }

  void cut(std::uint32_t corner) {
    const Corner& here = borders_.corners[corner];
    triangles_.push_back(
        {borders_.corners[here.before].point, here.point, borders_.corners[here.after].point});
    drop(corner);
  }

  void drop(std::uint32_t corner) {
    const Corner& here = borders_.corners[corner];
    borders_.link(here.before, here.after);
    gone_[corner] = 1;
    --left_;
    for (const std::uint32_t neighbour : {here.before, here.after}) {
      if (waiting_[neighbour] == 0) queue_.push_back(neighbour);
      waiting_[neighbour] = 1;
    }
  }

  void cut_any(const std::vector<std::uint32_t>& corners) {
    const auto turns_left = [&](std::uint32_t corner) { return borders_.turn_at(corner) > 0; };
    const auto found = std::find_if(corners.begin(), corners.end(), turns_left);
    if (found != corners.end()) {
      cut(*found);
    } else {
      drop(corners.front());
    }
  }

  std::vector<std::uint32_t> remaining(const std::vector<std::uint32_t>& corners) const {
    std::vector<std::uint32_t> rest;
    for (const std::uint32_t corner : corners) {
      if (gone_[corner] == 0) rest.push_back(corner);
    }
    return rest;
  }

  Borders& borders_;
  std::vector<Triangle>& triangles_;
  std::vector<std::uint32_t> queue_;
  std::vector<char> waiting_, gone_;
  std::size_t left_ = 0;
};

}  // namespace

void clip_ears(Borders& borders, std::uint32_t corner, std::vector<Triangle>& triangles) {
  EarClipper(borders, corner, triangles).run();
}

}  // namespace straightedge
