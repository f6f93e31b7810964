// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "straightedge/depth_view.hpp"
#include "straightedge/host/image.hpp"
#include "straightedge/plane.hpp"
#include "straightedge/points_view.hpp"
#include "straightedge/random.hpp"
#include "straightedge/trigonometry.hpp"

/// Scenes of planes whose truth is known, for the tests of the plane searches.
namespace test {

using straightedge::Pcg32;
using straightedge::PinholeCamera;
using straightedge::Plane;
using straightedge::Size;
using straightedge::Vector3;

inline double uniform(Pcg32& random) {
  return random.next() / 4294967296.0;
}
/// Nearly normal: the sum of twelve uniform numbers.
inline double normal_number(Pcg32& random) {
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += uniform(random);
  return sum;
}
/// Each direction equally likely.
inline Vector3 random_direction(Pcg32& random) {
  for (;;) {
    const Vector3 v{2 * uniform(random) - 1, 2 * uniform(random) - 1, 2 * uniform(random) - 1};
    const double squared = squared_length(v);
    if (squared > 0.01 && squared <= 1) return normalized(v);
  }
}
inline Plane plane_of(const Vector3& normal, double distance) {
  return canonical(Plane{normalized(normal), distance});
}

/// The part of a plane that shows in a rectangle of the picture.
struct Face {
  Plane plane;
  std::int32_t x0 = 0, y0 = 0, x1 = 1 << 20, y1 = 1 << 20;  ///< columns and rows [x0, x1) x [y0, y1)
};

/// 1/z of the last face that shows in each pixel, with noise of that deviation; 0 where none shows.
inline straightedge::Image<float> depth_scene(Size size, const PinholeCamera& camera,
                                              const std::vector<Face>& faces, double noise,
                                              std::uint64_t seed) {
  straightedge::Image<float> picture(size, 0.0F);
  Pcg32 random(seed);
  for (std::int32_t y = 0; y < size.height; ++y) {
    for (std::int32_t x = 0; x < size.width; ++x) {
      const double error = noise > 0 ? noise * normal_number(random) : 0;
      for (const Face& face : faces) {
        if (x < face.x0 || x >= face.x1 || y < face.y0 || y >= face.y1) continue;
        const double q = dot(face.plane.normal, camera.ray(x, y)) / face.plane.distance;
        if (q > 0) picture.at(x, y) = static_cast<float>(q + error);
      }
    }
  }
  return picture;
}

/// Points in three arrays.
struct Cloud {
  std::vector<float> x, y, z;

  void add(const Vector3& p) {
    x.push_back(static_cast<float>(p.x));
    y.push_back(static_cast<float>(p.y));
    z.push_back(static_cast<float>(p.z));
  }
  /// A disc of points round `centre`, across `normal`.
  void add_disc(const Vector3& centre, const Vector3& normal, double radius, int count, double noise,
                Pcg32& random) {
    const Vector3 aside = normal.x * normal.x < 0.5 ? Vector3{1, 0, 0} : Vector3{0, 1, 0};
    const Vector3 u = normalized(cross(normal, aside)), v = cross(normal, u);
    while (count > 0) {
      const double a = 2 * uniform(random) - 1, b = 2 * uniform(random) - 1;
      if (a * a + b * b > 1) continue;
      const double off = noise > 0 ? noise * normal_number(random) : 0;
      add(centre + (radius * a) * u + (radius * b) * v + off * normal);
      --count;
    }
  }
  std::size_t size() const { return x.size(); }
  straightedge::PointsView view() const { return {x.data(), y.data(), z.data(), x.size()}; }
};

inline double angle_between(const Vector3& a, const Vector3& b) {
  const Vector3 c = cross(a, b);
  return straightedge::arc_tangent(length(c), dot(a, b));
}

}  // namespace test
