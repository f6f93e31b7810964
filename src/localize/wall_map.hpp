// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "straightedge/host/line_map.hpp"
#include "straightedge/host/localize_options.hpp"

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
  double length() const { return end - begin; }
  bool open_on(bool plus) const { return free != (plus ? FreeSide::minus : FreeSide::plus); }
};

/// A ray's first wall.
struct Crossing {
  double distance_m = 0;
  double cosine = 0;  ///< between ray and normal, absolute
};

/// All walls of a map, and a grid that says which are near a place.
class WallMap {
 public:
  WallMap(const LineMap& map, const MatchOptions& options);

  const std::vector<Wall>& walls() const { return walls_; }
  std::uint32_t lines() const { return lines_; }
  /// Errors of the walls' course, beside their covariance: a drawing's walls step by pixels.
  double roughness_m() const { return roughness_m_; }
  /// The largest distance that `distance` finds.
  static constexpr double reach_m = 1.0;

  /// To the nearest wall, at most `limit` (<= reach_m), else `limit`.
  double distance(double x, double y, double limit) const;

  /// Along the unit vector (dx, dy), up to `limit`. Walls count without the last 10 cm of their ends, so that
  /// a corner that is not quite closed or drawn past its end stops no ray.
  std::optional<Crossing> first_crossing(double x, double y, double dx, double dy, double limit) const;

 private:
  void build_grid();
  void rasterise(std::vector<std::vector<std::uint32_t>>& cells) const;

  std::vector<Wall> walls_;
  std::uint32_t lines_ = 0;
  double roughness_m_ = 0;
  double cell_ = 1, left_ = 0, bottom_ = 0;
  int columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> starts_, items_;  // walls of cell i: items_[starts_[i] .. starts_[i + 1])
};

}  // namespace straightedge::localize
