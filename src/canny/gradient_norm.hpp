// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

// The length of one gradient: for the whole-image stage, and for the row forms, whose numbers are as narrow
// as their gradients allow.
namespace straightedge {

constexpr std::int32_t l1_norm(std::int32_t dx, std::int32_t dy) noexcept {
  return (dx < 0 ? -dx : dx) + (dy < 0 ? -dy : dy);
}

/// The square of the length. The one sum of 16-bit squares that leaves 31 bits becomes 2^31 − 1.
constexpr std::int32_t l2_norm(std::int32_t dx, std::int32_t dy) noexcept {
  const auto across = static_cast<std::uint32_t>(dx * dx);
  const auto down = static_cast<std::uint32_t>(dy * dy);
  return static_cast<std::int32_t>(std::min<std::uint32_t>(across + down, INT32_MAX));
}

}  // namespace straightedge
