// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "base/kernel_set.hpp"

// Each set of kernels has a copy of its own.
namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

/// Sets up to 32 bits from bit n on; the last word must not be the one of bit n.
inline void set_bits(std::uint64_t* words, std::int32_t n, std::uint32_t bits) noexcept {
  const auto shift = static_cast<unsigned>(n) % 64;
  words[n / 64] |= std::uint64_t{bits} << shift;
  words[n / 64 + 1] |= std::uint64_t{bits} >> 1U >> (63 - shift);
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
