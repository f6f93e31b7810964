// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

namespace straightedge {

/// The first byte is the lowest, on every machine.
inline std::uint32_t load_four_bytes(const std::uint8_t* bytes) noexcept {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes, sizeof word);
  if constexpr (std::endian::native == std::endian::big) word = __builtin_bswap32(word);
  return word;
}

/// Sums of four neighbouring pixels, each at most 2^16 − 1, for processors without vectors: a product of four
/// pixels with a number is one multiplication.
///
/// All four bytes of a word times a number need 40 bits, and the four products overlap. The same with every
/// other byte masked out needs 32, and its two products do not. The difference of both is the other two.
struct FourSums {
  std::uint64_t all = 0;   ///< p0 + 2^8 p1 + 2^16 p2 + 2^24 p3
  std::uint32_t even = 0;  ///< p0 + 2^16 p2

  void add(std::uint32_t pixels, std::uint32_t factor) noexcept {
    all += std::uint64_t{pixels} * factor;
    even += (pixels & 0x00FF00FFU) * factor;
  }
  /// The same for two times four pixels.
  void add(std::uint32_t pixels, std::uint32_t others, std::uint32_t factor) noexcept {
    all += std::uint64_t{pixels} * factor + std::uint64_t{others} * factor;
    even += ((pixels & 0x00FF00FFU) + (others & 0x00FF00FFU)) * factor;
  }

  void store(std::uint16_t* numbers) const noexcept {
    const auto odd = static_cast<std::uint32_t>((all - even) >> 8U);
    numbers[0] = static_cast<std::uint16_t>(even);
    numbers[1] = static_cast<std::uint16_t>(odd);
    numbers[2] = static_cast<std::uint16_t>(even >> 16U);
    numbers[3] = static_cast<std::uint16_t>(odd >> 16U);
  }
  void add_to(std::uint16_t* numbers) const noexcept {
    const auto odd = static_cast<std::uint32_t>((all - even) >> 8U);
    numbers[0] = static_cast<std::uint16_t>(numbers[0] + even);
    numbers[1] = static_cast<std::uint16_t>(numbers[1] + odd);
    numbers[2] = static_cast<std::uint16_t>(numbers[2] + (even >> 16U));
    numbers[3] = static_cast<std::uint16_t>(numbers[3] + (odd >> 16U));
  }
};

}  // namespace straightedge
