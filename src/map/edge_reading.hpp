// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "map/picture_rows.hpp"
#include "map/pixel_gradient.hpp"
#include "straightedge/edge_position.hpp"

namespace straightedge {

/// Which way edges run, and where between the pixels they lie: mostly the gradient of one picture tells both.
/// Where the field of positions has no magnitude, it is that of its gradient.
struct EdgeSources {
  GradientSource directions, positions;

  EdgeSources() = default;
  EdgeSources(const GradientField& both) : directions(both), positions(both) {}
  EdgeSources(const GradientSource& of_directions, const GradientSource& of_positions)
      : directions(of_directions), positions(of_positions) {}

  bool have_magnitude() const noexcept { return positions.stored.magnitude.data != nullptr; }
};

/// Rows of a large picture lie far from one another in memory. Most edges that cross a row go on in the next
/// ones, which are asked for so many rows ahead. Changes nothing but the time.
inline constexpr std::int32_t gradient_rows_ahead = 8;

namespace edge_reading {

/// The pixels across an edge, the edge's own in the middle.
struct Across {
  static constexpr std::int32_t middle = EdgeBatch::around / 2;
  std::int32_t x, y, at;  ///< `at`: in the batch
  bool columns;           ///< they lie side by side, else one above the other

  bool is_inside(Size size) const noexcept {
    const std::int32_t place = columns ? x : y, places = columns ? size.width : size.height;
    return place >= middle && place + middle < places;
  }
  template <class T, class U>
  void copy(const ImageView<const T>& from, U (&to)[EdgeBatch::around][EdgeBatch::room]) const noexcept {
    const std::ptrdiff_t step = columns ? 1 : from.stride / static_cast<std::ptrdiff_t>(sizeof(T));
    for (std::int32_t k = 0; k < EdgeBatch::around; ++k)
      to[k][at] = static_cast<U>(from.row(y)[x + (k - middle) * step]);
  }
  /// As MadeGradients, which would add up each of the sums aside three times.
  void make(GrayView blurred, EdgeBatch& batch) const noexcept {
    constexpr std::int32_t around = EdgeBatch::around;
    const std::ptrdiff_t step = columns ? 1 : blurred.stride, aside = columns ? blurred.stride : 1;
    const std::uint8_t* pixel = blurred.row(y) + x - (middle + 1) * step;
    std::int32_t sum[around + 2], difference[around + 2];
    for (std::int32_t k = 0; k < around + 2; ++k, pixel += step) {
      sum[k] = pixel[-aside] + 2 * pixel[0] + pixel[aside];
      difference[k] = pixel[aside] - pixel[-aside];
    }
    auto& along = columns ? batch.near_dx : batch.near_dy;
    auto& beside = columns ? batch.near_dy : batch.near_dx;
    for (std::int32_t k = 0; k < around; ++k) {
      along[k][at] = static_cast<std::int16_t>(sum[k + 2] - sum[k]);
      beside[k][at] = static_cast<std::int16_t>(difference[k] + 2 * difference[k + 1] + difference[k + 2]);
    }
  }
};

}  // namespace edge_reading

/// Adds the edge pixel (x, y) to the batch, with the magnitudes across the edge or, where there are none, the
/// gradients that they are made from.
inline void read_edge(const EdgeSources& from, std::int32_t x, std::int32_t y, EdgeBatch& batch) noexcept {
  const std::int32_t at = batch.count++;
  const PixelGradient here = from.directions.at(x, y);
  batch.x[at] = x;
  batch.y[at] = y;
  batch.dx[at] = static_cast<std::int16_t>(here.dx);
  batch.dy[at] = static_cast<std::int16_t>(here.dy);
  const bool columns = (here.dx < 0 ? -here.dx : here.dx) >= (here.dy < 0 ? -here.dy : here.dy);
  const edge_reading::Across across{x, y, at, columns};
  const GradientSource& source = from.positions;
  if (!across.is_inside(source.size())) {
    for (std::int32_t k = 0; k < EdgeBatch::around; ++k)
      batch.magnitude[k][at] = batch.near_dx[k][at] = batch.near_dy[k][at] = 0;
  } else if (!source.is_stored()) {
    across.make(source.blurred, batch);
  } else if (from.have_magnitude()) {
    across.copy(source.stored.magnitude, batch.magnitude);
  } else {
    across.copy(source.stored.x, batch.near_dx);
    across.copy(source.stored.y, batch.near_dy);
  }
}

}  // namespace straightedge
