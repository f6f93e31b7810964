// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/measure_cloud.hpp"

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "support/catch.hpp"

using namespace straightedge;

namespace {

struct Points {
  std::vector<float> x, y, z;
  std::int32_t width = 0;

  void add(double px, double py, double pz) {
    x.push_back(static_cast<float>(px));
    y.push_back(static_cast<float>(py));
    z.push_back(static_cast<float>(pz));
  }
  PointsView view() const {
    PointsView points;
    points.x = x.data();
    points.y = y.data();
    points.z = z.data();
    points.count = x.size();
    points.width = width;
    return points;
  }
};

/// Two walls at a right angle, points on a square grid, noise in all directions.
Points corner(double spacing, double noise) {
  std::mt19937 chance(5);
  std::normal_distribution<double> error(0, noise);
  Points points;
  for (int i = 0; i < 80; ++i) {
    for (int j = 0; j < 80; ++j) {
      const double u = spacing * i, v = spacing * j;
      points.add(u + error(chance), v + error(chance), 2 + error(chance));
      points.add(error(chance), v + error(chance), 2 - u + error(chance));
    }
  }
  return points;
}

/// What a camera of 60 x 40 pixels sees of a slanting wall; `bend` spoils the pinhole.
Points picture(double bend) {
  Points points;
  points.width = 60;
  for (int v = 0; v < 40; ++v) {
    for (int u = 0; u < 60; ++u) {
      const double x = (u - 30) / 50.0, y = (v - 20) / 50.0;
      const double z = 2 / (1 - 0.3 * x);
      points.add((x + bend * y * y) * z, y * z, z);
    }
  }
  return points;
}

}  // namespace

TEST_CASE("noise and spacing of a cloud are those it was made with") {
  for (const double noise : {0.0005, 0.003}) {
    const auto scale = measure_cloud(corner(0.02, noise).view());
    REQUIRE(scale);
    CHECK(scale->noise_m == Approx(noise).epsilon(0.1));
    CHECK(scale->spacing_m == Approx(0.02).epsilon(0.15));
    CHECK_FALSE(scale->picture);
  }
}

TEST_CASE("a depth camera's cloud is known by its rows and columns") {
  const auto is_picture = [](const Points& points) {
    const auto scale = measure_cloud(points.view());
    REQUIRE(scale);
    return scale->picture;
  };
  CHECK(is_picture(picture(0)));
  CHECK_FALSE(is_picture(picture(0.5)));
  Points holes = picture(0);
  for (std::size_t i = 0; i < holes.z.size(); i += 3) holes.z[i] = std::numeric_limits<float>::quiet_NaN();
  CHECK(is_picture(holes));
  Points behind = picture(0);
  behind.z[7] = -1;
  CHECK_FALSE(is_picture(behind));
  Points unordered = picture(0);
  unordered.width = 0;
  CHECK_FALSE(is_picture(unordered));
}

TEST_CASE("clouds that have no scale") {
  Points few, equal, none;
  for (int i = 0; i < 20; ++i) few.add(i, i % 3, 1);
  for (int i = 0; i < 100; ++i) equal.add(1, 2, 3);
  for (int i = 0; i < 100; ++i) none.add(std::nan(""), 0, 0);
  for (const Points* points : {&few, &equal, &none}) {
    const auto scale = measure_cloud(points->view());
    REQUIRE(scale);
    CHECK(scale->noise_m == 0);
    CHECK(scale->spacing_m == 0);
  }
  CHECK(measure_cloud(PointsView{}).failure().problem == Problem::bad_content);
}
