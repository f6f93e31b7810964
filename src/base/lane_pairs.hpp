// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "base/lanes.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

/// The first ones and the second ones of pairs beside one another.
struct Pairs {
  Lanes first, second;

  explicit Pairs(const float* from) noexcept {
#if STRAIGHTEDGE_LANES == 16
    const Lanes a = load(from), b = load(from + lanes);
    first = __builtin_shufflevector(a, b, 0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30);
    second = __builtin_shufflevector(a, b, 1, 3, 5, 7, 9, 11, 13, 15, 17, 19, 21, 23, 25, 27, 29, 31);
#elif STRAIGHTEDGE_LANES == 8
    const Lanes a = load(from), b = load(from + lanes);
    first = __builtin_shufflevector(a, b, 0, 2, 4, 6, 8, 10, 12, 14);
    second = __builtin_shufflevector(a, b, 1, 3, 5, 7, 9, 11, 13, 15);
#elif STRAIGHTEDGE_LANES == 4
    const Lanes a = load(from), b = load(from + lanes);
    first = __builtin_shufflevector(a, b, 0, 2, 4, 6);
    second = __builtin_shufflevector(a, b, 1, 3, 5, 7);
#else
    first = from[0];
    second = from[1];
#endif
  }
  Lanes sum() const noexcept {
    return first + second;
  }
};

}  // namespace
}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
