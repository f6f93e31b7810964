// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "pixel_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

void rename_row(std::uint16_t* labels, std::int32_t count, const std::uint16_t* by,
                std::int32_t /*names*/) noexcept {
  constexpr std::int32_t at_once = 16;
  std::int32_t x = 0;
  for (; x + at_once <= count; x += at_once) {
    // All are read before any is written: then a processor need not ask whether a name was changed.
    std::uint16_t some[at_once];
    for (std::int32_t i = 0; i < at_once; ++i) some[i] = by[labels[x + i]];
    for (std::int32_t i = 0; i < at_once; ++i) labels[x + i] = some[i];
  }
  for (; x < count; ++x) labels[x] = by[labels[x]];
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
