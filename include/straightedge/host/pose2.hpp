// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "straightedge/trigonometry.hpp"

namespace straightedge {

/// Where a robot (or its laser) stands on the floor: its x axis points along `heading_rad`, counter-clockwise
/// from the x axis of the frame that it stands in.
struct Pose2 {
  double x_m = 0;
  double y_m = 0;
  double heading_rad = 0;

  constexpr bool operator==(const Pose2&) const noexcept = default;
};

/// a_from_c = compose(a_from_b, b_from_c); the heading comes out in (−pi, pi].
constexpr Pose2 compose(const Pose2& a, const Pose2& b) noexcept {
  const SineCosine turn = sine_cosine(a.heading_rad);
  return {a.x_m + turn.cosine * b.x_m - turn.sine * b.y_m, a.y_m + turn.sine * b.x_m + turn.cosine * b.y_m,
          wrap_angle(a.heading_rad + b.heading_rad)};
}

constexpr Pose2 inverse(const Pose2& a) noexcept {
  const SineCosine turn = sine_cosine(a.heading_rad);
  return {-(turn.cosine * a.x_m + turn.sine * a.y_m), turn.sine * a.x_m - turn.cosine * a.y_m,
          wrap_angle(-a.heading_rad)};
}

/// The motion that leads from one pose to the other, in the frame of the first.
constexpr Pose2 motion_between(const Pose2& from, const Pose2& to) noexcept {
  return compose(inverse(from), to);
}

/// All three numbers are finite, and small enough to compute with: 1e8 metres, 1e5 radians.
constexpr bool usable(const Pose2& p) noexcept {
  constexpr double far = 1e8, turned = 1e5;
  return p.x_m >= -far && p.x_m <= far && p.y_m >= -far && p.y_m <= far && p.heading_rad >= -turned &&
         p.heading_rad <= turned;
}

}  // namespace straightedge
