// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "straightedge/image.hpp"
#include "straightedge/suppress.hpp"

// Hysteresis in place, with a worklist of any size.
//
// A pixel above the thresholds is weak, pending or traced. Pending is an edge whose neighbours have not been
// looked at, so a strong pixel is pending from the start, and a weak one becomes so when it is reached while
// the worklist is full.
//   1. Sweep over the rows. A pending pixel is a seed: it becomes traced and goes onto the worklist.
//   2. Take a pixel from the worklist. Each weak neighbour becomes traced and goes onto the worklist, or
//      pending if that is full. Until it is empty.
//   3. Sweep again over the rows in which the sweep left pixels pending, until there are none.
// A further sweep is needed only if the worklist was full, so each but the last traces as many pixels as the
// worklist holds, or more: at most 1 + edges / worklist sweeps. What is reached does not depend on the order.
namespace straightedge {

inline constexpr std::uint8_t pending_edge = strong_edge;
inline constexpr std::uint8_t traced_edge = 3;

/// `Classes` is where the pixels' states are kept: `set(x, y, state)`; `weak_of_three(x, y)`, whose bits 0,
/// weak_step and 2 weak_step say whether pixels x − 1, x, x + 1 are weak; and `next_pending(x, y)`, the first
/// pending pixel of row y at or right of x, or the width.
template <class Classes>
class BoundedFill {
 public:
  /// Gives back how many weak pixels became edges.
  static std::uint32_t run(const Classes& classes, Size size, std::span<std::uint32_t> worklist) noexcept {
    BoundedFill fill(classes, size, worklist);
    return fill.sweep();
  }

 private:
  BoundedFill(const Classes& classes, Size size, std::span<std::uint32_t> worklist) noexcept
      : classes_(classes), size_(size), worklist_(worklist) {}

  // Steps 1 and 3.
  std::uint32_t sweep() noexcept {
    std::int32_t first = 0;
    sweep_end_ = size_.height;
    while (first < sweep_end_) {
      left_begin_ = size_.height;
      left_end_ = 0;
      for (sweep_y_ = first; sweep_y_ < sweep_end_; ++sweep_y_) sweep_row();
      first = left_begin_;
      sweep_end_ = left_end_;
    }
    return reached_;
  }

  // Step 1.
  void sweep_row() noexcept {
    const std::int32_t y = sweep_y_;
    for (std::int32_t x = classes_.next_pending(0, y); x < size_.width; x = classes_.next_pending(x + 1, y)) {
      trace(x, y);
      empty_worklist();
    }
  }

  void trace(std::int32_t x, std::int32_t y) noexcept {
    classes_.set(x, y, traced_edge);
    const auto index = static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width);
    worklist_[waiting_++] = static_cast<std::uint32_t>(index + static_cast<std::size_t>(x));
  }

  // Step 2.
  void empty_worklist() noexcept {
    const auto width = static_cast<std::uint32_t>(size_.width);
    while (waiting_ > 0) {
      const std::uint32_t index = worklist_[--waiting_];
      const auto y = static_cast<std::int32_t>(index / width);
      look_around(static_cast<std::int32_t>(index - static_cast<std::uint32_t>(y) * width), y);
    }
  }

  void look_around(std::int32_t x, std::int32_t y) noexcept {
    const std::int32_t top = std::max<std::int32_t>(y - 1, 0), bottom = std::min(y + 1, size_.height - 1);
    for (std::int32_t v = top; v <= bottom; ++v) {
      std::uint32_t weak = classes_.weak_of_three(x, v);
      for (std::int32_t u = x - 1; weak != 0; ++u, weak >>= Classes::weak_step) {
        if ((weak & 1U) != 0) reach(u, v);
      }
    }
  }

  void reach(std::int32_t x, std::int32_t y) noexcept {
    ++reached_;
    if (waiting_ < worklist_.size()) return trace(x, y);
    classes_.set(x, y, pending_edge);
    if (y > sweep_y_ && y < sweep_end_) return;  // this sweep will come by
    left_begin_ = std::min(left_begin_, y);
    left_end_ = std::max(left_end_, y + 1);
  }

  Classes classes_;
  Size size_;
  std::span<std::uint32_t> worklist_;
  std::size_t waiting_ = 0;
  std::uint32_t reached_ = 0;
  std::int32_t sweep_y_ = 0;
  std::int32_t sweep_end_ = 0;
  std::int32_t left_begin_ = 0;  ///< the rows with pixels that this sweep leaves pending
  std::int32_t left_end_ = 0;
};

}  // namespace straightedge
