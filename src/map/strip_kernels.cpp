// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstdint>

#include "base/kernel_set.hpp"
#include "map/line_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

/// For many pixels what collect_each of refit_recipe.hpp asks of each and adds up; read that first.
void find_inside(const StripRule& strip, StripBatch& batch) noexcept {
  const double px = strip.px, py = strip.py, nx = strip.nx, ny = strip.ny;
  const double width = strip.half_width;
  const double least = strip.cos_max_angle * strip.cos_max_angle;
  const std::int32_t count = batch.count;
  for (std::int32_t i = 0; i < count; ++i) {
    const double gx = batch.dx[i], gy = batch.dy[i];
    const double toward = gx * nx + gy * ny;
    const double x = batch.x[i] - px, y = batch.y[i] - py;
    const double off = x * nx + y * ny;
    std::int64_t inside = toward > 0 ? 1 : 0;
    inside &= toward * toward >= least * (gx * gx + gy * gy) ? 1 : 0;
    inside &= off <= width ? 1 : 0;
    inside &= off >= -width ? 1 : 0;
    batch.inside[i] = inside;
    batch.along[i] = x * -ny + y * nx;
    const double w = batch.weight[i];
    const double wx = w * x, wy = w * y;
    batch.weight_x[i] = wx;
    batch.weight_y[i] = wy;
    batch.weight_xx[i] = wx * x;
    batch.weight_xy[i] = wx * y;
    batch.weight_yy[i] = wy * y;
  }
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
