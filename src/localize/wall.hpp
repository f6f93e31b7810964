// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/host/line_map.hpp"

namespace straightedge::localize {

/// A segment of the map, ready to be compared with lines of a scan.
struct Wall {
  double theta = 0, nx = 1, ny = 0;  ///< normal
  double x = 0, y = 0;               ///< the point of its line about which the variances are meant
  double begin = 0, end = 0;         ///< extent along (−ny, nx), from that point
  double var_theta = 0, var_offset = 0;
  FreeSide free = FreeSide::unknown;
  std::uint32_t line = 0;  ///< index of its line; segments of one line share their error
  std::uint32_t line_id = 0, segment_id = 0;

  double across(double px, double py) const { return (px - x) * nx + (py - y) * ny; }
  double along(double px, double py) const { return (py - y) * nx - (px - x) * ny; }
  double x_at(double s) const { return x - s * ny; }
  double y_at(double s) const { return y + s * nx; }
  double length() const { return end - begin; }
  bool open_on(bool plus) const { return free != (plus ? FreeSide::minus : FreeSide::plus); }
};

/// Of the point from the segment.
inline double squared_distance(const Wall& wall, double x, double y) {
  const double s = wall.along(x, y);
  const double past = s < wall.begin ? wall.begin - s : s > wall.end ? s - wall.end : 0;
  const double d = wall.across(x, y);
  return d * d + past * past;
}

}  // namespace straightedge::localize
