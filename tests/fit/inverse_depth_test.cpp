// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/inverse_depth.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "plane_error.hpp"
#include "simulated_patch.hpp"
#include "straightedge/random.hpp"
#include "support/catch.hpp"
#include "support/guarded_image.hpp"

using namespace straightedge;

namespace {

struct Reading {
  double u, v, q;
};

InverseDepthMoments moments_of(const std::vector<Reading>& readings) {
  InverseDepthMoments moments;
  for (const Reading& r : readings) moments.add(r.u, r.v, r.q);
  return moments;
}

Status status_of(const std::vector<Reading>& readings, double sigma = 1e-3) {
  InverseDepthFit fit;
  return fit_inverse_depth(moments_of(readings), sigma, fit);
}

InverseDepthFit some_fit() {
  InverseDepthFit fit;
  REQUIRE(fit_inverse_depth(moments_of({{0, 0, 0.5}, {9, 0, 0.5}, {0, 9, 0.4}, {9, 9, 0.4}}), 1e-3, fit) ==
          Status::ok);
  return fit;
}

Status plane_status(const InverseDepthFit& fit, double sigma = 1e-3, const PinholeCamera& camera = {}) {
  PlaneFit plane;
  plane.count = -5;
  const Status status = to_plane_fit(fit, sigma, camera, plane);
  CHECK((status == Status::ok || plane.count == -5));
  return status;
}

}  // namespace

TEST_CASE("the fit in inverse depth is the least-squares solution of Eigen") {
  constexpr std::uint64_t seed = 71;
  CAPTURE(seed);
  Pcg32 random(seed);
  for (int i = 0; i < 100; ++i) {
    CAPTURE(i);
    const simulated::Patch patch = simulated::random_patch(random, 1, 4 + static_cast<int>(random.below(20)));
    std::vector<Reading> readings;
    simulated::for_each_reading(patch, random, [&](double u, double v, double q) {
      if (random.below(3) != 0) readings.push_back({u, v, q});
    });
    constexpr int most_rows = 23 * 23;
    const auto rows = static_cast<Eigen::Index>(readings.size());
    Eigen::Matrix<double, Eigen::Dynamic, 3, 0, most_rows, 3> a(rows, 3);
    Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_rows, 1> q(rows);
    for (Eigen::Index k = 0; k < rows; ++k) {
      const Reading& r = readings[static_cast<std::size_t>(k)];
      a.row(k) << r.u, r.v, 1;
      q(k) = r.q;
    }
    InverseDepthFit fit;
    REQUIRE(fit_inverse_depth(moments_of(readings), 0.002, fit) == Status::ok);
    const Eigen::Vector3d expected = a.colPivHouseholderQr().solve(q);
    CHECK(fit.plane.a == Approx(expected(0)).epsilon(1e-8).margin(1e-12));
    CHECK(fit.plane.b == Approx(expected(1)).epsilon(1e-8).margin(1e-12));
    CHECK(fit.plane.c == Approx(expected(2)).epsilon(1e-8).margin(1e-9));
    CHECK(fit.rms == Approx((a * expected - q).norm() / std::sqrt(static_cast<double>(rows))).epsilon(1e-6));
    const Eigen::Matrix3d covariance = 0.002 * 0.002 * (a.transpose() * a).inverse();
    const double entries[] = {covariance(0, 0), covariance(0, 1), covariance(0, 2),
                              covariance(1, 1), covariance(1, 2), covariance(2, 2)};
    for (std::size_t k = 0; k < 6; ++k)
      CHECK(fit.covariance[k] == Approx(entries[k]).epsilon(1e-5).margin(1e-12));
  }
}

TEST_CASE("a plane becomes coefficients and the same plane again") {
  constexpr std::uint64_t seed = 72;
  CAPTURE(seed);
  Pcg32 random(seed);
  for (const PinholeCamera& camera :
       {PinholeCamera{525, 525, 319.5, 239.5}, {525, -525, 319.5, 239.5}, {-300, 310, -50, 900}}) {
    for (int i = 0; i < 100; ++i) {
      CAPTURE(i, camera.fx, camera.fy);
      const Vector3 ray = camera.ray(100, 200);
      Plane truth{normalized({support::normal(random), support::normal(random), support::normal(random)}), 0};
      truth.distance = support::uniform(random, 0.5, 8) * dot(truth.normal, ray);
      truth = canonical(truth);
      const InverseDepthPlane expected = to_inverse_depth(truth, camera);
      InverseDepthMoments moments;
      for (int v = 190; v < 211; ++v) {
        for (int u = 90; u < 111; ++u) {
          const double z = truth.distance / dot(truth.normal, camera.ray(u, v));
          CHECK(expected.at(u, v) == Approx(1 / z).epsilon(1e-9).margin(1e-12));
          moments.add(u, v, 1 / z);
        }
      }
      InverseDepthFit fit;
      PlaneFit plane;
      REQUIRE(fit_inverse_depth(moments, 1e-3, fit) == Status::ok);
      REQUIRE(to_plane_fit(fit, 1e-3, camera, plane) == Status::ok);
      CHECK(length(plane.plane.normal - truth.normal) < 1e-8);
      CHECK(plane.plane.distance == Approx(truth.distance).epsilon(1e-8));
      CHECK(truth.signed_distance(plane.centroid) == Approx(0).margin(1e-8));
      CHECK(plane.centroid.x == Approx(plane.centroid.z * camera.ray(100, 200).x).margin(1e-12));
      CHECK(plane.count == 441);
      CHECK(length(cross(plane.tangent_u, plane.tangent_v) - plane.plane.normal) < 1e-14);
    }
  }
}

