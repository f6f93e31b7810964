// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "scenes/room.hpp"

#include "straightedge/random.hpp"

namespace firmware {
namespace {

using straightedge::FoundPlane;
using straightedge::ImageView;
using straightedge::Plane;
using straightedge::Size;
using straightedge::Vector3;

/// A plane, and the part of it that there is: a box in the camera's frame, metres.
struct Surface {
  Plane plane;
  Vector3 low, high;
};
constexpr double far = 100;
constexpr Vector3 least{-far, -far, 0}, most{far, far, far};
constexpr std::array<Surface, 5> surfaces = {{
    {{{0, 1, 0}, 0.8}, least, most},                        // floor
    {{{0.28, 0, 0.96}, 2.9}, least, most},                  // back wall
    {{{-0.96, 0, 0.28}, 1.3}, least, most},                 // left wall
    {{{0, 0, 1}, 1.9}, {0.1, 0.4, 1.8}, {1.0, 0.8, 2.0}},  // front of the box
    {{{0, 1, 0}, 0.4}, {0.1, 0.3, 1.9}, {1.0, 0.5, 2.7}},  // its top
}};

bool inside(const Vector3& p, const Surface& surface) noexcept {
  constexpr double touching = 1e-9;
  return p.x >= surface.low.x - touching && p.x <= surface.high.x + touching &&
         p.y >= surface.low.y - touching && p.y <= surface.high.y + touching &&
         p.z >= surface.low.z - touching && p.z <= surface.high.z + touching;
}

/// 1/z of the nearest surface along a ray; 0 where there is none.
double inverse_depth(const Vector3& ray) noexcept {
  double nearest = 0;
  for (const Surface& surface : surfaces) {
    const double q = dot(surface.plane.normal, ray) / surface.plane.distance;
    if (q > nearest && inside((1 / q) * ray, surface)) nearest = q;
  }
  return nearest;
}

bool same(const Plane& a, const Plane& b) noexcept {
  constexpr double cosine_of_a_degree = 0.99985, centimetre = 0.01;
  const double apart = a.distance - b.distance;
  return dot(a.normal, b.normal) > cosine_of_a_degree && apart < centimetre && -apart < centimetre;
}

}  // namespace

straightedge::PinholeCamera kinect(Size size) noexcept {
  const double focal = 525.0 * size.width / 640;
  return {focal, focal, (size.width - 1) / 2.0, (size.height - 1) / 2.0};
}

void draw_room(ImageView<std::uint16_t> out) noexcept {
  straightedge::Pcg32 random(4);
  const straightedge::PinholeCamera camera = kinect(out.size());
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x) {
      // The sum of four even draws has a standard deviation of 1.15 of their half range.
      std::int32_t sum = 0;
      for (int i = 0; i < 4; ++i) sum += static_cast<std::int32_t>(random.below(2001)) - 1000;
      const double q = inverse_depth(camera.ray(x, y)) + 1.2e-6 * sum;
      const bool hole = (x / 5 + y / 4 * 3) % 31 == 0;
      out.at(x, y) = hole || !(q > 0.1) ? std::uint16_t{0} : static_cast<std::uint16_t>(1000 / q + 0.5);
    }
  }
}

RoomScore score_room(std::span<const FoundPlane> planes) noexcept {
  RoomScore score{static_cast<std::uint32_t>(surfaces.size())};
  std::array<bool, surfaces.size()> taken{};
  for (const FoundPlane& plane : planes) {
    std::size_t i = 0;
    while (i < surfaces.size() && (taken[i] || !same(canonical(plane.fit.plane), surfaces[i].plane))) ++i;
    if (i == surfaces.size()) {
      ++score.wrong;
      continue;
    }
    taken[i] = true;
    ++score.found;
  }
  return score;
}

}  // namespace firmware
