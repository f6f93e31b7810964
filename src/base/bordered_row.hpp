// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/border.hpp"

namespace straightedge {

/// Fills the margins of a row of `margin + width + margin` elements whose middle is there, so that a
/// filter can run over it without asking where the image ends.
template <class T>
void fill_margins(T* row, std::int32_t width, std::int32_t margin, Border border) noexcept {
  T* const middle = row + margin;
  for (std::int32_t i = 1; i <= margin; ++i) {
    const std::int32_t left = border_index(-i, width, border);
    const std::int32_t right = border_index(width - 1 + i, width, border);
    middle[-i] = left == border_zero ? T{0} : middle[left];
    middle[width - 1 + i] = right == border_zero ? T{0} : middle[right];
  }
}

}  // namespace straightedge
