// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/export.hpp"

#include <algorithm>
#include <utility>

#include "map/line_floor.hpp"
#include "straightedge/host/line_geometry.hpp"
#include "straightedge/trigonometry.hpp"

namespace straightedge {
namespace {

/// The point of the picture in the map's frame.
Point2 centre_frame(double column, double row, Size image) {
  return centre_from_image({column + 0.5, row + 0.5}, image);
}

FreeSide free_side(bool plus, bool minus) {
  return plus && minus ? FreeSide::both : plus ? FreeSide::plus : minus ? FreeSide::minus : FreeSide::unknown;
}

MapSegment segment_of(const MapLine& line, const WallLine& wall, Size image) {
  const Point2 a = project_on_line(centre_frame(wall.x_at(wall.begin), wall.y_at(wall.begin), image),
                                   line.rho, line.theta);
  const Point2 b =
      project_on_line(centre_frame(wall.x_at(wall.end), wall.y_at(wall.end), image), line.rho, line.theta);
  MapSegment segment;
  segment.x0 = a.x;
  segment.y0 = a.y;
  segment.x1 = b.x;
  segment.y1 = b.y;
  order_ends(segment, line.theta);
  segment.pixels = wall.pixels;
  return segment;
}

/// Length from the first end to the last one of all segments.
double extent_of(const std::vector<WallLine>& lines, const std::vector<std::size_t>& group) {
  const WallLine& first = lines[group.front()];
  double begin = first.begin, end = first.end;
  for (const std::size_t i : group) {
    for (const double s : {lines[i].begin, lines[i].end}) {
      const double t = first.along(lines[i].x_at(s), lines[i].y_at(s));
      begin = std::min(begin, t);
      end = std::max(end, t);
    }
  }
  return end - begin;
}

MapLine map_line_of(const std::vector<WallLine>& lines, const std::vector<std::size_t>& group,
                    const PictureFacts& picture, Size image) {
  const WallLine& first = lines[group.front()];
  MapLine out;
  const Point2 centroid = centre_frame(first.fit.centroid_x, first.fit.centroid_y, image);
  const Point2 normal{first.nx, -first.ny};  // rows count downwards
  const NormalForm form = normalise_line(dot(normal, centroid), arc_tangent(normal.y, normal.x));
  out.rho = form.rho;
  out.theta = form.theta;
  LineFit fit = first.fit;
  add_floor(fit, extent_of(lines, group), line_floor(picture, first));
  const Point2 at = project_on_line(centroid, out.rho, out.theta);
  out.covariance = LineCovariance{at.x, at.y, fit.var_theta, fit.var_offset};
  std::uint32_t votes = 0, count = 0;
  double width = 0, length = 0;
  bool plus = false, minus = false;
  for (const std::size_t i : group) {
    const WallLine& wall = lines[i];
    const bool same_way = wall.nx * first.nx + wall.ny * first.ny > 0;
    plus |= same_way ? wall.free_plus : wall.free_minus;
    minus |= same_way ? wall.free_minus : wall.free_plus;
    votes += wall.votes;
    count += wall.count;
    width += wall.width * wall.length();
    length += wall.length();
    out.segments.push_back(segment_of(out, wall, image));
  }
  out.free = form.flipped ? free_side(minus, plus) : free_side(plus, minus);
  out.votes = votes;
  out.count = count;
  if (first.axis) out.width = width / length;
  return out;
}

}  // namespace

std::vector<MapLine> to_map_lines(const std::vector<WallLine>& lines,
                                  const std::vector<std::vector<std::size_t>>& groups,
                                  const PictureFacts& picture, Size image) {
  std::vector<MapLine> out;
  std::uint32_t segment_id = 0;
  for (const std::vector<std::size_t>& group : groups) {
    MapLine line = map_line_of(lines, group, picture, image);
    line.id = static_cast<std::uint32_t>(out.size());
    for (MapSegment& segment : line.segments) segment.id = segment_id++;
    out.push_back(std::move(line));
  }
  return out;
}

}  // namespace straightedge
