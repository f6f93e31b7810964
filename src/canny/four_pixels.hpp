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

/// Numbers of four neighbouring pixels in two words, two 16-bit numbers in each: what a processor without
/// vectors can add, and multiply by a small number, two at a time. No number may reach 2^16.
struct FourPixels {
  std::uint32_t even = 0;  ///< pixel 0 in the low half, pixel 2 in the high half
  std::uint32_t odd = 0;   ///< pixels 1 and 3

  static FourPixels load(const std::uint8_t* pixels) noexcept {
    const std::uint32_t word = load_four_bytes(pixels);
    return {word & 0x00FF00FFU, (word >> 8U) & 0x00FF00FFU};
  }

  FourPixels operator+(FourPixels other) const noexcept { return {even + other.even, odd + other.odd}; }
  FourPixels operator*(std::uint32_t factor) const noexcept { return {even * factor, odd * factor}; }

  void store(std::uint16_t* numbers) const noexcept {
    numbers[0] = static_cast<std::uint16_t>(even);
    numbers[1] = static_cast<std::uint16_t>(odd);
    numbers[2] = static_cast<std::uint16_t>(even >> 16U);
    numbers[3] = static_cast<std::uint16_t>(odd >> 16U);
  }

 private:
  static void put(std::uint16_t* number, std::uint32_t value) noexcept {
    const auto low = static_cast<std::uint16_t>(value);
    std::memcpy(number, &low, sizeof low);
  }
};

}  // namespace straightedge
