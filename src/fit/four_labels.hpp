// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstring>

namespace straightedge::detail {

/// Times a label: that label four times.
constexpr std::uint64_t four_ones = 0x0001000100010001;

/// Four labels beside one another as one number: nearly everywhere they are the same.
inline std::uint64_t four(const std::uint16_t* labels) noexcept {
  std::uint64_t together = 0;
  std::memcpy(&together, labels, sizeof together);
  return together;
}

/// The top bits of those that are not 0; none may have that bit.
constexpr std::uint64_t not_zero(std::uint64_t labels) noexcept {
  return (labels + 0x7FFF * four_ones) & (0x8000 * four_ones);
}

/// The lowest bits of four labels.
constexpr std::uint32_t lowest_of(std::uint64_t labels) noexcept {
  // To bits 48 to 51.
  constexpr std::uint64_t together = (1ULL << 48U) | (1ULL << 33U) | (1ULL << 18U) | (1ULL << 3U);
  return static_cast<std::uint32_t>((labels & four_ones) * together >> 48U & 0xFU);
}

}  // namespace straightedge::detail
