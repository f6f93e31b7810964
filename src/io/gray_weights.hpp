// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace straightedge::io {

/// Luma of ITU-R BT.601 in 15-bit integers, rounded: the same bits everywhere.
constexpr std::uint8_t gray_of(std::uint32_t red, std::uint32_t green, std::uint32_t blue) noexcept {
  return static_cast<std::uint8_t>((9798 * red + 19235 * green + 3735 * blue + 16384) >> 15);
}

}  // namespace straightedge::io
