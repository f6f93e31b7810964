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

/// Up to four labels beside one another; those that are missing are like one that is there.
inline std::uint64_t up_to_four(const std::uint16_t* labels, std::int32_t count) noexcept {
  if (count == 4) return four(labels);
  if (count == 2) {
    std::uint32_t two = 0;
    std::memcpy(&two, labels, sizeof two);
    return two | std::uint64_t{two} << 32U;
  }
  std::uint64_t together = *labels * four_ones;
  for (std::int32_t i = 1; i < count; ++i) {
    together &= ~(std::uint64_t{0xFFFF} << (16 * i));
    together |= std::uint64_t{labels[i]} << (16 * i);
  }
  return together;
}

/// Writes one label, up to four times.
inline void set_up_to_four(std::uint16_t* labels, std::int32_t count, std::uint16_t label) noexcept {
  const std::uint64_t together = label * four_ones;
  if (count == 4) {
    std::memcpy(labels, &together, sizeof together);
    return;
  }
  for (std::int32_t i = 0; i < count; ++i) labels[i] = label;
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
