// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <vector>

#include "straightedge/host/image.hpp"
#include "straightedge/host/plane_map_builder.hpp"
#include "straightedge/inverse_depth.hpp"
#include "straightedge/random.hpp"
#include "straightedge/trigonometry.hpp"
#include "support/catch.hpp"

/// Scenes of rectangles with known truth, seen by a small depth camera with the Kinect's noise.
namespace scene {

using namespace straightedge;

struct Hole {
  double a0 = 0, b0 = 0, a1 = 0, b1 = 0;
};

struct Rectangle {
  Vector3 corner, along_a, along_b;  ///< sides with their lengths
  std::vector<Hole> holes;           ///< metres from the corner
  std::uint16_t label = 1;           ///< rectangles of one plane share it
};

struct Frame {
  Image<std::uint16_t> depth, labels;
  std::vector<FoundPlane> planes;
  Pose pose;
  PinholeCamera camera;

  DepthView view() const {
    DepthView v;
    v.raw = depth.view();
    v.metres_per_unit = 1 / 5000.0;
    v.camera = camera;
    return v;
  }
};

inline constexpr Size frame_size{160, 120};
inline constexpr PinholeCamera frame_camera{131.25, 131.25, 79.5, 59.5};
inline constexpr double noise_sigma = 1.425e-3;

/// Looks from `from` to `to`, level.
inline Pose look(const Vector3& from, const Vector3& to) {
  const Vector3 z = normalized(to - from);
  const Vector3 x = normalized(cross(z, Vector3{0, 0, 1}));
  const Vector3 y = cross(z, x);
  return {{x.x, y.x, z.x, x.y, y.y, z.y, x.z, y.z, z.z}, from};
}

/// Nearly normal, variance 1.
inline double chance(Pcg32& random) {
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += random.next() / 4294967296.0;
  return sum;
}

/// z of the nearest rectangle on the ray, and its label.
inline std::pair<double, std::uint16_t> hit(const std::vector<Rectangle>& scene, const Vector3& from,
                                            const Vector3& ray) {
  std::pair<double, std::uint16_t> nearest{1e9, 0};
  for (const Rectangle& r : scene) {
    const Vector3 n = cross(r.along_a, r.along_b);
    const double z = dot(n, r.corner - from) / dot(n, ray);
    if (!(z > 0.1 && z < nearest.first)) continue;
    const Vector3 q = from + z * ray - r.corner;
    const double a = dot(q, normalized(r.along_a)), b = dot(q, normalized(r.along_b));
    bool on = a >= 0 && b >= 0 && a <= length(r.along_a) && b <= length(r.along_b);
    for (const Hole& h : r.holes) on = on && !(a > h.a0 && a < h.a1 && b > h.b0 && b < h.b1);
    if (on) nearest = {z, r.label};
  }
  return nearest;
}

/// Planes as a detector would find them: each label fitted in inverse depth; fewer than 30 pixels are none.
inline void find_planes(Frame& frame) {
  std::map<std::uint16_t, InverseDepthMoments> sums;
  for (std::int32_t v = 0; v < frame_size.height; ++v) {
    for (std::int32_t u = 0; u < frame_size.width; ++u) {
      if (frame.labels.view().at(u, v) != 0)
        sums[frame.labels.view().at(u, v)].add(u, v, 5000.0 / frame.depth.view().at(u, v));
    }
  }
  std::map<std::uint16_t, std::uint16_t> index{{0, 0}};
  for (const auto& [label, moments] : sums) {
    InverseDepthFit fit;
    FoundPlane plane;
    if (moments.n < 30 || fit_inverse_depth(moments, noise_sigma, fit) != Status::ok) continue;
    if (to_plane_fit(fit, noise_sigma, frame.camera, plane.fit) != Status::ok) continue;
    frame.planes.push_back(plane);
    index[label] = static_cast<std::uint16_t>(frame.planes.size());
  }
  for (std::int32_t v = 0; v < frame_size.height; ++v) {
    for (std::int32_t u = 0; u < frame_size.width; ++u) {
      std::uint16_t& label = frame.labels.view().at(u, v);
      label = index.contains(label) ? index[label] : std::uint16_t{0};
    }
  }
}

/// `noise` 1 is the Kinect's, 0 none. Readings up to `range` metres.
inline Frame seen(const std::vector<Rectangle>& rectangles, const Pose& pose, std::uint64_t seed,
                  double noise = 1, double range = 6) {
  Frame frame{Image<std::uint16_t>(frame_size), Image<std::uint16_t>(frame_size), {}, pose, frame_camera};
  Pcg32 random(seed);
  for (std::int32_t v = 0; v < frame_size.height; ++v) {
    for (std::int32_t u = 0; u < frame_size.width; ++u) {
      const auto [z, label] = hit(rectangles, pose.translation, pose.turned(frame_camera.ray(u, v)));
      const double reading = 1 / (1 / z + noise * noise_sigma * chance(random));
      if (label == 0 || !(reading > 0.3 && reading < range)) continue;
      frame.depth.view().at(u, v) = static_cast<std::uint16_t>(reading * 5000 + 0.5);
      frame.labels.view().at(u, v) = label;
    }
  }
  find_planes(frame);
  return frame;
}

inline RegisteredFrame add(PlaneMapBuilder& builder, const Frame& frame) {
  const auto result = builder.add(frame.view(), frame.labels.view(), frame.planes, frame.pose);
  if (!result) FAIL(result.failure().sentence);
  return *result;
}

inline PlaneMapReading read(const PlaneMapBuilder& builder) {
  const auto result = builder.build();
  if (!result) FAIL(result.failure().sentence);
  return *result;
}

/// Small frames have sixteen times fewer readings than the camera the defaults are for.
inline PlaneMapOptions options() {
  PlaneMapOptions o;
  o.min_points = 100;
  o.shared_noise = 2;
  return o;
}

inline double angle_to(const MapPlane& plane, const Vector3& normal) {
  return arc_tangent(length(cross(plane.plane.normal, normal)),
                     std::max(dot(plane.plane.normal, normal), -dot(plane.plane.normal, normal)));
}

/// The area of the polygons of one plane, holes taken off.
inline double area(const MapPlane& plane) {
  double sum = 0;
  for (const MapPolygon& polygon : plane.polygons) {
    Vector3 twice;
    for (std::size_t i = 0; i < polygon.points.size(); ++i) {
      const Vector3& p = polygon.points[i];
      const Vector3& q = polygon.points[(i + 1) % polygon.points.size()];
      twice = twice + cross(p - polygon.points[0], q - polygon.points[0]);
    }
    sum += dot(twice, plane.plane.normal) / 2;
  }
  return sum;
}

/// A room of 4 x 3 x 2.4 m with a box in it, seen from its middle all round.
inline std::vector<Rectangle> room() {
  return {{{0, 0, 0}, {4, 0, 0}, {0, 3, 0}, {}, 1},       {{0, 0, 2.4}, {4, 0, 0}, {0, 3, 0}, {}, 2},
          {{0, 0, 0}, {4, 0, 0}, {0, 0, 2.4}, {}, 3},     {{0, 3, 0}, {4, 0, 0}, {0, 0, 2.4}, {}, 4},
          {{0, 0, 0}, {0, 3, 0}, {0, 0, 2.4}, {}, 5},     {{4, 0, 0}, {0, 3, 0}, {0, 0, 2.4}, {}, 6},
          {{3, 2.2, 0}, {0.6, 0, 0}, {0, 0, 0.8}, {}, 7}, {{3, 2.2, 0.8}, {0.6, 0, 0}, {0, 0.8, 0}, {}, 8}};
}

inline std::vector<Frame> tour(const std::vector<Rectangle>& rectangles, int frames, std::uint64_t seed,
                               const Vector3& shift = {}) {
  std::vector<Rectangle> moved = rectangles;
  for (Rectangle& r : moved) r.corner = r.corner + shift;
  std::vector<Frame> seen_frames;
  for (int i = 0; i < frames; ++i) {
    const SineCosine t = sine_cosine(2 * pi * i / frames);
    const Vector3 from = Vector3{2 - 0.4 * t.cosine, 1.5 - 0.4 * t.sine, 1.2} + shift;
    const Vector3 to = from + Vector3{t.cosine, t.sine, i % 3 == 0 ? 0.2 : -0.3};
    seen_frames.push_back(seen(moved, look(from, to), seed + static_cast<std::uint64_t>(i)));
  }
  return seen_frames;
}

}  // namespace scene
