// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "straightedge/host/line_map.hpp"
#include "straightedge/trigonometry.hpp"

/// The few formulas that all who handle lines of a map share: normal form, direction, order of ends,
/// distance. Sine and arc tangent are the library's own, so the bits are the same everywhere.
namespace straightedge {

struct Point2 {
  double x = 0;
  double y = 0;

  bool operator==(const Point2&) const = default;
};

constexpr double dot(Point2 a, Point2 b) noexcept {
  return a.x * b.x + a.y * b.y;
}

/// n(theta) = (cos theta, sin theta).
constexpr Point2 line_normal(double theta) noexcept {
  const SineCosine turn = sine_cosine(theta);
  return {turn.cosine, turn.sine};
}

/// t(theta) = (−sin theta, cos theta), the direction along which the ends of segments are ordered.
constexpr Point2 line_direction(double theta) noexcept {
  const SineCosine turn = sine_cosine(theta);
  return {-turn.sine, turn.cosine};
}

/// A line x cos theta + y sin theta = rho whose sign was chosen.
struct NormalForm {
  double rho = 0;
  double theta = 0;
  bool flipped = false;  ///< the normal points the other way than the one that was given
};

/// rho >= 0 and −pi < theta <= pi; for rho = 0, −pi/2 < theta <= pi/2.
constexpr bool is_normal_form(double rho, double theta) noexcept {
  const double limit = rho == 0 ? pi / 2 : pi;
  return rho >= 0 && theta > -limit && theta <= limit;
}

/// The one form of (rho, theta), (−rho, theta + pi) and their turns that keeps the rules of the map.
/// For |theta| < 1e6.
constexpr NormalForm normalise_line(double rho, double theta) noexcept {
  theta = wrap_angle(theta);
  const bool flip = rho < 0 || (rho == 0 && !(theta > -pi / 2 && theta <= pi / 2));
  if (!flip) return {rho, theta, false};
  theta = theta > 0 ? theta - pi : theta + pi;
  if (theta <= -pi) theta = pi;
  return {rho == 0 ? 0.0 : -rho, theta, true};
}

/// The line through two different points, its normal form; the points may come in any order.
constexpr NormalForm line_through(Point2 a, Point2 b) noexcept {
  const double theta = arc_tangent(a.x - b.x, b.y - a.y);
  const Point2 normal = line_normal(theta);
  return normalise_line(0.5 * (dot(normal, a) + dot(normal, b)), theta);
}

/// Positive on the side to which the normal points.
constexpr double signed_distance(Point2 point, double rho, double theta) noexcept {
  return dot(line_normal(theta), point) - rho;
}

/// The line's point that is nearest to `point`.
constexpr Point2 project_on_line(Point2 point, double rho, double theta) noexcept {
  const Point2 normal = line_normal(theta);
  const double distance = dot(normal, point) - rho;
  return {point.x - distance * normal.x, point.y - distance * normal.y};
}

constexpr Point2 first_end(const MapSegment& segment) noexcept {
  return {segment.x0, segment.y0};
}
constexpr Point2 second_end(const MapSegment& segment) noexcept {
  return {segment.x1, segment.y1};
}

/// How far the second end lies ahead of the first one along t(theta): the length, negative when the ends
/// are in the wrong order.
constexpr double length_along(const MapSegment& segment, double theta) noexcept {
  return dot(line_direction(theta), {segment.x1 - segment.x0, segment.y1 - segment.y0});
}

constexpr void swap_ends(MapSegment& segment) noexcept {
  std::swap(segment.x0, segment.x1);
  std::swap(segment.y0, segment.y1);
}

/// Puts the ends in the order of the map's rule.
constexpr void order_ends(MapSegment& segment, double theta) noexcept {
  if (length_along(segment, theta) < 0) swap_ends(segment);
}

/// The same side, told from a normal that points the other way.
constexpr FreeSide flip(FreeSide side) noexcept {
  if (side == FreeSide::plus) return FreeSide::minus;
  if (side == FreeSide::minus) return FreeSide::plus;
  return side;
}

/// From the image plane (u right, v down, pixel (c, r) covers [c, c+1] x [r, r+1]) to the map frame of the
/// image: origin at its centre, x right, y up.
constexpr Point2 centre_from_image(Point2 uv, Size size) noexcept {
  return {uv.x - 0.5 * size.width, 0.5 * size.height - uv.y};
}

constexpr Point2 image_from_centre(Point2 xy, Size size) noexcept {
  return {xy.x + 0.5 * size.width, 0.5 * size.height - xy.y};
}

}  // namespace straightedge
