// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/hough_accumulator.hpp"

namespace straightedge {

void HoughAccumulator::fill(HoughCells kind) noexcept {
  directions_.fill(kind);
  clear(1);
}

void HoughAccumulator::clear(double step_m) noexcept {
  for (std::uint32_t& cell : votes_) cell = 0;
  step_m_ = step_m;
  per_step_ = 1 / step_m;
}

}  // namespace straightedge
