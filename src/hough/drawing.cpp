// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "hough/drawing.hpp"

#include <bit>

namespace straightedge::hough {

/// Who is drawn changes places with the last of those not drawn.
template <class Below>
void Drawing::draw_some(const Below& below) noexcept {
  const PixelStates states = states_;
  PixelPlace* const points = points_;
  std::uint32_t left = not_drawn_;
  const std::uint32_t end = left < ahead ? 0 : left - ahead;
  for (; left > end; --left) {
    PixelPlace& drawn = points[below(left)];
    PixelPlace& last = points[left - 1];
    const auto pixel = std::bit_cast<std::uint32_t>(drawn);
    drawn = last;
    last = std::bit_cast<PixelPlace>(pixel);
    states.expect(last.x, last.y);
  }
  not_drawn_ = end;
}

void Drawing::draw() noexcept {
  if (as_opencv_) {
    draw_some([random = &opencv_](std::uint32_t count) noexcept { return random->next() % count; });
  } else {
    Pcg32 random = pcg_;
    draw_some([&random](std::uint32_t count) noexcept { return random.below(count); });
    pcg_ = random;
  }
}

}  // namespace straightedge::hough
