// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hough/gradient_window.hpp"
#include "straightedge/hough_options.hpp"
#include "straightedge/image.hpp"

namespace straightedge::hough {

/// x * cosine + y * sine = rho, from the first pixel's centre.
struct ExactLine {
  double cosine = 1;
  double sine = 0;
  double rho = 0;
};

/// The pixels near a line, step by step along its longer axis.
class StripWalk {
 public:
  StripWalk(Size size, const ExactLine& line, double half_width) noexcept
      : flat_(line.sine * line.sine >= line.cosine * line.cosine),
        steps_(flat_ ? size.width : size.height),
        last_across_((flat_ ? size.height : size.width) - 1) {
    const double major = flat_ ? line.sine : line.cosine;
    start_ = line.rho / major;
    slope_ = -(flat_ ? line.cosine : line.sine) / major;
    step_length_ = 1 / (major < 0 ? -major : major);
    reach_ = half_width * step_length_;
  }

  std::int32_t steps() const noexcept { return steps_; }
  double step_length() const noexcept { return step_length_; }
  double centre(std::int32_t step) const noexcept { return start_ + slope_ * step; }

  std::int32_t low(std::int32_t step) const noexcept {
    const double edge = centre(step) - reach_;
    if (edge <= 0) return 0;
    if (edge > last_across_) return last_across_ + 1;
    const auto below = static_cast<std::int32_t>(edge);
    return below < edge ? below + 1 : below;
  }
  std::int32_t high(std::int32_t step) const noexcept {
    const double edge = centre(step) + reach_;
    if (edge < 0) return -1;
    return edge >= last_across_ ? last_across_ : static_cast<std::int32_t>(edge);
  }

  std::int32_t x(std::int32_t step, std::int32_t across) const noexcept { return flat_ ? step : across; }
  std::int32_t y(std::int32_t step, std::int32_t across) const noexcept { return flat_ ? across : step; }
  std::int32_t step_of(std::int32_t x, std::int32_t y) const noexcept { return flat_ ? x : y; }

 private:
  bool flat_;
  std::int32_t steps_;
  std::int32_t last_across_;
  double start_ = 0;
  double slope_ = 0;
  double step_length_ = 1;
  double reach_ = 0;
};

/// Whether so many empty steps are more than the gap allowed; a thousandth of a pixel is not, so that a hole
/// of ten pixels along a row is ten pixels long also for a line that is nearly level.
inline bool too_long_a_gap(const StripWalk& walk, std::int32_t empty_steps, double max_gap) noexcept {
  return empty_steps * walk.step_length() > max_gap + 1e-3;
}

/// A piece of a line between two carried steps.
struct Piece {
  std::int32_t first_step = 0, first_across = 0;
  std::int32_t last_step = 0, last_across = 0;
  std::int32_t carried = 0;  ///< steps
  std::int32_t pixels = 0;
};

/// The edge pixels of one step: how many, and the one nearest to the line.
struct Support {
  std::int32_t pixels = 0;
  std::int32_t across = 0;
};

inline Support support_at(GrayView edges, const StripWalk& walk, const DirectionTest& fits,
                          std::int32_t step) noexcept {
  Support support;
  double nearest = 0;
  const double centre = walk.centre(step);
  const std::int32_t high = walk.high(step);
  for (std::int32_t across = walk.low(step); across <= high; ++across) {
    const std::int32_t x = walk.x(step, across);
    const std::int32_t y = walk.y(step, across);
    if (edges.at(x, y) == 0 || !fits(x, y)) continue;
    const double distance = across < centre ? centre - across : across - centre;
    if (support.pixels == 0 || distance < nearest) {
      support.across = across;
      nearest = distance;
    }
    ++support.pixels;
  }
  return support;
}

/// Long enough, and carried in enough of its steps.
inline bool worth_keeping(const Piece& piece, double min_length, double min_support) noexcept {
  const std::int32_t steps = piece.last_step - piece.first_step + 1;
  if (piece.carried < min_support * steps) return false;
  const double along = piece.last_step - piece.first_step;
  const double across = piece.last_across - piece.first_across;
  return along * along + across * across >= min_length * min_length;
}

/// Calls `emit(piece)` for each piece of the line; stops and returns false when it does.
template <class Emit>
bool for_each_piece(GrayView edges, const StripWalk& walk, const DirectionTest& fits, double max_gap,
                    Emit emit) noexcept {
  Piece piece;
  for (std::int32_t step = 0; step < walk.steps(); ++step) {
    const Support support = support_at(edges, walk, fits, step);
    if (support.pixels == 0) continue;
    if (piece.pixels > 0 && too_long_a_gap(walk, step - piece.last_step - 1, max_gap)) {
      if (!emit(piece)) return false;
      piece.pixels = 0;
    }
    if (piece.pixels == 0) piece = {step, support.across, step, support.across, 0, 0};
    piece.last_step = step;
    piece.last_across = support.across;
    ++piece.carried;
    piece.pixels += support.pixels;
  }
  return piece.pixels == 0 || emit(piece);
}

inline HoughSegment segment_of(const StripWalk& walk, const Piece& piece, std::int32_t votes) noexcept {
  return {walk.x(piece.first_step, piece.first_across),
          walk.y(piece.first_step, piece.first_across),
          walk.x(piece.last_step, piece.last_across),
          walk.y(piece.last_step, piece.last_across),
          votes,
          piece.pixels};
}

}  // namespace straightedge::hough
