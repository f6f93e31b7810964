// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/found_planes.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "plane_error.hpp"
#include "simulated_patch.hpp"
#include "straightedge/random.hpp"
#include "support/catch.hpp"

using namespace straightedge;

namespace {

struct Cloud {
  // As in a cloud with colours: more than the three numbers between two points.
  struct Point {
    float x, y, z;
    std::uint32_t colour = 0xdeadbeef;
  };
  std::vector<Point> points;

  void add(const Vector3& p) {
    points.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
  }
  PointsView view() const { return {&points[0].x, &points[0].y, &points[0].z, points.size(), sizeof(Point)}; }
};

Cloud random_cloud(Pcg32& random, int count) {
  Cloud cloud;
  const float bad[] = {std::nanf(""), HUGE_VALF, -HUGE_VALF};
  for (int i = 0; i < count; ++i) {
    cloud.add({support::uniform(random, -2, 2), support::uniform(random, -2, 2),
               support::uniform(random, -0.5, 5)});
    if (random.below(20) == 0) cloud.points.back().x = bad[random.below(3)];
    if (random.below(20) == 0) cloud.points.back().y = bad[random.below(3)];
    if (random.below(20) == 0) cloud.points.back().z = bad[random.below(3)];
  }
  return cloud;
}

std::vector<FoundPlane> random_planes(Pcg32& random, std::size_t count) {
  std::vector<FoundPlane> planes(count);
  for (FoundPlane& plane : planes) {
    const Vector3 n{support::normal(random), support::normal(random), support::normal(random)};
    plane.fit.plane = canonical({normalized(n), support::uniform(random, 0.2, 4)});
  }
  return planes;
}

/// One point after the other, one plane after the other, the depth predicted along the ray.
std::uint16_t naive_label(const Vector3& p, const std::vector<FoundPlane>& planes, const PlaneGate& gate) {
  if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return 0;
  if (gate.fixed_m == 0 && p.z <= 0) return 0;
  double best = HUGE_VAL;
  std::uint16_t label = 0;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const Plane& plane = planes[i].fit.plane;
    const double inverse = dot(plane.normal, (1 / p.z) * p) / plane.distance;
    const double residual =
        gate.fixed_m > 0 ? std::fabs(plane.signed_distance(p)) : std::fabs(1 / p.z - inverse);
    const double threshold = gate.fixed_m > 0 ? gate.fixed_m : gate.sigmas * gate.inverse_sigma;
    if (residual <= threshold && residual < best) {
      best = residual;
      label = static_cast<std::uint16_t>(i + 1);
    }
  }
  return label;
}

std::vector<std::uint16_t> labels_of(const Cloud& cloud, const std::vector<FoundPlane>& planes,
                                     const PlaneGate& gate) {
  std::vector<std::uint16_t> labels(cloud.points.size(), 9999);
  std::uint32_t labelled = 0;
  REQUIRE(label_nearest(cloud.view(), planes, gate, labels, labelled) == Status::ok);
  std::uint32_t counted = 0;
  for (const std::uint16_t label : labels) counted += label != 0 ? 1U : 0U;
  CHECK(labelled == counted);
  return labels;
}

constexpr PlaneGate kinect{.floor_m = 0, .sigmas = 20};
constexpr PlaneGate fixed{.fixed_m = 0.05};

}  // namespace

TEST_CASE("labels are those of a point by point search") {
  constexpr std::uint64_t seed = 91;
  CAPTURE(seed);
  Pcg32 random(seed);
  for (int i = 0; i < 40; ++i) {
    const Cloud cloud = random_cloud(random, 1 + static_cast<int>(random.below(700)));
    const std::vector<FoundPlane> planes = random_planes(random, random.below(12));
    for (const PlaneGate& gate : {kinect, fixed}) {
      const std::vector<std::uint16_t> labels = labels_of(cloud, planes, gate);
      for (std::size_t k = 0; k < labels.size(); ++k) {
        CAPTURE(i, k, gate.fixed_m);
        CHECK(labels[k] == naive_label(cloud.view().at(k), planes, gate));
      }
    }
  }
}

