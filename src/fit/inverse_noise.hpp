// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "straightedge/plane_gate.hpp"

namespace straightedge {

/// Standard deviation of 1/z where 1/z is q. A fixed threshold in metres is `sigmas` deviations of z, and
/// d(1/z) = q² dz.
constexpr double inverse_noise(const PlaneGate& gate, double q) noexcept {
  return gate.fixed_m > 0 ? gate.fixed_m / gate.sigmas * q * q : gate.inverse_sigma;
}

}  // namespace straightedge
