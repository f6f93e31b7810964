// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <vector>

#include "cloud_testing.hpp"
#include "support/catch.hpp"

using namespace straightedge;
using test::Cloud;
using test::CloudFound;
using test::corner;
using test::find_planes;
using test::options_for;

namespace {

constexpr HoughPlaneVoting votings[] = {HoughPlaneVoting::standard, HoughPlaneVoting::randomized};

/// A quarter turn about an axis: x to y, y to z or z to x.
Vector3 quarter_turn(const Vector3& p, int axis) {
  if (axis == 0) return {p.x, -p.z, p.y};
  if (axis == 1) return {p.z, p.y, -p.x};
  return {-p.y, p.x, p.z};
}

/// The votes in the highest cell of a plane that every point votes for, after low-pass.
double highest_peak(const Cloud& cloud, HoughCells cells) {
  HoughPlaneOptions options = options_for(HoughPlaneVoting::standard);
  options.accumulator = {cells, 30, 64};
  options.every = 1;
  double highest = 0;
  const auto watch = [](void* user, const HoughPlaneEvent& event) {
    if (event.step != HoughPlaneStep::peak) return true;
    *static_cast<double*>(user) = event.votes;
    return false;
  };
  const CloudFound found = find_planes(cloud.view(), options, 64, {watch, &highest});
  CHECK(found.status == Status::cancelled);
  return highest;
}

/// A disc across the normal, and far from it a few points that keep the bounding box the same for all.
Cloud tilted(const Vector3& normal, std::uint64_t seed) {
  Pcg32 random(seed);
  Cloud cloud;
  cloud.add_disc(1.2 * normal, normal, 1, 1500, 0, random);
  for (const double corner : {-3.0, 3.0}) cloud.add({corner, corner, corner});
  return cloud;
}

double spread(HoughCells cells, const std::vector<Vector3>& normals) {
  double least = 1e9, most = 0;
  for (const Vector3& normal : normals) {
    const double votes = highest_peak(tilted(normal, 4), cells);
    least = std::min(least, votes);
    most = std::max(most, votes);
  }
  return most / least;
}

}  // namespace

TEST_CASE("a cloud turned by 90 degrees has the same planes, turned") {
  const Cloud cloud = corner(21);
  for (const HoughPlaneVoting voting : votings) {
    const CloudFound found = find_planes(cloud.view(), options_for(voting));
    REQUIRE(found.planes.size() == 4);
    for (int axis = 0; axis < 3; ++axis) {
      Cloud turned;
      for (std::size_t i = 0; i < cloud.size(); ++i) turned.add(quarter_turn(cloud.view().at(i), axis));
      const CloudFound again = find_planes(turned.view(), options_for(voting));
      INFO("voting " << static_cast<int>(voting) << " axis " << axis);
      REQUIRE(again.planes.size() == 4);
      for (const FoundPlane& plane : found.planes) {
        const Plane expected =
            canonical({quarter_turn(plane.fit.plane.normal, axis), plane.fit.plane.distance});
        CHECK(test::has(again, expected, 3e-3, 3e-3));
      }
    }
  }
}

