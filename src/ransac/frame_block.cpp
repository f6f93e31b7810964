// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/frame_block.hpp"

#include <bit>

#include "ransac/fold.hpp"

namespace straightedge::ransac {
namespace {

/// Interleaved partial sums of a block.
constexpr std::int32_t lanes = 16;

/// Half the gate's width in 1/z: `constant`, or `metres` along z, which are q² times as wide in 1/z,
/// whichever is more.
inline float wide_of(float q, float constant, float metres) noexcept {
  const float floor = metres * (q * q);
  return floor > constant ? floor : constant;
}

/// 1 for a reading: above its gate, at most 1e6, and no NaN. The bits of floats from 0 on have the floats'
/// order; those of negative ones are below, those of NaN above.
inline std::int32_t is_above(float q, float wide) noexcept {
  const auto bits = std::bit_cast<std::int32_t>(q);
  return static_cast<std::int32_t>(bits > std::bit_cast<std::int32_t>(wide)) &
         static_cast<std::int32_t>(bits <= std::bit_cast<std::int32_t>(1e6F));
}

/// Which pixels of a block are free and within the gate of 1/z = a i + c, and their residuals; 0 for the
/// others, and for what fills the last lanes up.
struct Inliers {
  float r[FrameBlock::capacity];
  std::int32_t inside[FrameBlock::capacity];

  Inliers(const FrameBlock& block, float a, float c, const std::uint16_t* labels) noexcept {
    const float* q = block.q;
    const float constant = block.constant, metres = block.metres;
    const std::int32_t count = block.count;
    for (std::int32_t i = 0; i < count; ++i) {
      const float wide = wide_of(q[i], constant, metres);
      const float residual = q[i] - (a * static_cast<float>(i) + c);
      const std::int32_t near = residual * residual < wide * wide ? 1 : 0;
      const std::int32_t free = labels[i] == 0 ? 1 : 0;
      inside[i] = -(near & free & is_above(q[i], wide));
      r[i] = std::bit_cast<float>(std::bit_cast<std::int32_t>(residual) & inside[i]);
    }
    for (std::int32_t i = count; i % lanes != 0; ++i) {
      inside[i] = 0;
      r[i] = 0;
    }
  }
};

struct LaneSums {
  float r[lanes], ur[lanes], rr[lanes];

  /// Four neighbouring lanes of all residuals: as many as a plain processor keeps in registers.
  void add_quad(const float* residuals, std::int32_t first, std::int32_t count) noexcept {
    float r0 = 0, r1 = 0, r2 = 0, r3 = 0, ur0 = 0, ur1 = 0, ur2 = 0, ur3 = 0, rr0 = 0, rr1 = 0, rr2 = 0,
          rr3 = 0;
    auto u0 = static_cast<float>(first), u1 = u0 + 1, u2 = u0 + 2, u3 = u0 + 3;
    for (std::int32_t i = first; i < count; i += lanes) {
      const float* e = residuals + i;
      r0 += e[0], r1 += e[1], r2 += e[2], r3 += e[3];
      ur0 += e[0] * u0, ur1 += e[1] * u1, ur2 += e[2] * u2, ur3 += e[3] * u3;
      rr0 += e[0] * e[0], rr1 += e[1] * e[1], rr2 += e[2] * e[2], rr3 += e[3] * e[3];
      u0 += lanes, u1 += lanes, u2 += lanes, u3 += lanes;
    }
    r[first] = r0, r[first + 1] = r1, r[first + 2] = r2, r[first + 3] = r3;
    ur[first] = ur0, ur[first + 1] = ur1, ur[first + 2] = ur2, ur[first + 3] = ur3;
    rr[first] = rr0, rr[first + 1] = rr1, rr[first + 2] = rr2, rr[first + 3] = rr3;
  }
};

}  // namespace

FrameBlock::FrameBlock(const Readings& readings, std::int32_t first_column, std::int32_t row) noexcept
    : q(readings.frame.row(row) + first_column), u0(first_column), v(row) {
  const std::int32_t left = readings.frame.width - first_column;
  count = left < capacity ? left : capacity;
  const PlaneGate& gate = readings.gate;
  constant = static_cast<float>(gate.fixed_m > 0 ? 0 : gate.sigmas * gate.inverse_sigma);
  metres = static_cast<float>(gate.fixed_m > 0 ? gate.fixed_m : gate.sigmas * gate.floor_m);
}

void FrameBlock::limits(float (&limit)[capacity]) const noexcept {
  for (std::int32_t i = 0; i < count; ++i) {
    const float wide = wide_of(q[i], constant, metres);
    const auto squared = std::bit_cast<std::int32_t>(wide * wide);
    limit[i] = std::bit_cast<float>(squared & -is_above(q[i], wide));
  }
}

std::uint32_t FrameBlock::readings(const std::uint16_t* labels) const noexcept {
  std::int32_t found = 0;
  for (std::int32_t i = 0; i < count; ++i) {
    const std::int32_t free = labels[i] == 0 ? 1 : 0;
    found += free & is_above(q[i], wide_of(q[i], constant, metres));
  }
  return static_cast<std::uint32_t>(found);
}

void FrameBlock::add_inliers(float a, float c, const std::uint16_t* labels,
                             InverseDepthMoments& sums) const noexcept {
  const Inliers inliers(*this, a, c, labels);
  LaneSums s;
  for (std::int32_t first = 0; first < lanes; first += 4) s.add_quad(inliers.r, first, count);
  std::int32_t n = 0, u = 0, uu = 0;
  for (std::int32_t i = 0; i < count; ++i) {
    const std::int32_t at = inliers.inside[i] & i;
    n -= inliers.inside[i];
    u += at;
    uu += at * at;
  }
  sums.n += n;
  sums.u += u;
  sums.uu += uu;
  sums.q += fold(s.r);
  sums.uq += fold(s.ur);
  sums.qq += fold(s.rr);
}

std::uint32_t FrameBlock::label_inliers(float a, float c, std::uint16_t label,
                                        std::uint16_t* labels) const noexcept {
  const Inliers inliers(*this, a, c, labels);
  std::int32_t found = 0;
  for (std::int32_t i = 0; i < count; ++i) {
    labels[i] = inliers.inside[i] != 0 ? label : labels[i];
    found -= inliers.inside[i];
  }
  return static_cast<std::uint32_t>(found);
}

}  // namespace straightedge::ransac
