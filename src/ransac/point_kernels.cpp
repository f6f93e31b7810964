// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <bit>

#include "ransac/kernels.hpp"
#include "ransac/quad.hpp"

namespace straightedge::plain {
namespace {

constexpr std::int32_t lanes = ransac_lanes;
/// Points that are looked at in one go; a multiple of the lanes.
constexpr std::int32_t chunk = 32;

float only(float number, std::int32_t mask) noexcept {
  return std::bit_cast<float>(std::bit_cast<std::int32_t>(number) & mask);
}

/// Points from `first` on: coordinates from the origin and residuals, 0 for those that are no inliers and for
/// what fills the last lanes up.
struct Inliers {
  float x[chunk], y[chunk], r[chunk];
  std::int32_t count, readings = 0, inside = 0;

  Inliers(const RansacPoints& p, std::int32_t first) noexcept
      : count(p.count - first < chunk ? p.count - first : chunk) {
    const std::uint16_t* const labels = p.labels == nullptr ? nullptr : p.labels + first;
    const std::ptrdiff_t at = first * p.step;
    const float *px = p.x + at, *py = p.y + at, *pz = p.z + at;
    if (p.step == 1 && labels == nullptr) {
      look<true>(p, px, py, pz, [](std::int32_t) { return -1; });
    } else {
      look<false>(p, px, py, pz,
                  [&](std::int32_t i) { return labels == nullptr || labels[i] == 0 ? -1 : 0; });
    }
    for (std::int32_t i = count; i % lanes != 0; ++i) x[i] = y[i] = r[i] = 0;
  }

  /// Contiguous: nothing lies between the points.
  template <bool Contiguous, class Free>
  void look(const RansacPoints& p, const float* px, const float* py, const float* pz, Free free) noexcept {
    const std::ptrdiff_t step = Contiguous ? 1 : p.step;
    const std::int32_t some = count;
    std::int32_t all_readings = 0, all_inside = 0;
    const RansacCoefficients k = p.plane;
    const float ox = p.origin_x, oy = p.origin_y, oz = p.origin_z, gate = p.gate;
    for (std::int32_t i = 0; i < some; ++i) {
      const float cx = px[i * step], cy = py[i * step], cz = pz[i * step];
      const float dx = cx - ox, dy = cy - oy;
      const float e = (k.x * dx + k.y * dy) + (k.z * (cz - oz) + k.w);
      // A difference from itself is 0 for finite numbers alone.
      const std::int32_t reading = ((cx - cx) + (cy - cy)) + (cz - cz) == 0 ? free(i) : 0;
      const std::int32_t in = only(e, 0x7FFFFFFF) < gate ? reading : 0;
      x[i] = only(dx, in);
      y[i] = only(dy, in);
      r[i] = only(e, in);
      all_readings -= reading;
      all_inside -= in;
    }
    readings = all_readings;
    inside = all_inside;
  }
};

struct LaneSums {
  float of[9][lanes] = {};

  void add_quad(const Inliers& in, std::int32_t l) noexcept {
    Quad x, y, xx, xy, yy, r, xr, yr, rr;
    Quad* const all[] = {&x, &y, &xx, &xy, &yy, &r, &xr, &yr, &rr};
    for (int k = 0; k < 9; ++k) all[k]->load(of[k] + l);
    for (std::int32_t i = l; i < in.count; i += lanes) {
      const float *px = in.x + i, *py = in.y + i, *e = in.r + i;
      x.add(px);
      y.add(py);
      xx.add(px, px);
      xy.add(px, py);
      yy.add(py, py);
      r.add(e);
      xr.add(px, e);
      yr.add(py, e);
      rr.add(e, e);
    }
    for (int k = 0; k < 9; ++k) all[k]->store(of[k] + l);
  }
};

}  // namespace

RansacPointSums sum_points(const RansacPoints& points) noexcept {
  LaneSums sums;
  std::int32_t readings = 0, n = 0;
  for (std::int32_t first = 0; first < points.count; first += chunk) {
    const Inliers inliers(points, first);
    readings += inliers.readings;
    n += inliers.inside;
    if (inliers.inside == 0) continue;
    for (std::int32_t l = 0; l < lanes; l += 4) sums.add_quad(inliers, l);
  }
  auto& of = sums.of;
  const auto seen = static_cast<std::uint32_t>(readings), found = static_cast<std::uint32_t>(n);
  return {seen,        found,       fold(of[0]), fold(of[1]), fold(of[2]), fold(of[3]),
          fold(of[4]), fold(of[5]), fold(of[6]), fold(of[7]), fold(of[8])};
}

std::uint32_t count_points(const RansacPoints& points) noexcept {
  std::int32_t n = 0;
  for (std::int32_t first = 0; first < points.count; first += chunk) n += Inliers(points, first).inside;
  return static_cast<std::uint32_t>(n);
}

}  // namespace straightedge::plain
