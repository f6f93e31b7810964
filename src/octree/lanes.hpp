// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

#include "base/lowest_bit.hpp"

namespace straightedge::octree {

inline constexpr bool little_endian = std::endian::native == std::endian::little;

/// The lanes for which a comparison of eight numbers of 16 bits holds, one after another.
class Lanes {
 public:
  template <class Mask>
  explicit Lanes(const Mask& mask) noexcept {
    static_assert(sizeof(mask) == sizeof(halves_));
    std::memcpy(halves_, &mask, sizeof(halves_));
  }

  bool any() const noexcept { return (halves_[0] | halves_[1]) != 0; }
  /// The lowest that is left; there must be one.
  std::uint32_t take() noexcept {
    const std::uint32_t half = halves_[0] != 0 ? 0 : 1;
    const std::uint32_t at = little_endian ? detail::lowest_bit(halves_[half])
                                           : static_cast<std::uint32_t>(std::countl_zero(halves_[half]));
    constexpr std::uint64_t one = (std::uint64_t{1} << bits) - 1;
    halves_[half] &= ~(little_endian ? one << at : one << (64 - bits - at));
    return at / bits + 64 / bits * half;
  }

 private:
  static constexpr std::uint32_t bits = 16;

  std::uint64_t halves_[2];
};

}  // namespace straightedge::octree
