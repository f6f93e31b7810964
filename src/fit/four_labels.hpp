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

}  // namespace straightedge::detail
