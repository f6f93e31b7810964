// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "ransac/reading.hpp"
#include "straightedge/inverse_depth.hpp"
#include "straightedge/points_view.hpp"

namespace straightedge::ransac {

/// Three coordinates in which planes are linear, and 1 / gate in the unit of the residual.
struct Reading {
  double x = 0, y = 0, z = 0;
  double w = 0;
  Vector3 place;  ///< for what is near: pixels or metres
};

/// k.x x + k.y y + k.z z + k.w is the residual of a reading. In inverse depth k = (−a, −b, 1, −c), in space
/// the normal and −distance, counted from `origin`.
struct LinearPlane {
  double x = 0, y = 0, z = 0, w = 0;

  double at(const Reading& r) const noexcept { return ((x * r.x + y * r.y) + z * r.z) + w; }
};

/// A depth frame or a cloud as numbered readings.
struct Readings {
  ImageView<const float> frame;  ///< with data: a frame
  PinholeCamera camera;          ///< of the frame; of rays for a cloud
  PointsView points;
  PlaneGate gate;
  Vector3 origin;  ///< of a cloud with a gate in metres: floats resolve what is near it

  bool is_frame() const noexcept { return frame.data != nullptr; }
  bool in_space() const noexcept { return !is_frame() && gate.fixed_m > 0; }
  std::uint32_t count() const noexcept {
    return is_frame() ? static_cast<std::uint32_t>(frame.width) * static_cast<std::uint32_t>(frame.height)
                      : static_cast<std::uint32_t>(points.count);
  }
  /// False: number i is no reading.
  bool read(std::uint32_t i, Reading& r) const noexcept {
    if (!is_frame()) return read_point(points.at(i), r);
    const auto width = static_cast<std::uint32_t>(frame.width);
    return read_pixel(static_cast<std::int32_t>(i % width), static_cast<std::int32_t>(i / width), r);
  }
  bool read_pixel(std::int32_t u, std::int32_t v, Reading& r) const noexcept {
    const float q = frame.at(u, v);
    const float w = inverse_gate(gate, q);
    if (!is_reading(q, w)) return false;
    r = {static_cast<double>(u), static_cast<double>(v), static_cast<double>(q), static_cast<double>(w), {}};
    r.place = {r.x, r.y, 0};
    return true;
  }
  bool read_point(const Vector3& p, Reading& r) const noexcept {
    if (!finite(p)) return false;
    if (in_space()) {
      const Vector3 d = p - origin;
      r = {d.x, d.y, d.z, 1 / gate.fixed_m, d};
      return true;
    }
    if (!(p.z > 1e-6)) return false;
    const double w = 1 / (gate.sigmas * gate.inverse_noise(1 / p.z));
    if (!(w > p.z)) return false;
    r = {p.x / p.z, p.y / p.z, 1 / p.z, w, p};
    return true;
  }
};

}  // namespace straightedge::ransac
