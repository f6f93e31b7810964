// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "map/picture_rows.hpp"
#include "straightedge/edge_position.hpp"

namespace straightedge {

/// Which way edges run, and where between the pixels they lie: mostly the gradient of one picture tells both.
/// Where the field of positions has no magnitude, it is that of its gradient.
struct EdgeSources {
  GradientField directions, positions;

  EdgeSources() = default;
  EdgeSources(const GradientField& both) : directions(both), positions(both) {}
  EdgeSources(const GradientField& of_directions, const GradientField& of_positions)
      : directions(of_directions), positions(of_positions) {}

  bool have_magnitude() const noexcept { return positions.magnitude.data != nullptr; }
};

/// Rows of a large picture lie far from one another in memory. Most edges that cross a row go on in the next
/// ones, which are asked for so many rows ahead. Changes nothing but the time.
inline constexpr std::int32_t gradient_rows_ahead = 8;

/// Adds the edge pixel (x, y) to the batch, with the magnitudes across the edge or, where there are none, the
/// gradients that they are made from.
inline void read_edge(const EdgeSources& from, std::int32_t x, std::int32_t y, EdgeBatch& batch) noexcept {
  const GradientField& field = from.positions;
  constexpr std::int32_t middle = EdgeBatch::around / 2;
  const auto step_down = [](const auto& image) {  // elements from one row to the next
    return image.stride / static_cast<std::ptrdiff_t>(sizeof(*image.data));
  };
  const std::int32_t at = batch.count++;
  const std::int16_t along = from.directions.x.at(x, y), down = from.directions.y.at(x, y);
  batch.x[at] = x;
  batch.y[at] = y;
  batch.dx[at] = along;
  batch.dy[at] = down;
  const bool across_columns = (along < 0 ? -along : along) >= (down < 0 ? -down : down);
  const std::int32_t place = across_columns ? x : y;
  const std::int32_t places = across_columns ? field.x.width : field.x.height;
  if (place < middle || place + middle >= places) {
    for (std::int32_t k = 0; k < EdgeBatch::around; ++k)
      batch.magnitude[k][at] = batch.near_dx[k][at] = batch.near_dy[k][at] = 0;
  } else if (field.magnitude.data != nullptr) {
    const std::int32_t* const magnitude = field.magnitude.row(y) + x;
    const std::ptrdiff_t step = across_columns ? 1 : step_down(field.magnitude);
    for (std::int32_t k = 0; k < EdgeBatch::around; ++k)
      batch.magnitude[k][at] = magnitude[(k - middle) * step];
  } else {
    const std::int16_t* const dx = field.x.row(y) + x;
    const std::int16_t* const dy = field.y.row(y) + x;
    const std::ptrdiff_t step_dx = across_columns ? 1 : step_down(field.x);
    const std::ptrdiff_t step_dy = across_columns ? 1 : step_down(field.y);
    for (std::int32_t k = 0; k < EdgeBatch::around; ++k) {
      batch.near_dx[k][at] = dx[(k - middle) * step_dx];
      batch.near_dy[k][at] = dy[(k - middle) * step_dy];
    }
  }
}

}  // namespace straightedge
