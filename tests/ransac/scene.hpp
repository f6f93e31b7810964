// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "straightedge/inverse_depth.hpp"
#include "straightedge/points_view.hpp"
#include "straightedge/random.hpp"

namespace scene {

using namespace straightedge;

inline constexpr Size size{320, 240};
inline constexpr PinholeCamera camera{262.5, 262.5, 159.5, 119.5};
inline constexpr double sigma = 1.425e-3;

/// A face of a box: a plane seen in a rectangle of pixels.
struct Face {
  Plane plane;
  std::int32_t u0 = 0, v0 = 0, u1 = 0, v1 = 0;
};

/// The corner of a room: of its planes a ray meets the nearest. Faces stand before them.
struct Room {
  std::vector<Plane> planes;
  std::vector<Face> faces;
};

/// A frame of 1/z with the number of the plane + 1 for each pixel (faces after the planes), 0 in holes.
struct Frame {
  std::vector<float> q;
  std::vector<int> truth;

  ImageView<const float> view() const { return {q.data(), size}; }
  ImageView<float> writable() { return {q.data(), size}; }
  std::size_t pixels_of(int label) const {
    std::size_t n = 0;
    for (const int t : truth) n += t == label ? 1 : 0;
    return n;
  }
};

inline Plane plane_of(const Vector3& normal, double distance) {
  return canonical({normalized(normal), distance});
}

/// Floor, back wall, side wall, turned by chance; a box with two faces. Offsets differ by decimetres.
inline Room room_by_chance(Pcg32& random) {
  const auto between = [&](double low, double high) {
    return low + (high - low) * random.below(1000) / 1000.0;
  };
  // One statement a number: the order in which arguments are evaluated is the compiler's own.
  Room room;
  const double yaw = between(-0.3, 0.3);
  const double floor = between(1.0, 1.3), tilt = between(-0.1, 0.1);
  room.planes.push_back(plane_of({0.02, 1, tilt}, floor));
  room.planes.push_back(plane_of({yaw, 0.02, 1}, between(2.8, 3.5)));
  room.planes.push_back(plane_of({1, 0.02, -yaw}, between(1.2, 1.6)));
  const double turn = between(0.3, 0.6);
  room.faces.push_back({plane_of({-turn, 0, 1}, between(1.6, 1.8)), 60, 130, 110, 200});
  room.faces.push_back({plane_of({1, 0, turn}, between(0.5, 0.6)), 110, 130, 150, 200});
  return room;
}

/// About normal: the sum of twelve.
inline double noise(Pcg32& random) {
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += random.next() / 4294967296.0;
  return sum;
}

inline Frame render(const Room& room, double noise_sigma, double holes, Pcg32& random) {
  Frame frame;
  for (std::int32_t v = 0; v < size.height; ++v) {
    for (std::int32_t u = 0; u < size.width; ++u) {
      double q = 0;
      int label = 0, index = 0;
      const auto see = [&](const Plane& plane, bool over) {
        ++index;
        const double seen = to_inverse_depth(plane, camera).at(u, v);
        if (seen <= 0 || (!over && seen <= q)) return;
        q = seen;
        label = index;
      };
      for (const Plane& plane : room.planes) see(plane, false);
      for (const Face& f : room.faces)
        if (u >= f.u0 && u < f.u1 && v >= f.v0 && v < f.v1) {
          see(f.plane, true);
        } else {
          ++index;
        }
      const double read = q + noise_sigma * noise(random);
      const bool hole = q <= 0 || random.next() < holes * 4294967296.0;
      frame.q.push_back(hole ? 0.0F : static_cast<float>(read));
      frame.truth.push_back(hole ? 0 : label);
    }
  }
  return frame;
}

/// The frame's readings as points; holes are NaN.
struct Cloud {
  std::vector<float> x, y, z;
  PointsView view() const { return {x.data(), y.data(), z.data(), x.size()}; }
};

inline Cloud to_cloud(const Frame& frame) {
  Cloud cloud;
  for (std::int32_t v = 0; v < size.height; ++v) {
    for (std::int32_t u = 0; u < size.width; ++u) {
      const float q = frame.q[static_cast<std::size_t>(v * size.width + u)];
      const Vector3 p = (1.0 / static_cast<double>(q)) * camera.ray(u, v);
      const float nan = __builtin_nanf("");
      cloud.x.push_back(q > 0 ? static_cast<float>(p.x) : nan);
      cloud.y.push_back(q > 0 ? static_cast<float>(p.y) : nan);
      cloud.z.push_back(q > 0 ? static_cast<float>(p.z) : nan);
    }
  }
  return cloud;
}

/// Radians between the normals, and metres between the distances.
struct PlaneError {
  double angle = 0, offset = 0;
};

inline PlaneError error_of(const Plane& a, const Plane& b) {
  const Vector3 across = cross(a.normal, b.normal);
  const double offset = a.distance - b.distance;
  return {dot(a.normal, b.normal) > 0 ? length(across) : 3, offset < 0 ? -offset : offset};
}

}  // namespace scene
