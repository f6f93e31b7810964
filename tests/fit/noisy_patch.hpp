// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>

#include "plane_error.hpp"
#include "straightedge/plane_fit.hpp"
#include "straightedge/random.hpp"
#include "straightedge/trigonometry.hpp"
#include "support/catch.hpp"
#include "support/drawing.hpp"

/// Patches of planes seen from 2 to 3.5 m, whose points have noise along the normal, and what to expect of
/// many.
namespace noisy {

using namespace straightedge;

inline constexpr int trials = 3000;
// The mean of `trials` chi-square numbers of 3 degrees of freedom scatters by sqrt(6 / trials), a share p of
// events by sqrt(p (1 − p) / trials). Four of those: one seed in 16 000 would fail by chance.
inline const double mean_tolerance = 4 * std::sqrt(6.0 / trials);
inline const double share_tolerance = 4 * std::sqrt(0.01 * 0.99 / trials);

struct Patch {
  Vector3 centre, u, v, normal;
};

/// A patch 2 to 3.5 m from the origin, tilted by up to 60 degrees against the way to it.
inline Patch random_patch(Pcg32& random) {
  const Vector3 along =
      normalized({support::uniform(random, -0.5, 0.5), support::uniform(random, -0.4, 0.4), 1});
  const double tilt = support::uniform(random, 0, 60 * degree), turn = support::uniform(random, -pi, pi);
  const Vector3 aside = normalized(cross(along, {0, 1, 0}));
  const Vector3 lean = std::cos(turn) * aside + std::sin(turn) * cross(along, aside);
  const Vector3 normal = std::cos(tilt) * along + std::sin(tilt) * lean;
  const Vector3 u = normalized(cross(normal, {0, 1, 0}));
  return {support::uniform(random, 2, 3.5) * along, u, cross(normal, u), normal};
}

inline Plane plane_of(const Patch& patch) {
  return canonical({patch.normal, dot(patch.normal, patch.centre)});
}

/// Points from `from` to `to` along u, each with noise of its own along the normal.
inline PlaneMoments noisy_moments(const Patch& patch, double from, double to, int count, Pcg32& random) {
  PlaneMoments moments;
  for (int i = 0; i < count; ++i) {
    const double sigma = support::uniform(random, 0.004, 0.02);
    moments.add(patch.centre + support::uniform(random, from, to) * patch.u +
                    support::uniform(random, -0.3, 0.3) * patch.v +
                    sigma * support::normal(random) * patch.normal,
                1 / (sigma * sigma));
  }
  return moments;
}

inline PlaneFit fit_of(const PlaneMoments& moments) {
  PlaneFit fit;
  REQUIRE(fit_plane(moments, fit) == Status::ok);
  return fit;
}

inline PlaneFit noisy_fit(const Patch& patch, double from, double to, Pcg32& random) {
  return fit_of(noisy_moments(patch, from, to, 100, random));
}

struct Motion {
  std::array<double, 9> rotation{};
  Vector3 t;

  Vector3 operator()(const Vector3& p) const {
    const auto& r = rotation;
    return Vector3{r[0] * p.x + r[1] * p.y + r[2] * p.z, r[3] * p.x + r[4] * p.y + r[5] * p.z,
                   r[6] * p.x + r[7] * p.y + r[8] * p.z} +
           t;
  }
};

inline Motion random_motion(Pcg32& random) {
  const Eigen::Vector3d axis(support::normal(random), support::normal(random), support::normal(random));
  const Eigen::Matrix3d r =
      Eigen::AngleAxisd(support::uniform(random, -pi, pi), axis.normalized()).toRotationMatrix();
  return {
      {r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1), r(2, 2)},
      {support::uniform(random, -9, 9), support::uniform(random, -9, 9), support::uniform(random, -9, 9)}};
}

struct Gated {
  double mean = 0, rejected = 0;
};

template <class Draw>
Gated gate_of(Draw&& draw) {
  Gated gated;
  for (int i = 0; i < trials; ++i) {
    const double distance = draw();
    gated.mean += distance / trials;
    gated.rejected += distance > 11.34 ? 1.0 / trials : 0;
  }
  return gated;
}

inline void check_same_covariance(const PlaneFit& a, const PlaneFit& b, double tolerance) {
  const auto left = covariance_4x4(a), right = covariance_4x4(b);
  double largest = 0;
  for (const double entry : right) largest = std::max(largest, std::fabs(entry));
  for (std::size_t i = 0; i < left.size(); ++i) {
    CHECK(left[i] == Approx(right[i]).margin(tolerance * largest));
  }
}

}  // namespace noisy
