// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "hough/corridor.hpp"
#include "map/edge_bits.hpp"
#include "map/pixel_gradient.hpp"

/// What step 2 of edge_follower.hpp goes by. A step is a column, of steep edges a row; pixels lie across.
namespace straightedge::walking {

inline constexpr double beside = 2.2;  ///< pixels from the line; what belongs to the same edge: its staircase

/// Numbers with a fraction of sixteen bits.
inline constexpr int fraction_bits = 16;
inline constexpr std::int64_t one = std::int64_t{1} << fraction_bits;
inline std::int64_t fixed(double value) {
  return static_cast<std::int64_t>(value * one);
}

/// A corridor as it is walked along, in the numbers above.
struct Course {
  std::int64_t from, next;     ///< where across one begins to look, and how far that moves with each step
  std::int64_t inside;         ///< from there to the corridor
  std::uint64_t inside_width;  ///< of the corridor
  std::int64_t step_length;    ///< along the line
  std::int32_t width;          ///< pixels across that are looked at

  std::int32_t first(std::int32_t k) const noexcept {
    return static_cast<std::int32_t>((from + k * next) >> fraction_bits);
  }
  /// How many of the steps lie in a picture that has so many places across.
  std::int32_t steps_in(std::int32_t places, std::int32_t steps) const noexcept {
    const auto is_in = [&](std::int32_t k) { return first(k) < places && first(k) + width > 0; };
    if (steps <= 0 || !is_in(0)) return 0;
    while (!is_in(steps - 1)) --steps;
    return steps;
  }
};

inline Course course_of(const refitting::Corridor& strip, bool steep, std::int32_t step,
                        std::int32_t direction) {
  const double along_normal = steep ? strip.nx : strip.ny, aside = steep ? strip.ny : strip.nx;
  const double first = steep ? strip.py : strip.px, across = steep ? strip.px : strip.py;
  const double slope = -aside / along_normal, step_length = 1 / std::fabs(along_normal);
  const std::int64_t reach = fixed(beside * step_length), inside = fixed(strip.half_width * step_length);
  const std::int64_t to_next_pixel = one - 1;
  return {.from = fixed(across + (step - first) * slope) - reach + to_next_pixel,
          .next = fixed(direction * slope),
          .inside = reach - to_next_pixel - inside,
          .inside_width = static_cast<std::uint64_t>(2 * inside),
          .step_length = fixed(step_length),
          .width = static_cast<std::int32_t>((2 * reach + one) / one)};
}

/// Edges and gradients along a way, step by step.
template <bool steep, class Gradients>
class EdgesAlong {
 public:
  EdgesAlong(const BitLinesView& edges, const Gradients& gradients, std::int32_t step, std::int32_t direction)
      : line_(edges.line(step)),
        next_words_(direction * static_cast<std::ptrdiff_t>(edges.words_in_line)),
        gradients_(gradients),
        here_(step * (steep ? gradients.row() : 1)),
        next_(direction * (steep ? gradients.row() : 1)),
        across_(steep ? 1 : gradients.row()) {}
  void go_on() {
    words_ += next_words_;
    here_ += next_;
  }
  std::uint64_t edges(std::int32_t from, std::int32_t count) const {
    return EdgeBits::part(line_ + words_, from, count);
  }
  PixelGradient gradient(std::int32_t place) const { return gradients_.at(here_ + place * across_); }
  void fetch(std::int32_t steps, std::int32_t place) const {
    gradients_.fetch(here_ + steps * next_ + place * across_);
  }

 private:
  const std::uint64_t* line_;
  std::ptrdiff_t words_ = 0, next_words_;
  Gradients gradients_;
  std::ptrdiff_t here_, next_, across_;
};

}  // namespace straightedge::walking