TEST_CASE("weight and rms are those of the points along z and along the normal") {
  constexpr std::uint64_t seed = 73;
  CAPTURE(seed);
  Pcg32 random(seed);
  const simulated::Patch patch = simulated::patch_at(2.5, 0.7, 0.3, 300, 200, 40);
  InverseDepthMoments moments;
  double squares = 0;
  simulated::for_each_reading(patch, random, [&](double u, double v, double q) {
    moments.add(u, v, q);
    const double off = patch.truth.signed_distance((1 / q) * simulated::camera.ray(u, v));
    squares += off * off;
  });
  InverseDepthFit fit;
  PlaneFit plane;
  REQUIRE(fit_inverse_depth(moments, simulated::sigma, fit) == Status::ok);
  REQUIRE(to_plane_fit(fit, simulated::sigma, simulated::camera, plane) == Status::ok);
  const double sigma_z = simulated::sigma * 2.5 * 2.5;
  CHECK(plane.weight == Approx(1600 / (sigma_z * sigma_z)).epsilon(0.01));
  CHECK(plane.rms == Approx(std::sqrt(squares / 1600)).epsilon(0.05));
  CHECK(fit.rms == Approx(simulated::sigma).epsilon(0.05));
}

TEST_CASE("pixels that make no plane are refused") {
  const double nan = std::nan(""), inf = HUGE_VAL;
  CHECK(status_of({}) == Status::invalid_option);
  CHECK(status_of({{1, 1, 1}, {2, 5, 1}}) == Status::invalid_option);
  CHECK(status_of(std::vector<Reading>(20, {639, 479, 0.3})) == Status::invalid_option);
  CHECK(status_of({{0, 0, 1}, {9, 0, 1}, {0, 9, nan}}) == Status::invalid_option);
  CHECK(status_of({{0, 0, 1}, {9, 0, 1}, {0, 9, inf}}) == Status::invalid_option);
  CHECK(status_of({{0, 0, 1}, {9, 0, 1}, {nan, 9, 1}}) == Status::invalid_option);
  std::vector<Reading> level, slanted;
  for (int i = 0; i < 300; ++i) {
    level.push_back({300.0 + i, 417, 0.3});
    slanted.push_back({300.0 + i, 401.0 - i, 0.3});
  }
  CHECK(status_of(level) == Status::invalid_option);
  CHECK(status_of(slanted) == Status::invalid_option);
  slanted.push_back({300, 400, 0.3});
  CHECK(status_of(slanted) == Status::ok);
  for (const double sigma : {0.0, -1.0, nan, inf}) {
    CHECK(status_of({{0, 0, 1}, {9, 0, 1}, {0, 9, 1}}, sigma) == Status::invalid_option);
  }
}

TEST_CASE("planes that no camera sees are refused") {
  const double nan = std::nan(""), inf = HUGE_VAL;
  CHECK(plane_status(some_fit()) == Status::ok);
  InverseDepthFit through_centre = some_fit();
  through_centre.plane.a = 1e200;
  through_centre.plane.c = 0;
  CHECK(plane_status(through_centre) == Status::invalid_option);
  InverseDepthFit behind = some_fit();
  behind.plane = {0, 0, -0.5};
  CHECK(plane_status(behind) == Status::invalid_option);
  behind.plane = {0, 0, 0};
  CHECK(plane_status(behind) == Status::invalid_option);
  for (const double bad : {nan, inf}) {
    InverseDepthFit broken = some_fit();
    broken.plane.b = bad;
    CHECK(plane_status(broken) == Status::invalid_option);
    broken = some_fit();
    broken.covariance[3] = bad;
    CHECK(plane_status(broken) == Status::invalid_option);
    broken = some_fit();
    broken.mean_u = bad;
    CHECK(plane_status(broken) == Status::invalid_option);
    CHECK(plane_status(some_fit(), bad) == Status::invalid_option);
    CHECK(plane_status(some_fit(), 1e-3, {bad, 1, 0, 0}) == Status::invalid_option);
  }
  CHECK(plane_status(some_fit(), 0) == Status::invalid_option);
  CHECK(plane_status(some_fit(), 1e-3, {0, 1, 0, 0}) == Status::invalid_option);
  CHECK(plane_status(InverseDepthFit{}) == Status::invalid_option);
  CHECK(to_inverse_depth({{1, 0, 0}, 0}, {}) == InverseDepthPlane{});
  CHECK(to_inverse_depth({{1, 0, 0}, nan}, {}) == InverseDepthPlane{});
}

