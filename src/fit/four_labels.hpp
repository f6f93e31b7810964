// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstring>
#include <span>

namespace straightedge::detail {

/// Times a label: that label four times.
constexpr std::uint64_t four_ones = 0x0001000100010001;

/// Four labels beside one another as one number: nearly everywhere they are the same.
inline std::uint64_t four(const std::uint16_t* labels) noexcept {
  std::uint64_t together = 0;
  std::memcpy(&together, labels, sizeof together);
  return together;
}

/// Takes bits off all labels.
inline void clear_bits(std::span<std::uint16_t> labels, std::uint16_t bits) noexcept {
  for (std::uint16_t& label : labels) label = static_cast<std::uint16_t>(label & ~bits);
}

/// Four bits as four labels: 65535 or 0.
constexpr std::uint64_t masks_of(std::uint32_t bits) noexcept {
  constexpr std::uint64_t apart = 1ULL | (1ULL << 15U) | (1ULL << 30U) | (1ULL << 45U);
  return ((bits & 0xFU) * apart & four_ones) * 0xFFFFU;
}

/// Writes those of sixteen labels whose bits are set, of the first `count`. Without a branch for each: along
/// borders nobody can foresee them.
inline void write_some(const std::uint16_t* labels, std::uint32_t bits, std::int32_t count,
                       std::uint16_t* to) noexcept {
  const std::int32_t most = count < 16 ? count : 16;
  std::int32_t i = 0;
  for (; i + 4 <= most; i += 4) {
    const std::uint64_t masks = masks_of(bits >> static_cast<std::uint32_t>(i));
    const std::uint64_t both = (four(to + i) & ~masks) | (four(labels + i) & masks);
    std::memcpy(to + i, &both, sizeof both);
  }
  for (; i < most; ++i) to[i] = (bits >> static_cast<std::uint32_t>(i) & 1U) != 0 ? labels[i] : to[i];
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
