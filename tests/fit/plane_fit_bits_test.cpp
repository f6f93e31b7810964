// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <bit>
#include <cstdint>

#include "straightedge/inverse_depth.hpp"
#include "straightedge/plane_fit.hpp"
#include "straightedge/random.hpp"
#include "support/catch.hpp"
#include "support/drawing.hpp"

using namespace straightedge;

namespace {

/// FNV-1a over the bits of numbers.
class Hash {
 public:
  void add(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    for (unsigned shift = 0; shift < 64; shift += 8) {
      state_ = (state_ ^ ((bits >> shift) & 255U)) * 1099511628211U;
    }
  }
  void add(const Vector3& v) {
    add(v.x);
    add(v.y);
    add(v.z);
  }
  void add(const PlaneFit& fit) {
    for (const Vector3& v : {fit.plane.normal, fit.tangent_u, fit.tangent_v, fit.centroid}) add(v);
    for (const double entry : fit.covariance) add(entry);
    for (const double value : {fit.plane.distance, fit.weight, fit.count, fit.rms}) add(value);
  }
  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 14695981039346656037U;
};

struct SomeMoments {
  PlaneMoments points;
  InverseDepthMoments pixels;
};

SomeMoments some_moments(Pcg32& random) {
  SomeMoments moments;
  for (int i = 0; i < 12; ++i) {
    const double x = support::uniform(random, -1, 1), y = support::uniform(random, -1, 1);
    const double noise = support::uniform(random, -0.1, 0.1), weight = support::uniform(random, 0.5, 2);
    moments.points.add(Vector3{x, y, 2 + 0.3 * x - 0.2 * y + noise}, weight);
    moments.pixels.add(300 * x, 200 * y, 0.5 + 0.1 * x - 0.05 * y + 0.01 * noise);
  }
  return moments;
}

}  // namespace

TEST_CASE("fits have the same bits with every compiler and on every machine") {
  Pcg32 random(3);
  Hash points, pixels, fused;
  for (int i = 0; i < 2000; ++i) {
    const SomeMoments moments = some_moments(random);
    PlaneFit of_points, of_pixels, of_both;
    InverseDepthFit inverse;
    REQUIRE(fit_plane(moments.points, of_points) == Status::ok);
    REQUIRE(fit_inverse_depth(moments.pixels, 1e-3, inverse) == Status::ok);
    REQUIRE(to_plane_fit(inverse, 1e-3, {}, of_pixels) == Status::ok);
    REQUIRE(fuse_planes(of_points, of_pixels, of_both) == Status::ok);
    points.add(of_points);
    pixels.add(of_pixels);
    fused.add(of_both);
    fused.add(plane_chi_square(of_points, of_pixels));
  }
  CHECK(points.value() == 0x1cab3dcf55424e46U);
  CHECK(pixels.value() == 0xcd2cc7dc81d7748fU);
  CHECK(fused.value() == 0x573737c8a6c989f0U);
}
