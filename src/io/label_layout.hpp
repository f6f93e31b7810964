// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "io/svg_canvas.hpp"
#include "straightedge/trigonometry.hpp"

namespace straightedge::io {

/// Finds places for labels of a drawing so that no two overlap: who asks first is nearest to where it wants
/// to be.
class LabelLayout {
 public:
  /// No label leaves this box.
  explicit LabelLayout(const Bounds& paper) : paper_(paper) {}

  /// The middle of the label: at `wanted` or on one of the rings round it, 11 units apart; none when
  /// all of these are taken.
  std::optional<Point2> place(Point2 wanted, double width, double height, int rings) {
    constexpr double gap = 11;
    for (int ring = 0; ring <= rings; ++ring) {
      const int places = ring == 0 ? 1 : 8 * ring;
      for (int k = 0; k < places; ++k) {
        const SineCosine turn = sine_cosine(k * 2 * pi / places);
        const Point2 at{wanted.x + ring * gap * turn.cosine, wanted.y + ring * gap * turn.sine};
        const Bounds box{at.x - width / 2, at.y - height / 2, at.x + width / 2, at.y + height / 2};
        if (!free(box)) continue;
        taken_.push_back(box);
        return at;
      }
    }
    return std::nullopt;
  }

 private:
  bool free(const Bounds& box) const noexcept {
    if (box.left < paper_.left || box.right > paper_.right || box.bottom < paper_.bottom ||
        box.top > paper_.top)
      return false;
    for (const Bounds& other : taken_) {
      const bool apart = box.right <= other.left || other.right <= box.left || box.top <= other.bottom ||
                         other.top <= box.bottom;
      if (!apart) return false;
    }
    return true;
  }

  Bounds paper_;
  std::vector<Bounds> taken_;
};

}  // namespace straightedge::io