TEST_CASE("inverse depth of every raw value is one rounded division, and zero stays zero") {
  for (const double unit : {0.001, 0.0002, 1.0, 0.03}) {
    support::GuardedImage<std::uint16_t> raw({256, 256});
    support::GuardedImage<float> out({256, 256}, 3, -1.0F);
    for (int i = 0; i < 65536; ++i) raw.at(i % 256, i / 256) = static_cast<std::uint16_t>(i);
    REQUIRE(inverse_depth_image({raw.view(), unit, {}}, out.view()) == Status::ok);
    REQUIRE(out.guards_intact());
    const auto per_metre = static_cast<float>(1 / unit);
    int wrong = out.at(0, 0) == 0 && !std::signbit(out.at(0, 0)) ? 0 : 1;
    for (int i = 1; i < 65536; ++i) {
      const float q = out.at(i % 256, i / 256);
      const double exact = 1 / (i * unit);
      wrong +=
          q == per_metre / static_cast<float>(i) && std::fabs(static_cast<double>(q) / exact - 1) < 1.2e-7
              ? 0
              : 1;
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("inverse depth of narrow pictures with gaps between their rows") {
  constexpr std::uint64_t seed = 74;
  CAPTURE(seed);
  Pcg32 random(seed);
  for (int width = 1; width < 40; ++width) {
    CAPTURE(width);
    support::GuardedImage<std::uint16_t> raw({width, 3}, 1 + width % 4);
    support::GuardedImage<float> out({width, 3}, width % 3, -1.0F);
    for (int i = 0; i < 3 * width; ++i) {
      raw.at(i % width, i / width) = static_cast<std::uint16_t>(random.below(2) * random.below(9000));
    }
    REQUIRE(inverse_depth_image({raw.view(), 0.001, {}}, out.view()) == Status::ok);
    REQUIRE(out.guards_intact());
    for (int i = 0; i < 3 * width; ++i) {
      const int value = raw.at(i % width, i / width);
      CHECK(out.at(i % width, i / width) == (value == 0 ? 0.0F : 1000.0F / static_cast<float>(value)));
    }
  }
}

TEST_CASE("bad depth frames are refused") {
  support::GuardedImage<std::uint16_t> raw({4, 3});
  support::GuardedImage<float> out({4, 3}), other({3, 4});
  const DepthView good{raw.view(), 0.001, {}};
  CHECK(inverse_depth_image(good, out.view()) == Status::ok);
  CHECK(inverse_depth_image(good, other.view()) == Status::size_mismatch);
  CHECK(inverse_depth_image(good, {}) == Status::invalid_image);
  CHECK(inverse_depth_image({}, out.view()) == Status::invalid_image);
  for (const double unit : {0.0, -0.001, std::nan(""), HUGE_VAL}) {
    CHECK(inverse_depth_image({raw.view(), unit, {}}, out.view()) == Status::invalid_image);
  }
  for (const double unit : {1e-300, 1e-39, 1e31}) {
    CHECK(inverse_depth_image({raw.view(), unit, {}}, out.view()) == Status::invalid_option);
  }
  CHECK(inverse_depth_image({raw.view(), 0.001, {0, 525, 0, 0}}, out.view()) == Status::invalid_image);
}

TEST_CASE("the floor in inverse depth, by hand") {
  const PinholeCamera camera{525, 525, 319.5, 239.5};
  const InverseDepthPlane floor = to_inverse_depth({{0, 1, 0}, 1.2}, camera);
  CHECK(floor.a == 0);
  CHECK(floor.b == Approx(1 / 630.0));
  CHECK(floor.c == Approx(-239.5 / 630));
  CHECK(1 / floor.at(0, 479) == Approx(2.63).epsilon(0.001));
  CHECK(1 / floor.at(600, 300) == Approx(10.4).epsilon(0.002));
  CHECK(floor.at(300, 239.5) == Approx(0).margin(1e-15));
}
