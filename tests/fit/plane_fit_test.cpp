// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/plane_fit.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "plane_error.hpp"
#include "straightedge/random.hpp"
#include "straightedge/trigonometry.hpp"
#include "support/catch.hpp"
#include "support/drawing.hpp"

using namespace straightedge;

namespace {

struct Weighted {
  Vector3 p;
  double w = 1;
};

std::vector<Weighted> cloud(Pcg32& random, int count, double thickness) {
  const auto direction = [&] {
    return normalized(Vector3{support::normal(random), support::normal(random), support::normal(random)});
  };
  const Vector3 n = direction();
  const Vector3 u = normalized(cross(n, direction()));
  const Vector3 v = cross(n, u);
  const double d = support::uniform(random, -5, 5);
  std::vector<Weighted> points;
  for (int i = 0; i < count; ++i) {
    const double off = d + thickness * support::normal(random);
    points.push_back({off * n + support::uniform(random, -2, 2) * u + support::uniform(random, -1, 1) * v,
                      support::uniform(random, 0.2, 4)});
  }
  return points;
}

PlaneMoments moments_of(const std::vector<Weighted>& points) {
  PlaneMoments moments;
  for (const Weighted& p : points) moments.add(p.p, p.w);
  return moments;
}

PlaneFit fit_of(const std::vector<Weighted>& points) {
  PlaneFit fit;
  REQUIRE(fit_plane(moments_of(points), fit) == Status::ok);
  return fit;
}

/// Weighted squares of the distances from the best plane with this normal, point by point.
double cost(const std::vector<Weighted>& points, const Vector3& normal) {
  double weight = 0, mean = 0, sum = 0;
  for (const Weighted& p : points) {
    weight += p.w;
    mean += p.w * dot(normal, p.p);
  }
  mean /= weight;
  for (const Weighted& p : points) sum += p.w * (dot(normal, p.p) - mean) * (dot(normal, p.p) - mean);
  return sum;
}

Status status_of(const std::vector<Vector3>& points) {
  PlaneMoments moments;
  for (const Vector3& p : points) moments.add(p);
  PlaneFit fit;
  return fit_plane(moments, fit);
}

}  // namespace

TEST_CASE("no other normal has smaller squares than the fit's") {
  constexpr std::uint64_t seed = 51;
  CAPTURE(seed);
  Pcg32 random(seed);
  for (int i = 0; i < 100; ++i) {
    CAPTURE(i);
    const std::vector<Weighted> points = cloud(random, 40, 0.1);
    const PlaneFit fit = fit_of(points);
    const double least = cost(points, fit.plane.normal);
    CHECK(fit.rms == Approx(std::sqrt(least / fit.weight)));
    for (int k = 0; k < 200; ++k) {
      const double angle = support::uniform(random, -pi, pi);
      const double step = std::pow(10, support::uniform(random, -5, 0));
      const Vector3 other = normalized(fit.plane.normal + step * std::cos(angle) * fit.tangent_u +
                                       step * std::sin(angle) * fit.tangent_v);
      CHECK(cost(points, other) >= least * (1 - 1e-12));
    }
  }
}

TEST_CASE("a fit has a canonical plane through its centroid and a right-handed basis") {
  constexpr std::uint64_t seed = 52;
  CAPTURE(seed);
  Pcg32 random(seed);
  for (int i = 0; i < 100; ++i) {
    CAPTURE(i);
    const std::vector<Weighted> points = cloud(random, 30, 0.02);
    const PlaneFit fit = fit_of(points);
    CHECK(fit.plane == canonical(fit.plane));
    CHECK(fit.plane.signed_distance(fit.centroid) == Approx(0).margin(1e-13));
    CHECK(length(fit.plane.normal) == Approx(1).epsilon(1e-14));
    CHECK(length(fit.tangent_u) == Approx(1).epsilon(1e-14));
    CHECK(length(cross(fit.tangent_u, fit.tangent_v) - fit.plane.normal) < 1e-14);
    CHECK(fit.count == 30);
    CHECK(fit.covariance[0] >= fit.covariance[3]);
  }
}

TEST_CASE("points on a plane give that plane") {
  PlaneFit fit;
  PlaneMoments moments;
  for (const Vector3& p : {Vector3{0, 0, 2}, {1, 0, 2}, {0, 1, 2}, {4, 3, 2}}) moments.add(p);
  REQUIRE(fit_plane(moments, fit) == Status::ok);
  CHECK(fit.plane.normal.z == Approx(1).epsilon(1e-15));
  CHECK(fit.plane.distance == Approx(2).epsilon(1e-15));
  CHECK(fit.rms < 1e-7);
}

