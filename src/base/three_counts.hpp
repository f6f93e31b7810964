// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "base/lanes.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

/// Three whole numbers in one float, so that one addition counts all three: exactly, as long as the sums of
/// the first and the second stay below the next one's place, and all below 2^24.
template <std::int32_t second_place, std::int32_t third_place>
struct ThreeCounts {
  Wholes all;

  static constexpr float of(std::int32_t first, std::int32_t second, std::int32_t third) noexcept {
    return static_cast<float>(first + (second << second_place) + (third << third_place));
  }
  explicit ThreeCounts(const Lanes& sums) noexcept : all(in_wholes(sums)) {}
  Wholes first() const noexcept { return all & ((1 << second_place) - 1); }
  Wholes second() const noexcept { return all >> second_place & ((1 << (third_place - second_place)) - 1); }
  Wholes third() const noexcept { return all >> third_place; }
};

}  // namespace
}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
