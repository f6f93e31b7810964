// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "canny/magnitude_row.hpp"
#include "canny/row_kernels.hpp"

namespace straightedge::plain {

void magnitude_l1(const std::int16_t* dx, const std::int16_t* dy, std::uint16_t* magnitude,
                  std::int32_t width) noexcept {
  l1_row(dx, dy, magnitude, width);
}

void magnitude_l2(const std::int16_t* dx, const std::int16_t* dy, std::uint32_t* magnitude,
                  std::int32_t width) noexcept {
  l2_row(dx, dy, magnitude, width);
}

}  // namespace straightedge::plain
