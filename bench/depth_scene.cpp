// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "depth_scene.hpp"

#include "straightedge/inverse_depth.hpp"
#include "straightedge/plane_gate.hpp"
#include "straightedge/random.hpp"

namespace bench {
namespace {

using namespace straightedge;

/// The part of a plane that is seen in a rectangle, sides as shares of the picture's.
struct Face {
  Vector3 normal;
  double distance;
  double u0, v0, u1, v1;
};

// Ceiling, floor and walls fill what the table and the boxes before them leave.
constexpr Face faces[] = {
    {{0.02, -1, 0.05}, 1.5, 0, 0, 1, 1},
    {{0.02, 1, -0.05}, 1.1, 0, 0, 1, 1},
    {{0.25, 0.02, 1}, 3.6, 0, 0, 1, 1},
    {{1, 0.02, -0.25}, 1.9, 0, 0, 1, 1},
    {{-1, 0.01, 0.2}, 1.7, 0, 0, 1, 1},
    {{0, 1, -0.1}, 0.35, 0.30, 0.62, 0.70, 0.72},
    {{-0.5, 0, 1}, 1.7, 0.12, 0.55, 0.26, 0.85},
    {{1, 0, 0.5}, 0.45, 0.26, 0.55, 0.33, 0.85},
    {{-0.3, 0, 1}, 2.1, 0.75, 0.50, 0.86, 0.70},
    {{1, 0, 0.3}, 1.4, 0.86, 0.50, 0.90, 0.70},
    {{0.1, -0.2, 1}, 1.5, 0.45, 0.50, 0.55, 0.60},
    {{0.4, 0.3, 1}, 2.6, 0.55, 0.20, 0.60, 0.26},
};
constexpr int walls = 5;

double noise(Pcg32& random) {
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += random.next() / 4294967296.0;
  return sum;
}

}  // namespace

DepthScene make_depth_scene(Size size) {
  const double f = 0.82 * size.width;
  DepthScene scene{Image<float>(size, 0.0F), {f, f, (size.width - 1) / 2.0, (size.height - 1) / 2.0}};
  Pcg32 random(1);
  for (std::int32_t v = 0; v < size.height; ++v) {
    for (std::int32_t u = 0; u < size.width; ++u) {
      double q = 0;
      for (int i = 0; i < static_cast<int>(std::size(faces)); ++i) {
        const Face& face = faces[i];
        const double x = (u + 0.5) / size.width, y = (v + 0.5) / size.height;
        if (x < face.u0 || x >= face.u1 || y < face.v0 || y >= face.v1) continue;
        const Plane plane = canonical({normalized(face.normal), face.distance});
        const double seen = to_inverse_depth(plane, scene.camera).at(u, v);
        if (seen > q || (i >= walls && seen > 0)) q = seen;
      }
      const double read = q + PlaneGate{}.inverse_sigma * noise(random);
      scene.inverse_depth.view().at(u, v) = random.below(10) == 0 ? 0.0F : static_cast<float>(read);
    }
  }
  return scene;
}

DepthFrame make_depth_frame(Size size) {
  const DepthScene scene = make_depth_scene(size);
  DepthFrame frame{Image<std::uint16_t>(size), scene.camera};
  for (std::int32_t v = 0; v < size.height; ++v) {
    for (std::int32_t u = 0; u < size.width; ++u) {
      const double q = static_cast<double>(scene.inverse_depth.at(u, v));
      const double units = q > 0 ? 1 / (q * DepthFrame::metres_per_unit) + 0.5 : 0;
      frame.raw.at(u, v) = units < 65536 ? static_cast<std::uint16_t>(units) : std::uint16_t{0};
    }
  }
  return frame;
}

}  // namespace bench
