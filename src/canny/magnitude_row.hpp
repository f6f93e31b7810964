// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

// The length of the gradients of one row, for the whole-image stage and for the row forms, whose numbers are
// as narrow as their gradients allow.
namespace straightedge {

template <class Out>
void l1_row(const std::int16_t* dx, const std::int16_t* dy, Out* out, std::int32_t width) noexcept {
  for (std::int32_t x = 0; x < width; ++x) {
    const std::int32_t across = dx[x] < 0 ? -dx[x] : dx[x];
    const std::int32_t down = dy[x] < 0 ? -dy[x] : dy[x];
    out[x] = static_cast<Out>(across + down);
  }
}

template <class Out>
void l2_row(const std::int16_t* dx, const std::int16_t* dy, Out* out, std::int32_t width) noexcept {
  for (std::int32_t x = 0; x < width; ++x) {
    const auto across = static_cast<std::uint32_t>(dx[x] * dx[x]);
    const auto down = static_cast<std::uint32_t>(dy[x] * dy[x]);
    out[x] = static_cast<Out>(std::min<std::uint32_t>(across + down, INT32_MAX));
  }
}

}  // namespace straightedge
