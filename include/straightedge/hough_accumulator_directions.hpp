// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

#include "straightedge/arena.hpp"
#include "straightedge/hough_accumulator_array.hpp"
#include "straightedge/hough_ball.hpp"
#include "straightedge/status.hpp"
#include "straightedge/vector3.hpp"

namespace straightedge {

/// What tells one kind of direction cells from another: how many cells a row has, and where it begins.
template <class T>
concept HoughRowLayout = requires(std::int32_t i) {
  { T::cells_in_row(i, i) } -> std::same_as<std::int32_t>;
  { T::top(i, i, i, i) } -> std::same_as<double>;
};
static_assert(HoughRowLayout<HoughArrayRows> && HoughRowLayout<HoughBallRows>);

enum class HoughCells : std::uint8_t {
  array,  ///< hough_accumulator_array.hpp
  ball,   ///< hough_ball.hpp
};

/// The cells between two parallels of the sphere. Cell k of `count` has the azimuth
/// [-pi + 2 pi k / count, -pi + 2 pi (k + 1) / count).
struct HoughRow {
  double top = 1, bottom = -1;  ///< z of the borders
  std::int32_t first = 0;       ///< number of the first cell
  std::int32_t count = 0;
  double reach = 0;  ///< azimuth that a step of one cell size can turn from here, radians
};

/// Consecutive cells of one row, `first` the number of a cell; wraps round the row's end.
struct HoughCellRange {
  std::int32_t row = 0, from = 0, count = 0;
};

/// The sphere of unit normals, cut into rows from the pole z = 1 to the pole z = −1, and the rows into cells,
/// numbered row by row. Every cell has an antipode, whose centre is opposite to its own.
class HoughDirections {
 public:
  static constexpr std::int32_t cells_in_row(HoughCells kind, std::int32_t rows, std::int32_t row) noexcept {
    return kind == HoughCells::ball ? HoughBallRows::cells_in_row(rows, row)
                                    : HoughArrayRows::cells_in_row(rows, row);
  }
  /// 0 unless 4 <= rows <= 1024.
  static constexpr std::int32_t cell_count(HoughCells kind, std::int32_t rows) noexcept {
    if (rows < 4 || rows > 1024 || kind > HoughCells::ball) return 0;
    std::int32_t sum = 0;
    for (std::int32_t row = 0; row < rows; ++row) sum += cells_in_row(kind, rows, row);
    return sum;
  }
  constexpr bool take(Arena& arena, HoughCells kind, std::int32_t rows) noexcept {
    rows_ = arena.take<HoughRow>(static_cast<std::size_t>(rows));
    centres_ = arena.take<Vector3>(static_cast<std::size_t>(cell_count(kind, rows)));
    return !arena.failed();
  }
  /// Fills the tables that `take` got.
  void fill(HoughCells kind) noexcept;

  std::int32_t size() const noexcept { return static_cast<std::int32_t>(centres_.size()); }
  std::span<const HoughRow> rows() const noexcept { return rows_; }

  /// The cell of a unit vector.
  std::int32_t cell(const Vector3& direction) const noexcept;
  /// The middle of its azimuths and of its polar angles; of the ball's polar cells the pole.
  const Vector3& centre(std::int32_t cell) const noexcept { return centres_[static_cast<std::size_t>(cell)]; }
  std::int32_t antipode(std::int32_t cell) const noexcept;
  std::int32_t row_of(std::int32_t cell) const noexcept;
  /// Steradians; all cells together have 4 pi.
  double area(std::int32_t cell) const noexcept;
  /// Two directions that differ by no more than this lie in one cell or in neighbours, radians.
  double cell_size() const noexcept { return cell_size_; }

  /// `visit(cell)` for the cell itself and all its neighbours.
  template <class Visit>
  void for_neighbours(std::int32_t cell, Visit&& visit) const noexcept {
    const std::int32_t row = row_of(cell);
    const std::int32_t last = static_cast<std::int32_t>(rows_.size()) - 1;
    for (std::int32_t r = row > 0 ? row - 1 : 0; r <= row + 1 && r <= last; ++r) {
      visit_range(neighbours_in_row(cell, row, r), visit);
    }
  }

  /// `visit(cell)` for all cells that come within `angle_rad` (below pi / 2) of the direction, and a few
  /// more.
  template <class Visit>
  void for_near(const Vector3& direction, double angle_rad, Visit&& visit) const noexcept {
    const Near near = near_of(direction, angle_rad);
    for (std::int32_t r = near.first_row; r <= near.last_row; ++r) {
      visit_range(range_in_row(r, near.azimuth - near.reach, near.azimuth + near.reach), visit);
    }
  }

 private:
  struct Near {
    std::int32_t first_row = 0, last_row = 0;
    double azimuth = 0, reach = 0;
  };

  Near near_of(const Vector3& direction, double angle_rad) const noexcept;
  std::int32_t row_at(double z) const noexcept;
  HoughCellRange range_in_row(std::int32_t row, double from_rad, double to_rad) const noexcept;
  HoughCellRange neighbours_in_row(std::int32_t cell, std::int32_t row, std::int32_t other) const noexcept;

  template <class Visit>
  void visit_range(const HoughCellRange& range, Visit&& visit) const noexcept {
    const HoughRow& row = rows_[static_cast<std::size_t>(range.row)];
    std::int32_t k = range.from;
    for (std::int32_t i = 0; i < range.count; ++i) {
      visit(row.first + k);
      if (++k == row.count) k = 0;
    }
  }

  std::span<HoughRow> rows_;
  std::span<Vector3> centres_;
  double cell_size_ = 0;
};

}  // namespace straightedge
