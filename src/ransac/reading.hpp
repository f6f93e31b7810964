// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "straightedge/plane_gate.hpp"

namespace straightedge::ransac {

/// 1 / gate of a reading with q = 1/z, in metres. The gate of a fixed number of metres along z is q² times as
/// wide in 1/z.
inline float inverse_gate(const PlaneGate& gate, float q) noexcept {
  const double wide = gate.sigmas * gate.inverse_noise(static_cast<double>(q));
  return static_cast<float>(1 / wide);
}

/// 1/z is a number that says something: a finite depth, and one whose gate does not reach infinity.
inline bool is_reading(float q, float inverse_gate) noexcept {
  return q > 0 && q <= 1e6F && inverse_gate <= 1e12F && q * inverse_gate > 1;
}

}  // namespace straightedge::ransac