TEST_CASE("three points are enough, also far from the origin and very small") {
  for (const double scale : {1e-6, 1.0, 1e6}) {
    const double shift = 100 * scale;
    PlaneMoments moments;
    for (const Vector3& p : {Vector3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
      moments.add(scale * p + Vector3{shift, shift, shift});
    }
    PlaneFit fit;
    REQUIRE(fit_plane(moments, fit) == Status::ok);
    CHECK(support::angle_between(fit.plane.normal, {1, 1, 1}) < 1e-9);
  }
}

TEST_CASE("points that make no plane are refused and the fit is left alone") {
  const double nan = std::nan(""), inf = HUGE_VAL;
  CHECK(status_of({}) == Status::invalid_option);
  CHECK(status_of({{1, 2, 3}}) == Status::invalid_option);
  CHECK(status_of({{1, 2, 3}, {4, 5, 7}}) == Status::invalid_option);
  CHECK(status_of(std::vector<Vector3>(50, {0.1, 0.7, 3.3})) == Status::invalid_option);
  CHECK(status_of({{0, 0, 0}, {nan, 1, 0}, {1, 0, 0}, {3, 3, 3}}) == Status::invalid_option);
  CHECK(status_of({{0, 0, 0}, {inf, 1, 0}, {1, 0, 0}, {3, 3, 3}}) == Status::invalid_option);
  CHECK(status_of({{0, 0, 0}, {1e200, 1, 0}, {1, -1e200, 0}, {3, 3, 3}}) == Status::invalid_option);
  // A cube's corners: no direction is thinner than another.
  CHECK(status_of({{1, 1, 1},
                   {1, 1, -1},
                   {1, -1, 1},
                   {1, -1, -1},
                   {-1, 1, 1},
                   {-1, 1, -1},
                   {-1, -1, 1},
                   {-1, -1, -1}}) == Status::invalid_option);
  std::vector<Vector3> line;
  for (int i = 0; i < 100; ++i) line.push_back(Vector3{1, 2, 3} + 0.01 * i * Vector3{0.3, -0.77, 0.1});
  CHECK(status_of(line) == Status::invalid_option);

  PlaneMoments weightless;
  for (const Vector3& p : {Vector3{0, 0, 2}, {1, 0, 2}, {0, 1, 2}}) weightless.add(p, 0);
  PlaneFit fit;
  fit.plane.distance = 7;
  CHECK(fit_plane(weightless, fit) == Status::invalid_option);
  CHECK(fit.plane.distance == 7);
}

TEST_CASE("the floor is an error of angle and of offset at the centroid") {
  constexpr std::uint64_t seed = 53;
  CAPTURE(seed);
  Pcg32 random(seed);
  const PlaneFit fit = fit_of(cloud(random, 30, 0.02));
  PlaneFit with_floor = fit;
  const PlaneFloor floor{0.01, 0.02};
  add_floor(with_floor, floor);
  // Seen from the centroid, where angle and offset are apart.
  const std::array<double, 9> same{1, 0, 0, 0, 1, 0, 0, 0, 1};
  const Eigen::Matrix3d added = support::covariance_of(moved(with_floor, same, -fit.centroid)) -
                                support::covariance_of(moved(fit, same, -fit.centroid));
  const Eigen::Matrix3d expected = Eigen::Vector3d(1e-4, 1e-4, 4e-4).asDiagonal();
  CHECK((added - expected).cwiseAbs().maxCoeff() < 1e-15);
}

TEST_CASE("the covariance of normal and distance needs no basis") {
  constexpr std::uint64_t seed = 54;
  CAPTURE(seed);
  Pcg32 random(seed);
  const PlaneFit fit = fit_of(cloud(random, 30, 0.02));
  const Eigen::Matrix4d expected = support::covariance_4x4_of(fit);
  const std::array<double, 10> upper = covariance_4x4(fit);
  std::size_t at = 0;
  for (int i = 0; i < 4; ++i) {
    for (int k = i; k < 4; ++k) CHECK(upper[at++] == Approx(expected(i, k)).epsilon(1e-12).margin(1e-18));
  }
}

// Worked by hand: two planes that cross in the y axis, 15 degrees up and 15 degrees down, each known at a
// place 1 m away from it, to the left and to the right.
TEST_CASE("the chi-square distance of two planes that cross") {
  const double c = std::cos(15 * degree), s = std::sin(15 * degree);
  const double var_angle = 0.04, var_offset = 0.01;
  const auto known_at_centroid = [&](const Vector3& normal, const Vector3& u, const Vector3& centroid) {
    PlaneFit fit;
    fit.plane = {normal, 0};
    fit.tangent_u = u;
    fit.tangent_v = cross(normal, u);
    fit.centroid = centroid;
    const double lever = dot(u, centroid);
    fit.covariance = {var_angle, 0, lever * var_angle, var_angle, 0, var_offset + lever * lever * var_angle};
    return fit;
  };
  const PlaneFit a = known_at_centroid({-s, 0, c}, {c, 0, s}, {-c, 0, -s});
  const PlaneFit b = known_at_centroid({s, 0, c}, {c, 0, -s}, {c, 0, -s});
  // Midway, at (0, 0, -s), both are as far away; each lever is c² long.
  const double between = 30 * degree, lever = c * c, turn = std::cos(between);
  const double uu = var_angle * (1 + turn * turn);
  const double ud = var_angle * lever * (turn - 1);
  const double dd = 2 * (var_offset + lever * lever * var_angle);
  CHECK(plane_chi_square(a, b) == Approx(between * between * dd / (uu * dd - ud * ud)).epsilon(1e-12));
  CHECK(plane_chi_square(b, a) == Approx(plane_chi_square(a, b)).epsilon(1e-12));
}
