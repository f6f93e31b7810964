// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "ransac/pixel_gate.hpp"
#include "straightedge/inverse_depth.hpp"
#include "straightedge/plane_gate.hpp"
#include "straightedge/points_view.hpp"
#include "straightedge/ransac_planes.hpp"

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
  ImageView<const float> frame;  ///< with data: a frame of 1/z
  ImageView<const std::uint16_t>
      raw;  ///< with data: a frame of depth as the sensor gives it, 1/z = scale / raw
  float scale = 1;
  PinholeCamera camera;  ///< of the frame; of rays for a cloud
  PointsView points;
  PlaneGate gate;
  Vector3 origin;                       ///< of a cloud with a gate in metres: floats resolve what is near it
  detail::CloudBlock* block = nullptr;  ///< for such a cloud, unless all of its points are readings

  bool is_raw() const noexcept { return raw.data != nullptr; }
  bool is_frame() const noexcept { return frame.data != nullptr || is_raw(); }
  bool in_space() const noexcept { return !is_frame() && gate.fixed_m > 0; }
  Size size() const noexcept { return is_raw() ? raw.size() : frame.size(); }
  std::uint32_t count() const noexcept {
    return is_frame() ? static_cast<std::uint32_t>(size().width) * static_cast<std::uint32_t>(size().height)
                      : static_cast<std::uint32_t>(points.count);
  }
  /// So many gates of a frame's pixels: in 1/z, or along z, whichever is more.
  float constant(double gates = 1) const noexcept {
    return static_cast<float>(gate.fixed_m > 0 ? 0 : gates * gate.sigmas * gate.inverse_sigma);
  }
  float metres(double gates = 1) const noexcept {
    return static_cast<float>(gates * (gate.fixed_m > 0 ? gate.fixed_m : gate.sigmas * gate.floor_m));
  }
  float inverse_at(std::int32_t u, std::int32_t v) const noexcept {
    return is_raw() ? inverse_of(raw.at(u, v), scale) : frame.at(u, v);
  }
  /// False: number i is no reading.
  bool read(std::uint32_t i, Reading& r) const noexcept {
    if (!is_frame()) return read_point(points.at(i), r);
    const auto width = static_cast<std::uint32_t>(size().width);
    return read_pixel(static_cast<std::int32_t>(i % width), static_cast<std::int32_t>(i / width), r);
  }
  bool read_pixel(std::int32_t u, std::int32_t v, Reading& r) const noexcept {
    const float q = inverse_at(u, v);
    const float wide = wide_of(q, constant(), metres());
    if (is_above(q, wide) == 0) return false;
    r.x = u;
    r.y = v;
    r.z = static_cast<double>(q);
    r.w = static_cast<double>(1 / wide);
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
