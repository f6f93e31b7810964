// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "localize/wall.hpp"
#include "localize/wall_grid.hpp"
#include "straightedge/host/line_map.hpp"
#include "straightedge/host/localize_options.hpp"

namespace straightedge::localize {

/// A ray's first wall.
struct Crossing {
  double distance_m = 0;
  double cosine = 0;  ///< between ray and normal, absolute
};

/// All walls of a map, and a grid that says which are near a place. The map is one that `objection_to` has
/// nothing against.
class WallMap {
 public:
  WallMap(const LineMap& map, const MatchOptions& options);

  const std::vector<Wall>& walls() const { return walls_; }
  /// Of angle and offset of a line.
  std::pair<double, double> variances(std::uint32_t line) const { return variances_[line]; }
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
  double roughness_m_ = 0;
  std::vector<Wall> walls_;
  std::vector<std::pair<double, double>> variances_;
  WallGrid grid_;
};

/// The sentence that says why no robot can be found in the map; null for a sound one.
const char* objection_to(const LineMap& map) noexcept;

}  // namespace straightedge::localize