TEST_CASE("of equally near planes the first one gets the point, and the gate is inclusive") {
  std::vector<FoundPlane> planes(3);
  planes[0].fit.plane = {{0, 0, 1}, 3};
  planes[1].fit.plane = {{0, 0, 1}, 2};
  planes[2].fit.plane = {{0, 0, 1}, 2};
  Cloud cloud;
  for (const double z : {2.0, 2.5, 3.0, 3.5, 3.75, 1.5, 1.25}) cloud.add({1, 1, z});
  CHECK(labels_of(cloud, planes, {.fixed_m = 0.5}) == std::vector<std::uint16_t>{2, 1, 1, 1, 0, 2, 0});
}

TEST_CASE("behind the sensor and through the sensor there are planes for fixed gates alone") {
  std::vector<FoundPlane> planes(2);
  planes[0].fit.plane = {{0, 0, 1}, 0};
  planes[1].fit.plane = {{0, 0, -1}, 2};
  Cloud cloud;
  for (const double z : {0.0, 1e-3, -2.0}) cloud.add({1, 1, z});
  CHECK(labels_of(cloud, planes, fixed) == std::vector<std::uint16_t>{1, 1, 2});
  CHECK(labels_of(cloud, planes, kinect) == std::vector<std::uint16_t>{0, 0, 0});
}

TEST_CASE("a plane that is no number gets no points") {
  std::vector<FoundPlane> planes(2);
  planes[0].fit.plane = {{std::nan(""), 0, 1}, 2};
  planes[1].fit.plane = {{0, 0, 1}, HUGE_VAL};
  Cloud cloud;
  for (const double z : {1.0, 2.0, 3.0}) cloud.add({1, 1, z});
  CHECK(labels_of(cloud, planes, fixed) == std::vector<std::uint16_t>{0, 0, 0});
  CHECK(labels_of(cloud, planes, kinect) == std::vector<std::uint16_t>{0, 0, 0});
}

TEST_CASE("refitting with a fixed gate is the orthogonal fit of each plane's points") {
  constexpr std::uint64_t seed = 92;
  CAPTURE(seed);
  Pcg32 random(seed);
  const Cloud cloud = random_cloud(random, 5000);
  std::vector<FoundPlane> planes = random_planes(random, 40);
  std::vector<std::uint16_t> labels(5000);
  for (std::uint16_t& label : labels) label = static_cast<std::uint16_t>(random.below(45));
  REQUIRE(refit_labelled(cloud.view(), labels, fixed, planes) == Status::ok);
  for (std::size_t i = 0; i < planes.size(); ++i) {
    CAPTURE(i);
    PlaneMoments moments;
    for (std::size_t k = 0; k < labels.size(); ++k) {
      const Vector3 p = cloud.view().at(k);
      if (labels[k] == i + 1 && finite(p)) moments.add(p, 1 / (0.05 / 3 * 0.05 / 3));
    }
    PlaneFit expected;
    REQUIRE(fit_plane(moments, expected) == Status::ok);
    CHECK(planes[i].inliers == moments.count);
    CHECK(length(planes[i].fit.plane.normal - expected.plane.normal) < 1e-9);
    CHECK(planes[i].fit.plane.distance == Approx(expected.plane.distance).margin(1e-9));
    CHECK(planes[i].fit.weight == Approx(expected.weight));
    CHECK(planes[i].fit.rms == Approx(expected.rms));
    for (std::size_t k = 0; k < 10; ++k) {
      CHECK(covariance_4x4(planes[i].fit)[k] == Approx(covariance_4x4(expected)[k]).margin(1e-12));
    }
  }
}

