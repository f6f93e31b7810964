// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "straightedge/depth_kernels.hpp"
#include "straightedge/inverse_depth.hpp"

namespace straightedge {

/// Readings of a square of pixels: what their best plane follows from, and for any plane their squared
/// residuals, without looking at the pixels again. Deviations from the means lose nothing in 32 bits.
struct DepthCell {
  float n = 0;                   ///< readings
  float u = 0, v = 0, q = 0;     ///< their means; u and v from the picture's middle
  float uu = 0, uv = 0, vv = 0;  ///< sums of products of deviations from the means
  float uq = 0, vq = 0, qq = 0;
};

/// The sums of a cell's readings, counted from where the middle is at (middle_u, middle_v).
constexpr InverseDepthMoments moments_of(const DepthCell& cell, double middle_u, double middle_v) noexcept {
  const auto number = [](float x) noexcept { return static_cast<double>(x); };
  const double n = number(cell.n), q = number(cell.q);
  const double u = number(cell.u) + middle_u, v = number(cell.v) + middle_v;
  if (!(n > 0)) return {};
  return {n,
          n * u,
          n * v,
          n * u * u + number(cell.uu),
          n * u * v + number(cell.uv),
          n * v * v + number(cell.vv),
          n * q,
          n * u * q + number(cell.uq),
          n * v * q + number(cell.vq),
          n * q * q + number(cell.qq)};
}

constexpr DepthCell cell_at(const DepthCellRows& r) noexcept {
  return {r.first[0],           r.first[r.apart],     r.first[2 * r.apart], r.first[3 * r.apart],
          r.first[4 * r.apart], r.first[5 * r.apart], r.first[6 * r.apart], r.first[7 * r.apart],
          r.first[8 * r.apart], r.first[9 * r.apart]};
}

/// A plane, or a surface that is bent a little, in 32 bits: c + x X + y Y + xx X² + xy X Y + yy Y², X and Y
/// from the picture's middle.
struct DepthSurface {
  float c = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
};

constexpr float value_at(const DepthSurface& s, float u, float v) noexcept {
  return (s.c + s.x * u + s.y * v) + (s.xx * u * u + s.xy * u * v + s.yy * v * v);
}

/// Sum of the squared residuals of a cell's readings from a surface, taken for flat over the cell, 1/metre².
constexpr float squared_residuals(const DepthCell& cell, const DepthSurface& s) noexcept {
  const float a = (s.x + 2 * s.xx * cell.u) + s.xy * cell.v;
  const float b = (s.y + s.xy * cell.u) + 2 * s.yy * cell.v;
  const float r = cell.q - value_at(s, cell.u, cell.v);
  const float mixed = a * cell.uq + b * cell.vq;
  const float square = a * (a * cell.uu + 2 * b * cell.uv) + b * b * cell.vv;
  const float sum = cell.n * r * r + ((cell.qq - 2 * mixed) + square);
  return sum < 0 ? 0 : sum;  // a surface whose residuals are no number fits nothing
}

}  // namespace straightedge
