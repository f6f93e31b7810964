// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace straightedge::hough {

/// The numbers that OpenCV's HoughLinesP draws: multiply with carry, always from the same state.
/// G. Marsaglia's method; here only to reproduce its results.
class OpencvGenerator {
 public:
  std::uint32_t next() noexcept {
    state_ = (state_ & 0xFFFFFFFFU) * std::uint64_t{4164903690U} + (state_ >> 32U);
    return static_cast<std::uint32_t>(state_);
  }

 private:
  std::uint64_t state_ = ~std::uint64_t{0};
};

}  // namespace straightedge::hough
