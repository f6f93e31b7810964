// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "localize/wall_map.hpp"

#include <algorithm>
#include <cmath>

#include "straightedge/trigonometry.hpp"

namespace straightedge::localize {
namespace {

constexpr double open_end_m = 0.1;
constexpr double no_covariance_pixels = 0.5;  // offset of lines that carry no covariance
constexpr double no_covariance_m = 0.02;      // and at least
constexpr double farthest_m = 1e8;            // from the origin; any projection of the earth fits
constexpr double widest_m = 1e5;

Wall wall_of(const MapLine& line, const MapSegment& segment, std::uint32_t index) {
  Wall wall;
  const SineCosine normal = sine_cosine(line.theta);
  wall.theta = line.theta;
  wall.nx = normal.cosine;
  wall.ny = normal.sine;
  wall.x = line.covariance ? line.covariance->at_x : 0.5 * (segment.x0 + segment.x1);
  wall.y = line.covariance ? line.covariance->at_y : 0.5 * (segment.y0 + segment.y1);
  // The covariance's point may lie a rounding beside the line.
  const double off = wall.x * wall.nx + wall.y * wall.ny - line.rho;
  wall.x -= off * wall.nx;
  wall.y -= off * wall.ny;
  const double s0 = wall.along(segment.x0, segment.y0), s1 = wall.along(segment.x1, segment.y1);
  wall.begin = std::min(s0, s1);
  wall.end = std::max(s0, s1);
  wall.free = line.free;
  wall.line = index;
  wall.line_id = line.id;
  wall.segment_id = segment.id;
  return wall;
}

void set_variances(Wall& wall, const MapLine& line, double pixel_m, const MatchOptions& options) {
  const double offset = std::max(no_covariance_m, no_covariance_pixels * pixel_m);
  const double angle = offset / std::max(offset, wall.length());
  wall.var_theta = line.covariance ? line.covariance->var_theta : angle * angle;
  wall.var_offset = line.covariance ? line.covariance->var_offset : offset * offset;
  wall.var_theta += options.wall_angle_floor_rad * options.wall_angle_floor_rad;
  wall.var_offset += options.wall_offset_floor_m * options.wall_offset_floor_m;
}

std::vector<Wall> walls_of(const LineMap& map, const MatchOptions& options, double pixel_m) {
  std::vector<Wall> walls;
  for (std::uint32_t i = 0; i < map.lines.size(); ++i) {
    for (const MapSegment& segment : map.lines[i].segments) {
      walls.push_back(wall_of(map.lines[i], segment, i));
      set_variances(walls.back(), map.lines[i], pixel_m, options);
    }
  }
  return walls;
}

double pixel_of(const LineMap& map) {
  return map.image && map.image->placement ? map.image->placement->resolution : 0;
}

bool within(double value, double least, double most) {
  return value >= least && value <= most;
}

bool sound(const MapLine& line) {
  const double f = farthest_m;
  for (const MapSegment& s : line.segments) {
    if (!within(s.x0, -f, f) || !within(s.y0, -f, f) || !within(s.x1, -f, f) || !within(s.y1, -f, f))
      return false;
  }
  if (!within(line.rho, -f, f) || !within(line.theta, -10, 10)) return false;
  if (!line.covariance) return true;
  const LineCovariance& c = *line.covariance;
  return within(c.at_x, -f, f) && within(c.at_y, -f, f) && within(c.var_theta, 0, 1e6) &&
         within(c.var_offset, 0, 1e12);
}

}  // namespace

const char* objection_to(const LineMap& map) noexcept {
  if (map.unit != MapUnit::metre)
    return "the map is in pixels; a robot needs it in metres, with a resolution";
  double left = 1e300, right = -1e300, bottom = 1e300, top = -1e300;
  for (const MapLine& line : map.lines) {
    if (!sound(line)) return "the map has numbers that are not finite or far too large";
    for (const MapSegment& s : line.segments) {
      left = std::min({left, s.x0, s.x1});
      right = std::max({right, s.x0, s.x1});
      bottom = std::min({bottom, s.y0, s.y1});
      top = std::max({top, s.y0, s.y1});
    }
  }
  if (!(left <= right)) return "the map has no walls to find a robot by";
  if (right - left > widest_m || top - bottom > widest_m) return "the map spans more than 100 km";
  return nullptr;
}

WallMap::WallMap(const LineMap& map, const MatchOptions& options)
    : roughness_m_(options.wall_roughness_pixels * pixel_of(map)),
      walls_(walls_of(map, options, pixel_of(map))),
      variances_(map.lines.size()),
      grid_(walls_, reach_m) {
  for (const Wall& wall : walls_) variances_[wall.line] = {wall.var_theta, wall.var_offset};
}

double WallMap::distance(double x, double y, double limit) const {
  double best = limit * limit;
  for (const std::uint32_t i : grid_.at(x, y)) best = std::min(best, squared_distance(walls_[i], x, y));
  return std::sqrt(best);
}

std::optional<Crossing> WallMap::first_crossing(double x, double y, double dx, double dy,
                                                double limit) const {
  std::optional<Crossing> found;
  double best = limit;
  grid_.walk(x, y, dx, dy, limit, [&](std::span<const std::uint32_t> near, double leave) {
    for (const std::uint32_t i : near) {
      const Wall& wall = walls_[i];
      const double way = wall.nx * dx + wall.ny * dy;
      if (std::fabs(way) < 1e-9) continue;
      const double s = -wall.across(x, y) / way;
      if (!(s > 0 && s < best)) continue;
      const double at = wall.along(x + s * dx, y + s * dy);
      if (at < wall.begin + open_end_m || at > wall.end - open_end_m) continue;
      best = s;
      found = Crossing{s, std::fabs(way)};
    }
    return leave < best;
  });
  return found;
}

}  // namespace straightedge::localize
