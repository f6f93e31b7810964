// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <bit>

#include "ransac/kernels.hpp"
#include "ransac/pixel_gate.hpp"
#include "ransac/quad.hpp"

namespace straightedge::plain {
namespace {

constexpr std::int32_t lanes = ransac_lanes;
/// Pixels that are looked at in one go; a multiple of the lanes.
constexpr std::int32_t chunk = 64;

/// Pixels from `first` on: whether they are inliers, and their residuals. 0 for the others, and for what
/// fills the last lanes up.
template <class Q>
struct Inliers {
  float r[chunk];
  std::int32_t inside[chunk];
  std::int32_t count, readings = 0, n = 0;

  Inliers(const RansacPixels<Q>& row, std::int32_t first) noexcept {
    count = row.count - first < chunk ? row.count - first : chunk;
    const Q* const pixels = row.pixels + first;
    const float scale = row.scale, a = row.a, c = row.c, constant = row.constant, metres = row.metres;
    for (std::int32_t i = 0; i < count; ++i) {
      const float q = ransac::inverse_of(pixels[i], scale);
      const float wide = ransac::wide_of(q, constant, metres);
      const float residual = q - (a * static_cast<float>(first + i) + c);
      const float away = std::bit_cast<float>(std::bit_cast<std::int32_t>(residual) & 0x7FFFFFFF);
      const std::int32_t reading = -ransac::is_above(q, wide);
      inside[i] = away < wide ? reading : 0;
      readings -= reading;
      n -= inside[i];
      r[i] = std::bit_cast<float>(std::bit_cast<std::int32_t>(residual) & inside[i]);
    }
    if (row.labels != nullptr) leave_out(row, first);
    for (std::int32_t i = count; i % lanes != 0; ++i) {
      inside[i] = 0;
      r[i] = 0;
    }
  }
  void leave_out(const RansacPixels<Q>& row, std::int32_t first) noexcept {
    readings = n = 0;
    for (std::int32_t i = 0; i < count; ++i) {
      const float q = ransac::inverse_of(row.pixels[first + i], row.scale);
      const std::int32_t free = row.labels[first + i] == 0 ? -1 : 0;
      readings -= free & -ransac::is_above(q, ransac::wide_of(q, row.constant, row.metres));
      inside[i] &= free;
      n -= inside[i];
      r[i] = std::bit_cast<float>(std::bit_cast<std::int32_t>(r[i]) & free);
    }
  }
};

struct LaneSums {
  float r[lanes] = {}, ur[lanes] = {}, rr[lanes] = {};

  void add(const float* residuals, std::int32_t count, std::int32_t first) noexcept {
    for (std::int32_t l = 0; l < lanes; l += 4) add_quad(residuals, count, first, l);
  }
  void add_quad(const float* residuals, std::int32_t count, std::int32_t first, std::int32_t l) noexcept {
    Quad some_r, some_ur, some_rr;
    some_r.load(r + l);
    some_ur.load(ur + l);
    some_rr.load(rr + l);
    const auto u0 = static_cast<float>(first + l);
    float u[4] = {u0, u0 + 1, u0 + 2, u0 + 3};
    for (std::int32_t i = l; i < count; i += lanes) {
      const float* const e = residuals + i;
      some_r.add(e);
      some_ur.add(u, e);
      some_rr.add(e, e);
      for (float& at : u) at += lanes;
    }
    some_r.store(r + l);
    some_ur.store(ur + l);
    some_rr.store(rr + l);
  }
};

template <class Q>
RansacPixelSums sum(const RansacPixels<Q>& row) noexcept {
  LaneSums lane;
  std::int32_t readings = 0, n = 0, u = 0, uu = 0;
  for (std::int32_t first = 0; first < row.count; first += chunk) {
    const Inliers<Q> inliers(row, first);
    readings += inliers.readings;
    n += inliers.n;
    if (inliers.n == 0) continue;
    lane.add(inliers.r, inliers.count, first);
    for (std::int32_t i = 0; i < inliers.count; ++i) {
      const std::int32_t at = inliers.inside[i] & (first + i);
      u += at;
      uu += at * at;
    }
  }
  return {static_cast<std::uint32_t>(readings),
          static_cast<std::uint32_t>(n),
          static_cast<std::uint32_t>(u),
          static_cast<std::uint32_t>(uu),
          fold(lane.r),
          fold(lane.ur),
          fold(lane.rr)};
}

template <class Q>
std::uint32_t count(const RansacPixels<Q>& row) noexcept {
  std::int32_t n = 0;
  for (std::int32_t first = 0; first < row.count; first += chunk) n += Inliers<Q>(row, first).n;
  return static_cast<std::uint32_t>(n);
}

}  // namespace

RansacPixelSums sum_inverse_pixels(const RansacPixels<float>& row) noexcept {
  return sum(row);
}

std::uint32_t count_inverse_pixels(const RansacPixels<float>& row) noexcept {
  return count(row);
}

RansacPixelSums sum_raw_pixels(const RansacPixels<std::uint16_t>& row) noexcept {
  return sum(row);
}

std::uint32_t count_raw_pixels(const RansacPixels<std::uint16_t>& row) noexcept {
  return count(row);
}

}  // namespace straightedge::plain
