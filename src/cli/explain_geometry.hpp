// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "straightedge/host/line_geometry.hpp"
#include "straightedge/hough_options.hpp"

namespace straightedge::cli {

/// The part of a line that crosses the picture, in columns and rows; the centre of the first pixel is (0, 0).
struct Chord {
  Point2 from;
  Point2 to;
};

/// None when the line misses the picture.
std::optional<Chord> chord_of(const HoughPeak& line, Size size);

double distance_to(const HoughPeak& line, Point2 point);

}  // namespace straightedge::cli