TEST_CASE("standard: the order of the points changes nothing but the labels' places") {
  const Cloud cloud = corner(22);
  Cloud mixed;
  std::vector<std::size_t> order(cloud.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  Pcg32 random(23);
  for (std::size_t i = order.size() - 1; i > 0; --i) {
    std::swap(order[i], order[random.below(static_cast<std::uint32_t>(i + 1))]);
  }
  for (const std::size_t i : order) mixed.add(cloud.view().at(i));
  HoughPlaneOptions options = options_for(HoughPlaneVoting::standard);
  options.every = 1;
  const CloudFound found = find_planes(cloud.view(), options);
  const CloudFound again = find_planes(mixed.view(), options);
  REQUIRE(found.planes.size() == again.planes.size());
  for (std::size_t i = 0; i < found.planes.size(); ++i) {
    CHECK(length(found.planes[i].fit.plane.normal - again.planes[i].fit.plane.normal) < 1e-9);
    CHECK(found.planes[i].score == again.planes[i].score);
  }
  std::size_t different = 0;
  for (std::size_t i = 0; i < order.size(); ++i)
    different += again.labels[i] != found.labels[order[i]] ? 1 : 0;
  CHECK(different <= 2);
  CHECK(std::ranges::equal(found.search->accumulator().votes(), again.search->accumulator().votes()));
}

TEST_CASE("the same seed gives the same bits, another seed the same planes") {
  const Cloud cloud = corner(24);
  HoughPlaneOptions options = options_for(HoughPlaneVoting::randomized);
  const CloudFound first = find_planes(cloud.view(), options);
  const CloudFound second = find_planes(cloud.view(), options);
  CHECK(first.labels == second.labels);
  CHECK(first.found.iterations == second.found.iterations);
  for (std::size_t i = 0; i < first.planes.size(); ++i) {
    CHECK(first.planes[i].fit.plane == second.planes[i].fit.plane);
  }
  for (std::uint64_t seed = 2; seed < 12; ++seed) {
    options.seed = seed;
    const CloudFound other = find_planes(cloud.view(), options);
    INFO("seed " << seed);
    CHECK(test::has_corner(other));
    CHECK(other.found.seed == seed);
  }
}

TEST_CASE("arrays of structs and separate arrays are read alike") {
  const Cloud cloud = corner(25);
  struct Point {
    float unused, x, y, z;
  };
  std::vector<Point> points;
  for (std::size_t i = 0; i < cloud.size(); ++i) points.push_back({-1, cloud.x[i], cloud.y[i], cloud.z[i]});
  const PointsView view{&points[0].x, &points[0].y, &points[0].z, points.size(), sizeof(Point)};
  for (const HoughPlaneVoting voting : votings) {
    CHECK(find_planes(view, options_for(voting)).labels ==
          find_planes(cloud.view(), options_for(voting)).labels);
  }
}

TEST_CASE("the ball judges fairly: a plane has much the same votes whichever way it faces") {
  const std::uint64_t seed = 26;
  Pcg32 random(seed);
  std::vector<Vector3> normals{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}};
  for (int i = 0; i < 45; ++i) normals.push_back(test::random_direction(random));
  INFO("seed " << seed);
  const double ball = spread(HoughCells::ball, normals);
  const double array = spread(HoughCells::array, normals);
  CHECK(ball < 1.9);
  CHECK(array > ball);
}

TEST_CASE("planes at the poles are found as well as any others") {
  Pcg32 random(27);
  for (const Vector3& pole : {Vector3{0, 0, 1}, Vector3{0, 0, -1}}) {
    for (const HoughPlaneVoting voting : votings) {
      const Vector3 tilt = normalized(pole + Vector3{0.01, -0.02, 0});
      Cloud cloud;
      cloud.add_disc(1.5 * tilt, tilt, 1, 2000, 0.002, random);
      cloud.add_disc({2, 0, 0}, {1, 0, 0}, 1, 2000, 0.002, random);
      const CloudFound found = find_planes(cloud.view(), options_for(voting));
      CHECK(found.planes.size() == 2);
      CHECK(test::has(found, test::plane_of(tilt, 1.5), 0.002, 0.003));
    }
  }
}

TEST_CASE("planes through the middle of the cloud are found, whichever sign their normal takes") {
  Pcg32 random(28);
  for (int i = 0; i < 10; ++i) {
    const Vector3 normal = test::random_direction(random);
    Cloud cloud;
    cloud.add_disc({0, 0, 0}, normal, 1, 2000, 0.003, random);
    for (const HoughPlaneVoting voting : votings) {
      const CloudFound found = find_planes(cloud.view(), options_for(voting));
      REQUIRE(found.planes.size() == 1);
      const double angle = test::angle_between(found.planes[0].fit.plane.normal, normal);
      CHECK((angle < 0.003 || angle > pi - 0.003));
      CHECK(found.planes[0].inliers == 2000);
    }
  }
}
