// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "map/picture_rows.hpp"
#include "straightedge/line_fit.hpp"

namespace straightedge {

/// Adds pixel i of the batch, which find_inside found inside.
inline void add(const StripBatch& batch, std::int32_t i, LineMoments& moments) noexcept {
  moments.weight += batch.weight[i];
  moments.x += batch.weight_x[i];
  moments.y += batch.weight_y[i];
  moments.xx += batch.weight_xx[i];
  moments.xy += batch.weight_xy[i];
  moments.yy += batch.weight_yy[i];
  moments.count += 1;
}

}  // namespace straightedge
