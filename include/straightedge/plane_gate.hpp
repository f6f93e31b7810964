// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

namespace straightedge {

/// How far from a plane a reading may lie and still be one of the plane's.
///
/// Structured-light and stereo sensors measure disparity, so the noise of 1/z is the same everywhere and
/// that of z grows with z²: sigma_z = inverse_sigma · z². K. Khoshelham, S. O. Elberink, "Accuracy and
/// Resolution of Kinect Depth Data for Indoor Mapping Applications", Sensors 12(2), 2012,
/// doi:10.3390/s120201437.
struct PlaneGate {
  double inverse_sigma = 1.425e-3;  ///< standard deviation of 1/z, 1/metre; above 0
  double floor_m = 0.002;           ///< at close range no sensor is better than this, metres; 0 and up
  double sigmas = 3;                ///< the threshold in standard deviations; above 0
  double fixed_m = 0;               ///< above 0: a threshold in metres at every range takes their place

  constexpr bool valid() const noexcept {
    return inverse_sigma > 0 && inverse_sigma < 1 && floor_m >= 0 && floor_m <= 1 && sigmas > 0 &&
           sigmas <= 100 && fixed_m >= 0 && fixed_m <= 1000;
  }
  /// Standard deviation of 1/z where 1/z is q. A fixed threshold in metres is `sigmas` deviations of z, and
  /// d(1/z) = q² dz.
  constexpr double inverse_noise(double q) const noexcept {
    if (fixed_m > 0) return fixed_m / sigmas * q * q;
    const double floor = floor_m * q * q;
    return floor > inverse_sigma ? floor : inverse_sigma;
  }
  /// Metres along the ray's z at this depth.
  constexpr double threshold_m(double z) const noexcept {
    return z > 0 ? sigmas * inverse_noise(1 / z) * z * z : 0;
  }
};

}  // namespace straightedge
