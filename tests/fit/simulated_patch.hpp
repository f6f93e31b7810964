// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "straightedge/inverse_depth.hpp"
#include "straightedge/trigonometry.hpp"
#include "support/drawing.hpp"

/// Square patches of a plane as a Kinect sees them: noise in 1/z, Gaussian, of its own for each pixel.
namespace simulated {

using namespace straightedge;

constexpr double sigma = 1.425e-3;
constexpr PinholeCamera camera{525, -525, 319.5, 239.5};

struct Patch {
  Plane truth;
  double left = 0, top = 0;  ///< pixels
  int size = 80;             ///< pixels a side
};

/// A plane at this depth in the patch's middle, whose normal leans away from the middle's ray.
inline Patch patch_at(double z, double tilt_rad, double turn_rad, double left, double top, int size) {
  const double middle = (size - 1) / 2.0;
  const Vector3 ray = camera.ray(left + middle, top + middle);
  const Vector3 along = normalized(ray);
  const Vector3 u = normalized(cross(along, {0, 1, 0}));
  const Vector3 aside = std::cos(turn_rad) * u + std::sin(turn_rad) * cross(along, u);
  const Vector3 normal = std::cos(tilt_rad) * along + std::sin(tilt_rad) * aside;
  return {{normal, dot(normal, z * ray)}, left, top, size};
}

inline Patch random_patch(Pcg32& random, double most_tilt_rad, int size) {
  const double z = support::uniform(random, 2, 3.5);
  const double tilt = support::uniform(random, 0, most_tilt_rad);
  const double turn = support::uniform(random, -pi, pi);
  const double left = std::floor(support::uniform(random, 0, 640 - size));
  const double top = std::floor(support::uniform(random, 0, 480 - size));
  return patch_at(z, tilt, turn, left, top, size);
}

/// Calls use(u, v, 1/z) for each pixel.
template <class Use>
void for_each_reading(const Patch& patch, Pcg32& random, Use&& use) {
  const InverseDepthPlane truth = to_inverse_depth(patch.truth, camera);
  for (int row = 0; row < patch.size; ++row) {
    for (int column = 0; column < patch.size; ++column) {
      const double u = patch.left + column, v = patch.top + row;
      use(u, v, truth.at(u, v) + sigma * support::normal(random));
    }
  }
}

inline std::vector<Vector3> points_of(const Patch& patch, Pcg32& random) {
  std::vector<Vector3> points;
  for_each_reading(patch, random,
                   [&](double u, double v, double q) { points.push_back((1 / q) * camera.ray(u, v)); });
  return points;
}

}  // namespace simulated
