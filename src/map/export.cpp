// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/export.hpp"

#include <algorithm>
#include <utility>

#include "straightedge/trigonometry.hpp"

namespace straightedge {
namespace {

struct Point {
  double x = 0, y = 0;
};

Point centre_frame(double column, double row, Size image) {
  return {column + 0.5 - 0.5 * image.width, 0.5 * image.height - row - 0.5};
}

/// Polar parameters in normal form; true when the normal had to be turned round.
bool normal_form(double nx, double ny, Point on_line, MapLine& out) {
  double theta = arc_tangent(ny, nx);
  double rho = nx * on_line.x + ny * on_line.y;
  const bool turn = rho < 0 || (rho == 0 && (theta <= -pi / 2 || theta > pi / 2));
  if (turn) {
    rho = rho == 0 ? 0 : -rho;
    theta = theta > 0 ? theta - pi : theta + pi;
  }
  out.rho = rho;
  out.theta = theta;
  return turn;
}

/// The point of the map line nearest to p: ends lie on the line to the last bit that rho, theta allow.
Point onto(const MapLine& line, Point p) {
  const SineCosine n = sine_cosine(line.theta);
  const double off = p.x * n.cosine + p.y * n.sine - line.rho;
  return {p.x - off * n.cosine, p.y - off * n.sine};
}

FreeSide free_side(bool plus, bool minus) {
  return plus && minus ? FreeSide::both : plus ? FreeSide::plus : minus ? FreeSide::minus : FreeSide::unknown;
}

MapSegment segment_of(const MapLine& line, const WallLine& wall, Size image) {
  const Point a = onto(line, centre_frame(wall.x_at(wall.begin), wall.y_at(wall.begin), image));
  const Point b = onto(line, centre_frame(wall.x_at(wall.end), wall.y_at(wall.end), image));
  const SineCosine n = sine_cosine(line.theta);
  MapSegment segment;
  const bool forward = (b.x - a.x) * -n.sine + (b.y - a.y) * n.cosine > 0;
  const Point& first = forward ? a : b;
  const Point& last = forward ? b : a;
  segment.x0 = first.x;
  segment.y0 = first.y;
  segment.x1 = last.x;
  segment.y1 = last.y;
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

MapLine map_line_of(const std::vector<WallLine>& lines, const std::vector<std::size_t>& group, Size image,
                    const LineFloor& floor) {
  const WallLine& first = lines[group.front()];
  MapLine out;
  const Point centroid = centre_frame(first.fit.centroid_x, first.fit.centroid_y, image);
  const bool turned = normal_form(first.nx, -first.ny, centroid, out);
  LineFit fit = first.fit;
  add_floor(fit, extent_of(lines, group), floor);
  const Point at = onto(out, centroid);
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
  if (turned) std::swap(plus, minus);
  out.free = free_side(plus, minus);
  out.votes = votes;
  out.count = count;
  if (first.axis) out.width = width / length;
  return out;
}

}  // namespace

std::vector<MapLine> to_map_lines(const std::vector<WallLine>& lines,
                                  const std::vector<std::vector<std::size_t>>& groups, Size image,
                                  const LineFloor& floor) {
  std::vector<MapLine> out;
  std::uint32_t segment_id = 0;
  for (const std::vector<std::size_t>& group : groups) {
    MapLine line = map_line_of(lines, group, image, floor);
    line.id = static_cast<std::uint32_t>(out.size());
    for (MapSegment& segment : line.segments) segment.id = segment_id++;
    out.push_back(std::move(line));
  }
  return out;
}

}  // namespace straightedge
