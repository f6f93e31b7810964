// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstdint>

#include "base/kernel_set.hpp"
#include "map/line_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

// As in edge_position.cpp, which says why.
constexpr double position_floor = 0.25;
constexpr double relative_noise = 0.08;

}  // namespace

void edge_magnitudes(EdgeBatch& batch, bool squared) noexcept {
  const std::int32_t count = batch.count;
  for (std::int32_t k = 0; k < EdgeBatch::around; ++k) {
    const std::int16_t* __restrict dx = batch.near_dx[k];
    const std::int16_t* __restrict dy = batch.near_dy[k];
    std::int32_t* __restrict magnitude = batch.magnitude[k];
    if (squared) {
      for (std::int32_t i = 0; i < count; ++i) magnitude[i] = dx[i] * dx[i] + dy[i] * dy[i];
    } else {
      for (std::int32_t i = 0; i < count; ++i)
        magnitude[i] = (dx[i] < 0 ? -dx[i] : dx[i]) + (dy[i] < 0 ? -dy[i] : dy[i]);
    }
  }
}

/// edge_position for many pixels; read that first. Where a pixel of the batch has its largest magnitude
/// beside it, what counts moves along by one.
void edge_places(EdgeBatch& batch) noexcept {
  const std::int32_t count = batch.count;
  for (std::int32_t i = 0; i < count; ++i) {
    const std::int32_t left = batch.magnitude[1][i], own = batch.magnitude[2][i],
                       right = batch.magnitude[3][i];
    const std::int32_t goes_left = (left > own ? 1 : 0) & (left >= right ? 1 : 0);
    const std::int32_t goes_right = (right > own ? 1 : 0) & (1 - goes_left);
    const std::int32_t top = goes_right - goes_left;
    std::int32_t before_top = top < 0 ? batch.magnitude[0][i] : left;
    before_top = top > 0 ? own : before_top;
    std::int32_t at_top = top < 0 ? left : own;
    at_top = top > 0 ? right : at_top;
    std::int32_t after_top = top < 0 ? own : right;
    after_top = top > 0 ? batch.magnitude[4][i] : after_top;
    const double before = before_top, here = at_top, after = after_top;
    const double curvature = 2 * here - before - after;
    const double divisor = curvature > 0 ? curvature : 1;
    double shift = 0.5 * (after - before) / divisor;
    shift = shift < -0.5 ? -0.5 : shift;
    shift = shift > 0.5 ? 0.5 : shift;
    shift = top + shift;
    shift = curvature > 0 ? shift : 0;
    const double noise = relative_noise * here / divisor;
    const double variance = position_floor * position_floor + noise * noise;
    batch.weight[i] = 1 / (curvature > 0 ? variance : 1);
    const std::int32_t dx = batch.dx[i], dy = batch.dy[i];
    const bool across_columns = (dx < 0 ? -dx : dx) >= (dy < 0 ? -dy : dy);
    batch.place_x[i] = batch.x[i] + (across_columns ? shift : 0);
    batch.place_y[i] = batch.y[i] + (across_columns ? 0 : shift);
  }
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
