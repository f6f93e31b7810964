// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/hough_accumulator.hpp"

namespace straightedge {

void HoughAccumulator::fill(HoughCells kind) noexcept {
  directions_.fill(kind);
  for (bool& used : used_) used = true;
  clear(1);
}

void HoughAccumulator::clear(double step_m) noexcept {
  const auto distances = static_cast<std::size_t>(distances_);
  for (std::size_t direction = 0; direction < used_.size(); ++direction) {
    if (!used_[direction]) continue;
    for (std::uint32_t& cell : votes_.subspan(direction * distances, distances)) cell = 0;
    used_[direction] = false;
  }
  step_m_ = step_m;
  per_step_ = 1 / step_m;
}

}  // namespace straightedge
