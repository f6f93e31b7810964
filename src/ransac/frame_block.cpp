// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/frame_block.hpp"

#include "ransac/fold.hpp"

namespace straightedge::ransac {
namespace {

constexpr std::int32_t lanes = FrameBlock::lanes;

struct LaneSums {
  float n[lanes], u[lanes], uu[lanes], r[lanes], ur[lanes], rr[lanes];
};

void copy_free(const float* pixels, const std::uint16_t* labels, std::int32_t count,
               float* __restrict q) noexcept {
  for (std::int32_t i = 0; i < count; ++i) {
    const float pixel = pixels[i];
    const std::int32_t label = labels[i];
    q[i] = label == 0 ? pixel : 0.0F;
  }
}

/// Squared gates of readings: `constant` in 1/z, or `metres` along z, which are q² times as wide in 1/z,
/// whichever is more.
void limits_of(const float* q, std::int32_t count, float constant, float metres,
               float* __restrict limit) noexcept {
  for (std::int32_t i = 0; i < count; ++i) {
    const float floor = metres * (q[i] * q[i]);
    const float wide = floor > constant ? floor : constant;
    const std::int32_t near_enough = q[i] > wide ? 1 : 0;
    const std::int32_t far_enough = q[i] <= 1e6F ? 1 : 0;
    limit[i] = static_cast<float>(near_enough & far_enough) * (wide * wide);
  }
}

/// 1 where a pixel is within the gate of 1/z = a i + c.
void mark_inside(const FrameBlock& block, float a, float c, std::int32_t* __restrict inside) noexcept {
  const std::int32_t full = (block.count + lanes - 1) / lanes * lanes;
  for (std::int32_t i = 0; i < full; ++i) {
    const float r = block.q[i] - (a * static_cast<float>(i) + c);
    inside[i] = r * r < block.limit[i] ? 1 : 0;
  }
}

}  // namespace

void FrameBlock::load(const Readings& readings, std::int32_t first_column, std::int32_t row,
                      const std::uint16_t* labels) noexcept {
  u0 = first_column;
  v = row;
  const std::int32_t left = readings.frame.width - first_column;
  count = left < capacity ? left : capacity;
  const float* pixels = readings.frame.row(row) + first_column;
  copy_free(pixels, labels, count, q);
  const std::int32_t full = (count + lanes - 1) / lanes * lanes;
  for (std::int32_t i = count; i < full; ++i) q[i] = 0;
  const PlaneGate& gate = readings.gate;
  const double constant = gate.fixed_m > 0 ? 0 : gate.sigmas * gate.inverse_sigma;
  const double metres = gate.fixed_m > 0 ? gate.fixed_m : gate.sigmas * gate.floor_m;
  limits_of(q, full, static_cast<float>(constant), static_cast<float>(metres), limit);
}

std::uint32_t FrameBlock::readings() const noexcept {
  std::uint32_t found = 0;
  for (std::int32_t i = 0; i < count; ++i) found += limit[i] > 0 ? 1U : 0U;
  return found;
}

void FrameBlock::add_inliers(float a, float c, InverseDepthMoments& sums) const noexcept {
  std::int32_t inside[capacity];
  mark_inside(*this, a, c, inside);
  LaneSums s{};
  for (std::int32_t i = 0; i < count; i += lanes) {
    for (std::int32_t l = 0; l < lanes; ++l) {
      const auto u = static_cast<float>(i + l);
      const float r = q[i + l] - (a * u + c);
      const auto m = static_cast<float>(inside[i + l]);
      const float mr = m * r;
      const float mu = m * u;
      s.n[l] += m;
      s.u[l] += mu;
      s.uu[l] += mu * u;
      s.r[l] += mr;
      s.ur[l] += mr * u;
      s.rr[l] += mr * r;
    }
  }
  sums.n += fold(s.n);
  sums.u += fold(s.u);
  sums.uu += fold(s.uu);
  sums.q += fold(s.r);
  sums.uq += fold(s.ur);
  sums.qq += fold(s.rr);
}

std::uint32_t FrameBlock::label_inliers(float a, float c, std::uint16_t label,
                                        std::uint16_t* labels) const noexcept {
  std::int32_t inside[capacity];
  mark_inside(*this, a, c, inside);
  std::int32_t found = 0;
  for (std::int32_t i = 0; i < count; ++i) {
    labels[i] = inside[i] != 0 ? label : labels[i];
    found += inside[i];
  }
  return static_cast<std::uint32_t>(found);
}

}  // namespace straightedge::ransac
