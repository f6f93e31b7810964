// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <bit>

#include "ransac/kernels.hpp"

namespace straightedge::plain {
namespace {

constexpr std::int32_t lanes = ransac_lanes;

/// Sixteen points: coordinates from the origin and residuals, 0 for those that are no inliers.
struct Group {
  float x[lanes], y[lanes], r[lanes];
  std::int32_t readings = 0, inside = 0;

  Group(const RansacPoints& p, std::int32_t first) noexcept {
    const std::int32_t count = p.count - first < lanes ? p.count - first : lanes;
    const std::ptrdiff_t at = first * p.step;
    const float *px = p.x + at, *py = p.y + at, *pz = p.z + at;
    const std::uint16_t* const labels = p.labels == nullptr ? nullptr : p.labels + first;
    if (p.step == 1 && count == lanes) {
      look<lanes>(p, px, py, pz, labels, 1, lanes);
    } else {
      look<0>(p, px, py, pz, labels, p.step, count);
    }
  }

  /// Whole: the count where it is known beforehand.
  template <std::int32_t Whole>
  void look(const RansacPoints& p, const float* px, const float* py, const float* pz,
            const std::uint16_t* labels, std::ptrdiff_t step, std::int32_t some) noexcept {
    const std::int32_t count = Whole > 0 ? Whole : some;
    const RansacCoefficients k = p.plane;
    const float ox = p.origin_x, oy = p.origin_y, oz = p.origin_z, gate = p.gate;
    for (std::int32_t l = 0; l < count; ++l) {
      const std::ptrdiff_t at = Whole > 0 ? l : l * step;
      const float cx = px[at], cy = py[at], cz = pz[at];
      const float dx = cx - ox, dy = cy - oy;
      const float e = (k.x * dx + k.y * dy) + (k.z * (cz - oz) + k.w);
      const float away = std::bit_cast<float>(std::bit_cast<std::int32_t>(e) & 0x7FFFFFFF);
      // A difference from itself is 0 for finite numbers alone.
      const std::int32_t free = labels == nullptr || labels[l] == 0 ? -1 : 0;
      const std::int32_t finite = ((cx - cx) + (cy - cy)) + (cz - cz) == 0 ? free : 0;
      const std::int32_t in = away < gate ? finite : 0;
      x[l] = std::bit_cast<float>(std::bit_cast<std::int32_t>(dx) & in);
      y[l] = std::bit_cast<float>(std::bit_cast<std::int32_t>(dy) & in);
      r[l] = std::bit_cast<float>(std::bit_cast<std::int32_t>(e) & in);
      readings -= finite;
      inside -= in;
    }
    for (std::int32_t l = count; l < lanes; ++l) x[l] = y[l] = r[l] = 0;
  }
};

void add(float (&sums)[lanes], const float (&a)[lanes], const float (&b)[lanes]) noexcept {
  for (std::int32_t l = 0; l < lanes; ++l) sums[l] += a[l] * b[l];
}

void add(float (&sums)[lanes], const float (&a)[lanes]) noexcept {
  for (std::int32_t l = 0; l < lanes; ++l) sums[l] += a[l];
}

float fold(float (&sums)[lanes]) noexcept {
  for (std::int32_t half = lanes / 2; half > 0; half /= 2)
    for (std::int32_t l = 0; l < half; ++l) sums[l] += sums[l + half];
  return sums[0];
}

}  // namespace

RansacPointSums sum_points(const RansacPoints& points) noexcept {
  float x[lanes] = {}, y[lanes] = {}, xx[lanes] = {}, xy[lanes] = {}, yy[lanes] = {}, r[lanes] = {},
        xr[lanes] = {}, yr[lanes] = {}, rr[lanes] = {};
  std::int32_t readings = 0, n = 0;
  for (std::int32_t first = 0; first < points.count; first += lanes) {
    const Group g(points, first);
    readings += g.readings;
    n += g.inside;
    if (g.inside == 0) continue;
    add(x, g.x);
    add(y, g.y);
    add(xx, g.x, g.x);
    add(xy, g.x, g.y);
    add(yy, g.y, g.y);
    add(r, g.r);
    add(xr, g.x, g.r);
    add(yr, g.y, g.r);
    add(rr, g.r, g.r);
  }
  return {static_cast<std::uint32_t>(readings),
          static_cast<std::uint32_t>(n),
          fold(x),
          fold(y),
          fold(xx),
          fold(xy),
          fold(yy),
          fold(r),
          fold(xr),
          fold(yr),
          fold(rr)};
}

std::uint32_t count_points(const RansacPoints& points) noexcept {
  std::int32_t n = 0;
  for (std::int32_t first = 0; first < points.count; first += lanes) n += Group(points, first).inside;
  return static_cast<std::uint32_t>(n);
}

}  // namespace straightedge::plain
