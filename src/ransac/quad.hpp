// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/ransac_kernels.hpp"

namespace straightedge::plain {
namespace {

/// Four neighbouring partial sums, as many floats as a plain processor's register holds. Named, because
/// compilers keep the elements of arrays in memory.
struct Quad {
  float a = 0, b = 0, c = 0, d = 0;

  void add(const float* x) noexcept {
    a += x[0];
    b += x[1];
    c += x[2];
    d += x[3];
  }
  void add(const float* x, const float* y) noexcept {
    a += x[0] * y[0];
    b += x[1] * y[1];
    c += x[2] * y[2];
    d += x[3] * y[3];
  }
  void store(float* sums) const noexcept {
    sums[0] = a;
    sums[1] = b;
    sums[2] = c;
    sums[3] = d;
  }
  void load(const float* sums) noexcept {
    a = sums[0];
    b = sums[1];
    c = sums[2];
    d = sums[3];
  }
};

/// The sixteen partial sums added up, 8 apart, 4, 2, 1.
inline float fold(float (&sums)[ransac_lanes]) noexcept {
  for (std::uint32_t half = ransac_lanes / 2; half > 0; half /= 2)
    for (std::uint32_t l = 0; l < half; ++l) sums[l] += sums[l + half];
  return sums[0];
}

}  // namespace
}  // namespace straightedge::plain
