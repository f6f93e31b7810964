// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/hough_accumulator_directions.hpp"
#include "straightedge/rounding.hpp"
#include "straightedge/square_root.hpp"
#include "straightedge/trigonometry.hpp"

namespace straightedge {
namespace {

/// sin phi where cos phi = z.
double radius_at(double z) noexcept {
  const double squared = 1 - z * z;
  return squared > 0 ? square_root(squared) : 0;
}

double polar_angle(double z) noexcept {
  return arc_tangent(radius_at(z), z);
}

/// How far the azimuth can turn within an angle of a point at that radius from the axis; pi: to everywhere.
double azimuth_reach(double sine_of_angle, double radius) noexcept {
  if (radius <= sine_of_angle) return pi;
  return arc_tangent(sine_of_angle, square_root(radius * radius - sine_of_angle * sine_of_angle));
}

template <HoughRowLayout Layout>
void fill_rows(std::span<HoughRow> rows, std::int32_t all) noexcept {
  const auto count = static_cast<std::int32_t>(rows.size());
  std::int32_t above = 0;
  for (std::int32_t i = 0; i < count; ++i) {
    HoughRow& row = rows[static_cast<std::size_t>(i)];
    row.first = above;
    row.count = Layout::cells_in_row(count, i);
    row.top = Layout::top(count, i, above, all);
    above += row.count;
    row.bottom = i + 1 == count ? -1 : Layout::top(count, i + 1, above, all);
  }
}

/// Two directions nearer to one another than this cannot lie on both sides of a whole row.
double least_height(std::span<const HoughRow> rows) noexcept {
  double least = pi;
  for (const HoughRow& row : rows) {
    const double height = polar_angle(row.bottom) - polar_angle(row.top);
    // A cell round the pole is crossed along its diameter.
    const double across = row.count == 1 ? 2 * height : height;
    if (across < least) least = across;
  }
  return least;
}

Vector3 centre_of(const HoughRow& row, std::int32_t k) noexcept {
  if (row.count == 1) return {0, 0, row.top == 1 ? 1.0 : -1.0};
  const double phi = (polar_angle(row.top) + polar_angle(row.bottom)) / 2;
  const SineCosine polar = sine_cosine(phi);
  const SineCosine azimuth = sine_cosine(-pi + 2 * pi * (k + 0.5) / row.count);
  return {polar.sine * azimuth.cosine, polar.sine * azimuth.sine, polar.cosine};
}

/// Which of `count` cells this azimuth is in, before wrapping round.
std::int32_t cell_at(double azimuth, std::int32_t count) noexcept {
  return static_cast<std::int32_t>(floor_to_integer((azimuth + pi) * count / (2 * pi)));
}

}  // namespace

void HoughDirections::fill(HoughCells kind) noexcept {
  if (kind == HoughCells::ball) {
    fill_rows<HoughBallRows>(rows_, size());
  } else {
    fill_rows<HoughArrayRows>(rows_, size());
  }
  // Rounding of the angles must not take the promise back.
  cell_size_ = least_height(rows_) * (1 - 1e-9);
  const double sine_of_size = sine(cell_size_);
  for (HoughRow& row : rows_) {
    const double top = radius_at(row.top), bottom = radius_at(row.bottom);
    row.reach = azimuth_reach(sine_of_size, top < bottom ? top : bottom);
    for (std::int32_t k = 0; k < row.count; ++k) {
      centres_[static_cast<std::size_t>(row.first + k)] = centre_of(row, k);
    }
  }
}

std::int32_t HoughDirections::row_at(double z) const noexcept {
  // The first row whose lower border is not above z.
  std::size_t low = 0, high = rows_.size() - 1;
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    if (rows_[middle].bottom > z) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return static_cast<std::int32_t>(low);
}

std::int32_t HoughDirections::row_of(std::int32_t cell) const noexcept {
  std::size_t low = 0, high = rows_.size() - 1;
  while (low < high) {
    const std::size_t middle = (low + high + 1) / 2;
    if (rows_[middle].first <= cell) {
      low = middle;
    } else {
      high = middle - 1;
    }
  }
  return static_cast<std::int32_t>(low);
}

std::int32_t HoughDirections::cell(const Vector3& direction) const noexcept {
  const HoughRow& row = rows_[static_cast<std::size_t>(row_at(direction.z))];
  if (row.count == 1) return row.first;
  const std::int32_t k = cell_at(arc_tangent(direction.y, direction.x), row.count);
  return row.first + (k < row.count ? k : 0);
}

std::int32_t HoughDirections::antipode(std::int32_t cell) const noexcept {
  const auto r = static_cast<std::size_t>(row_of(cell));
  const HoughRow& row = rows_[r];
  const HoughRow& opposite = rows_[rows_.size() - 1 - r];
  const std::int32_t k = cell - row.first;
  const std::int32_t half = row.count / 2;
  return opposite.first + (k < half ? k + half : k - half) * (row.count > 1);
}

double HoughDirections::area(std::int32_t cell) const noexcept {
  const HoughRow& row = rows_[static_cast<std::size_t>(row_of(cell))];
  return 2 * pi * (row.top - row.bottom) / row.count;
}

HoughCellRange HoughDirections::range_in_row(std::int32_t r, double from_rad, double to_rad) const noexcept {
  const HoughRow& row = rows_[static_cast<std::size_t>(r)];
  std::int32_t from = cell_at(from_rad, row.count);
  const std::int32_t count = cell_at(to_rad, row.count) - from + 1;
  if (count >= row.count) return {r, 0, row.count};
  from = from < 0 ? from + row.count : from;
  return {r, from >= row.count ? from - row.count : from, count};
}

HoughCellRange HoughDirections::neighbours_in_row(std::int32_t cell, std::int32_t r,
                                                  std::int32_t other) const noexcept {
  const HoughRow& row = rows_[static_cast<std::size_t>(r)];
  const HoughRow& to = rows_[static_cast<std::size_t>(other)];
  // The larger reach of both rows, so that neighbours are so mutually.
  const double reach = row.reach > to.reach ? row.reach : to.reach;
  if (reach >= pi || row.count == 1) return {other, 0, to.count};
  const std::int32_t k = cell - row.first;
  const double width = 2 * pi / row.count;
  return range_in_row(other, -pi + k * width - reach, -pi + (k + 1) * width + reach);
}

HoughDirections::Near HoughDirections::near_of(const Vector3& direction, double angle_rad) const noexcept {
  const SineCosine turn = sine_cosine(angle_rad);
  const double z = direction.z;
  const double radius = radius_at(z);
  // The cap's lowest and highest parallel; a cap over a pole has the pole.
  const double highest = z >= turn.cosine ? 1 : z * turn.cosine + radius * turn.sine;
  const double lowest = -z >= turn.cosine ? -1 : z * turn.cosine - radius * turn.sine;
  return {row_at(highest), row_at(lowest), arc_tangent(direction.y, direction.x),
          azimuth_reach(turn.sine, radius)};
}

}  // namespace straightedge
