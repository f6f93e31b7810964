// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "io/image_placement.hpp"
#include "straightedge/host/map_file.hpp"

namespace straightedge {
namespace {

void move_line(MapLine& line, const io::Similarity& world, double yaw) {
  // theta_w = theta + yaw, rho_w = s·rho + C·n(theta_w).
  const double theta = wrap_angle(line.theta + yaw);
  const double rho = world.scale * line.rho + dot(line_normal(theta), {world.x, world.y});
  const NormalForm form = normalise_line(rho, theta);
  line.rho = form.rho;
  line.theta = form.theta;
  if (form.flipped) line.free = flip(line.free);

  for (MapSegment& segment : line.segments) {
    const Point2 first = world(first_end(segment));
    const Point2 second = world(second_end(segment));
    segment.x0 = first.x;
    segment.y0 = first.y;
    segment.x1 = second.x;
    segment.y1 = second.y;
    if (form.flipped) swap_ends(segment);
  }
  if (line.width) line.width = *line.width * world.scale;
  // About a point of the line itself, angle and offset stay independent under turn and shift.
  if (line.covariance) {
    const Point2 at = world({line.covariance->at_x, line.covariance->at_y});
    line.covariance->at_x = at.x;
    line.covariance->at_y = at.y;
    line.covariance->var_offset *= world.scale * world.scale;
  }
}

}  // namespace

Result<LineMap> to_metres(const LineMap& map) {
  if (const auto breaches = check_line_map(map); !breaches.empty()) {
    return Failure{Problem::bad_option, "the map breaks a rule of its format: " + breaches.front().sentence};
  }
  if (map.unit == MapUnit::metre) return map;
  if (!map.image || !map.image->placement) {
    return Failure{Problem::bad_content,
                   "the map does not say how many metres a pixel is, so it stays in pixels"};
  }
  const MapPlacement& placement = *map.image->placement;
  const io::Similarity world = io::world_from_centre(placement, map.image->size);
  LineMap metres = map;
  metres.unit = MapUnit::metre;
  for (MapLine& line : metres.lines) move_line(line, world, placement.origin_yaw);
  if (const auto breaches = check_line_map(metres); !breaches.empty()) {
    return Failure{Problem::bad_content,
                   "the map's resolution and origin are beyond what numbers hold in metres: " +
                       breaches.front().sentence};
  }
  return metres;
}

}  // namespace straightedge