TEST_CASE("refitting a depth sensor's points is the fit of its pixels in inverse depth") {
  constexpr std::uint64_t seed = 93;
  CAPTURE(seed);
  Pcg32 random(seed);
  Cloud cloud;
  std::vector<std::uint16_t> labels;
  std::vector<InverseDepthMoments> pixels(20);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const simulated::Patch patch = simulated::random_patch(random, 1, 30);
    simulated::for_each_reading(patch, random, [&](double u, double v, double q) {
      cloud.add((1 / q) * simulated::camera.ray(u, v));
      labels.push_back(static_cast<std::uint16_t>(i + 1));
      pixels[i].add(u, v, q);
    });
    cloud.add({0, 0, -1});  // readings behind the sensor do not count
    labels.push_back(static_cast<std::uint16_t>(i + 1));
  }
  std::vector<FoundPlane> planes(pixels.size());
  REQUIRE(refit_labelled(cloud.view(), labels, {}, planes) == Status::ok);
  for (std::size_t i = 0; i < planes.size(); ++i) {
    CAPTURE(i);
    InverseDepthFit inverse;
    PlaneFit expected;
    REQUIRE(fit_inverse_depth(pixels[i], simulated::sigma, inverse) == Status::ok);
    REQUIRE(to_plane_fit(inverse, simulated::sigma, simulated::camera, expected) == Status::ok);
    CHECK(planes[i].inliers == 900);
    CHECK(length(planes[i].fit.plane.normal - expected.plane.normal) < 1e-5);
    CHECK(planes[i].fit.plane.distance == Approx(expected.plane.distance).epsilon(1e-5));
    CHECK(length(planes[i].fit.centroid - expected.centroid) < 1e-5);
    for (std::size_t k = 0; k < 10; ++k) {
      const double largest = std::max(covariance_4x4(expected)[0], covariance_4x4(expected)[9]);
      CHECK(covariance_4x4(planes[i].fit)[k] == Approx(covariance_4x4(expected)[k]).margin(1e-3 * largest));
    }
  }
}

TEST_CASE("a plane with too few points keeps its fit") {
  Cloud cloud;
  for (const Vector3& p : {Vector3{0, 0, 2}, {1, 0, 2}, {0, 0, 3}, {1, 1, 3}, {2, 2, 3}}) cloud.add(p);
  for (const PlaneGate& gate : {kinect, fixed}) {
    std::vector<FoundPlane> planes(3);
    for (FoundPlane& plane : planes) plane.fit.plane = {{1, 0, 0}, 7};
    // Two points; three on one line; none.
    REQUIRE(refit_labelled(cloud.view(), std::vector<std::uint16_t>{1, 1, 2, 2, 2}, gate, planes) ==
            Status::ok);
    for (const FoundPlane& plane : planes) CHECK(plane.fit.plane == Plane{{1, 0, 0}, 7});
    CHECK(planes[0].inliers == 2);
    CHECK(planes[1].inliers == 3);
    CHECK(planes[2].inliers == 0);
  }
}

TEST_CASE("views, gates and labels that make no sense are refused") {
  Cloud cloud;
  for (int i = 0; i < 4; ++i) cloud.add({1.0 * i, 1, 2});
  std::vector<FoundPlane> planes(1);
  std::vector<std::uint16_t> labels(4), short_labels(3);
  std::uint32_t labelled = 77;
  CHECK(label_nearest({}, planes, {}, labels, labelled) == Status::invalid_image);
  CHECK(labelled == 0);
  CHECK(refit_labelled({}, labels, {}, planes) == Status::invalid_image);
  CHECK(label_nearest(cloud.view(), planes, {}, short_labels, labelled) == Status::size_mismatch);
  CHECK(refit_labelled(cloud.view(), short_labels, {}, planes) == Status::size_mismatch);
  for (const PlaneGate& gate : {PlaneGate{.inverse_sigma = 0}, {.sigmas = std::nan("")}, {.fixed_m = -1}}) {
    CHECK(label_nearest(cloud.view(), planes, gate, labels, labelled) == Status::invalid_option);
    CHECK(refit_labelled(cloud.view(), labels, gate, planes) == Status::invalid_option);
  }
  const std::vector<FoundPlane> many(65536);
  CHECK(label_nearest(cloud.view(), many, {}, labels, labelled) == Status::too_large);
  const std::span<const FoundPlane> most(many.data(), 65535);
  CHECK(label_nearest(cloud.view(), most, {}, labels, labelled) == Status::ok);
}
