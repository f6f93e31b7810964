// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>

namespace straightedge::ransac {

/// 1/z of a pixel; 0 for raw depth 0, by a division without a branch around it. As inverse_depth_image.
inline float inverse_of(float q, float /*scale*/) noexcept {
  return q;
}
inline float inverse_of(std::uint16_t raw, float scale) noexcept {
  const std::int32_t units = raw;
  const std::int32_t missing = units == 0 ? 1 : 0;
  return scale * static_cast<float>(1 - missing) / static_cast<float>(units + missing);
}

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

}  // namespace straightedge::ransac
