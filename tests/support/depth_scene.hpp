// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "straightedge/depth_view.hpp"
#include "straightedge/host/image.hpp"
#include "straightedge/plane.hpp"
#include "straightedge/random.hpp"
#include "straightedge/trigonometry.hpp"
#include "straightedge/vector3.hpp"
#include "support/drawing.hpp"

/// What a depth camera sees of planes, balls and pillars, with the truth for every pixel.
namespace support {

using straightedge::PinholeCamera;
using straightedge::Plane;
using straightedge::Vector3;

/// The field of view of a Kinect.
inline PinholeCamera kinect(Size size) {
  const double focal = 525.0 * size.width / 640;
  return {focal, focal, (size.width - 1) / 2.0, (size.height - 1) / 2.0};
}

/// Structured light measures disparity: noise that neighbours share, and steps, both in 1/z.
struct SensorNoise {
  double sigma = 1.1e-3;  ///< 1/metre; with the steps 1.4e-3 in all
  double step = 2.85e-3;  ///< 1/metre
  int reach = 1;          ///< so many pixels to every side share their noise
  double holes = 0;       ///< share of the picture without readings
  int hole_side = 3;      ///< in squares of so many pixels
  double sag = 0;         ///< added to 1/z in the middle of the left and right border, by square
  double units_per_metre = 1000;
};

class DepthScene {
 public:
  explicit DepthScene(Size size) : DepthScene(size, kinect(size)) {}
  DepthScene(Size size, const PinholeCamera& camera)
      : camera_(camera), inverse_(size, 0.0), truth_(size, std::uint16_t{0}) {}

  Size size() const { return truth_.size(); }
  const PinholeCamera& camera() const { return camera_; }
  /// The label of the surface that each pixel looks at.
  const Image<std::uint16_t>& truth() const { return truth_; }
  const Image<double>& inverse_depth() const { return inverse_; }

  /// `inverse(ray)` is 1/z of a surface, 0 or below where the ray misses it.
  template <class Inverse>
  void draw(std::uint16_t label, Inverse&& inverse) {
    for (int y = 0; y < size().height; ++y) {
      for (int x = 0; x < size().width; ++x) {
        const double q = inverse(camera_.ray(x, y));
        if (!(q > inverse_.at(x, y))) continue;
        inverse_.at(x, y) = q;
        truth_.at(x, y) = label;
      }
    }
  }
  void draw_plane(std::uint16_t label, const Plane& plane) {
    draw_part(label, plane, [](const Vector3&) { return true; });
  }
  /// The points of the plane for which `inside` holds.
  template <class Inside>
  void draw_part(std::uint16_t label, const Plane& plane, Inside&& inside) {
    draw(label, [&](const Vector3& ray) {
      const double q = dot(plane.normal, ray) / plane.distance;
      return q > 0 && inside((1 / q) * ray) ? q : 0;
    });
  }
  /// All points within `radius` of a line through `centre` along `axis`, or of the centre when axis is null.
  void draw_round(std::uint16_t label, const Vector3& centre, const Vector3& axis, double radius) {
    draw(label, [&](const Vector3& ray) {
      const Vector3 r = ray - dot(ray, axis) * axis, c = centre - dot(centre, axis) * axis;
      const double a = dot(r, r), b = dot(r, c), rest = b * b - a * (dot(c, c) - radius * radius);
      return rest > 0 && b > std::sqrt(rest) ? a / (b - std::sqrt(rest)) : 0;
    });
  }

  /// The frame of the sensor, in units.
  Image<std::uint16_t> picture(const SensorNoise& noise, std::uint64_t seed) const {
    Pcg32 random(seed);
    const Image<double> shared = shared_noise(noise.reach, random);
    const Image<std::uint8_t> hole = holes(noise.holes, noise.hole_side, random);
    Image<std::uint16_t> out(size());
    for (int y = 0; y < size().height; ++y) {
      for (int x = 0; x < size().width; ++x) {
        if (!(inverse_.at(x, y) > 0) || hole.at(x / noise.hole_side, y / noise.hole_side) != 0) continue;
        const double across = 2 * (x - camera_.cx) / size().width;
        double q = inverse_.at(x, y) + noise.sigma * shared.at(x, y) + noise.sag * across * across;
        if (noise.step > 0) q = std::floor(q / noise.step + 0.5) * noise.step;
        const double units = q > 0 ? std::floor(noise.units_per_metre / q + 0.5) : 0;
        if (units >= 1 && units <= 65535) out.at(x, y) = static_cast<std::uint16_t>(units);
      }
    }
    return out;
  }

 private:
  /// Standard deviation 1; the mean of the square around each pixel, enlarged.
  Image<double> shared_noise(int reach, Pcg32& random) const {
    Image<double> white({size().width + 2 * reach, size().height + 2 * reach});
    for (int y = 0; y < white.height(); ++y) {
      for (int x = 0; x < white.width(); ++x) white.at(x, y) = normal(random);
    }
    Image<double> out(size());
    const int side = 2 * reach + 1;
    for (int y = 0; y < size().height; ++y) {
      for (int x = 0; x < size().width; ++x) {
        for (int i = 0; i < side * side; ++i) out.at(x, y) += white.at(x + i % side, y + i / side) / side;
      }
    }
    return out;
  }
  Image<std::uint8_t> holes(double share, int side, Pcg32& random) const {
    Image<std::uint8_t> out({size().width / side + 1, size().height / side + 1});
    for (int y = 0; y < out.height(); ++y) {
      for (int x = 0; x < out.width(); ++x) out.at(x, y) = uniform(random, 0, 1) < share ? 1 : 0;
    }
    return out;
  }

  PinholeCamera camera_;
  Image<double> inverse_;
  Image<std::uint16_t> truth_;
};

/// A frame with its pixels.
struct DepthFrame {
  Image<std::uint16_t> raw;
  PinholeCamera camera;
  double metres_per_unit = 0.001;

  straightedge::DepthView view() const { return {raw, metres_per_unit, camera}; }
};

inline DepthFrame frame_of(const DepthScene& scene, const SensorNoise& noise, std::uint64_t seed) {
  return {scene.picture(noise, seed), scene.camera(), 1 / noise.units_per_metre};
}

/// Left, right, floor, ceiling and back wall, as the camera turned and nodding sees them.
inline std::vector<Plane> box_planes(double turn_rad = 0.06, double nod_rad = 0.03) {
  const double c = std::cos(turn_rad), s = std::sin(turn_rad);
  const double cn = std::cos(nod_rad), sn = std::sin(nod_rad);
  const auto seen = [&](const Vector3& n) {
    const Vector3 turned{c * n.x + s * n.z, n.y, -s * n.x + c * n.z};
    return Vector3{turned.x, cn * turned.y - sn * turned.z, sn * turned.y + cn * turned.z};
  };
  return {{seen({-1, 0, 0}), 1.2},
          {seen({1, 0, 0}), 1.1},
          {seen({0, 1, 0}), 0.9},
          {seen({0, -1, 0}), 0.8},
          {seen({0, 0, 1}), 3.2}};
}

/// The inside of the box: of each ray the first wall is the one with the largest 1/z. Label k is plane k − 1.
inline DepthScene box_room(Size size, const std::vector<Plane>& planes) {
  DepthScene scene(size);
  for (std::size_t k = 0; k < planes.size(); ++k) {
    scene.draw_plane(static_cast<std::uint16_t>(k + 1), planes[k]);
  }
  return scene;
}

}  // namespace support
