// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "cli/explain_legend.hpp"
#include "straightedge/host/image.hpp"
#include "straightedge/host/line_geometry.hpp"

namespace straightedge::cli {

/// The range of one axis, with its name in small letters.
struct ChartAxis {
  double low = 0, high = 1;
  std::string name;
};

/// White paper with two axes, for a picture of numbers.
class Chart {
 public:
  static constexpr std::int32_t left = 84, right = 24, top = 40, bottom = 58;

  Chart(Size body, ChartAxis across, ChartAxis upwards);

  /// Where a pair of numbers stands in the picture.
  Point2 place(double x, double y) const;
  Image<Rgb>& picture() { return picture_; }
  Size body() const { return body_; }

 private:
  void draw_axes();

  Size body_;
  ChartAxis across_, upwards_;
  Image<Rgb> picture_;
};

}  // namespace straightedge::cli
