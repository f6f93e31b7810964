// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

namespace straightedge::detail {

/// Where the lowest bit is of a number that is not 0. Processors of 32 bits would need a library for the
/// whole.
constexpr std::uint32_t lowest_bit(std::uint64_t bits) noexcept {
  if constexpr (sizeof(std::size_t) == sizeof bits) return static_cast<std::uint32_t>(std::countr_zero(bits));
  const auto low = static_cast<std::uint32_t>(bits), high = static_cast<std::uint32_t>(bits >> 32U);
  return static_cast<std::uint32_t>(low != 0 ? std::countr_zero(low) : 32 + std::countr_zero(high));
}

}  // namespace straightedge::detail
