// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/image.hpp"
#include "straightedge/vector3.hpp"

namespace straightedge {

/// A camera without distortion. Pixel (column u, row v), whose centre has these very numbers, sees along
/// ((u − cx)/fx, (v − cy)/fy, 1): x right, y down, z forward. fx and fy may be negative (a mirrored
/// picture), never zero. This is the convention of camera calibrations; note that the map frame of pictures
/// counts from the pixel's corner.
struct PinholeCamera {
  double fx = 525, fy = 525;      ///< pixels
  double cx = 319.5, cy = 239.5;  ///< pixels

  constexpr Vector3 ray(double u, double v) const noexcept { return {(u - cx) / fx, (v - cy) / fy, 1}; }
  /// Finite numbers, fx and fy not zero.
  constexpr bool valid() const noexcept {
    return fx - fx == 0 && fy - fy == 0 && cx - cx == 0 && cy - cy == 0 && fx != 0 && fy != 0;
  }
  constexpr bool operator==(const PinholeCamera&) const noexcept = default;
};

/// A depth frame as the sensor gives it: z along the optical axis, not along the ray; 0 is no reading.
struct DepthView {
  ImageView<const std::uint16_t> raw;
  double metres_per_unit = 0.001;  ///< above zero
  PinholeCamera camera;

  constexpr bool valid() const noexcept {
    return raw.valid() && metres_per_unit > 0 && metres_per_unit - metres_per_unit == 0 && camera.valid();
  }
};

}  // namespace straightedge
