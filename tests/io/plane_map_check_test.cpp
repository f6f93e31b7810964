// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <functional>
#include <limits>

#include "catch.hpp"
#include "io/map_rules.hpp"
#include "random_plane_map.hpp"
#include "straightedge/host/plane_map_file.hpp"

using namespace straightedge;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The one breach that the change causes.
PlaneMapBreach breach_of(const std::function<void(PlaneMap&)>& change) {
  PlaneMap map = small_plane_map();
  change(map);
  const auto breaches = check_plane_map(map);
  REQUIRE(breaches.size() == 1);
  const auto xml = plane_map_to_xml(map);
  REQUIRE_FALSE(xml);
  CHECK(xml.failure().problem == Problem::bad_option);
  CHECK(xml.failure().sentence == "the map breaks a rule of its format: " + breaches[0].sentence);
  return breaches[0];
}

std::string table_breach(const std::function<void(MapPlane&)>& change) {
  const PlaneMapBreach breach = breach_of([&](PlaneMap& map) { change(map.planes[0]); });
  CHECK(breach.plane == std::size_t{0});
  return breach.sentence;
}

std::string polygon_breach(std::size_t polygon, const std::function<void(std::vector<Vector3>&)>& change) {
  const PlaneMapBreach breach =
      breach_of([&](PlaneMap& map) { change(map.planes[0].polygons[polygon].points); });
  CHECK(breach.polygon == polygon);
  return breach.sentence;
}

bool is_good(const std::function<void(MapPlane&)>& change) {
  PlaneMap map = small_plane_map();
  change(map.planes[0]);
  return check_plane_map(map).empty();
}

}  // namespace

TEST_CASE("a good plane map breaks no rule") {
  CHECK(check_plane_map(PlaneMap{}).empty());
  CHECK(check_plane_map(small_plane_map()).empty());
}

TEST_CASE("random good plane maps break no rule") {
  const std::uint32_t seed = 30;
  RandomPlaneMaps maps(seed);
  for (int i = 0; i < 300; ++i) {
    const auto breaches = check_plane_map(maps.next());
    INFO("seed " << seed << ", map " << i << ": " << (breaches.empty() ? "" : breaches[0].sentence));
    REQUIRE(breaches.empty());
  }
}

TEST_CASE("rules of the plane itself") {
  const std::string not_finite = "plane 3: nx, ny, nz or d is not a finite number";
  CHECK(table_breach([](MapPlane& p) { p.plane.normal.y = not_a_number; }) == not_finite);
  CHECK(table_breach([](MapPlane& p) { p.plane.distance = infinity; }) == not_finite);
  CHECK(table_breach([](MapPlane& p) { p.plane.normal.z = 1.1; }) ==
        "plane 3: the length of its normal is not 1 (1.1)");
  CHECK(table_breach([](MapPlane& p) { p.plane.normal.z = 1 + 1e-8; }).find("is not 1") != std::string::npos);
  CHECK(table_breach([](MapPlane& p) { p.plane.normal.z = 0; }) ==
        "plane 3: the length of its normal is not 1 (0)");
  CHECK(table_breach([](MapPlane& p) { p.plane.distance = -0.75; }) == "plane 3: d is negative (-0.75)");
  const auto wrong_sign = [](Vector3 normal) {
    return breach_of([&](PlaneMap& map) { map.planes[1].plane.normal = normal; }).sentence;
  };
  const std::string sentence = "plane 5: d is 0 and the first number of the normal that is not 0 is negative";
  CHECK(wrong_sign({0, -0.6, 0.8}) == sentence);
  CHECK(wrong_sign({-1, 0, 0}) == sentence);
  CHECK(wrong_sign({0, 0, -1}) == sentence);
  CHECK(breach_of([](PlaneMap& map) { map.planes[1].id = 3; }).sentence ==
        "plane 3: another plane has the same id");
  CHECK(is_good([](MapPlane& p) { p.plane.normal.x = 1e-12; }));
  CHECK(is_good([](MapPlane& p) { p.plane.normal.x = -0.0; }));
}

TEST_CASE("rules of the covariance and of the moments") {
  const std::string indefinite = "plane 3: the covariance is not positive semidefinite";
  CHECK(table_breach([](MapPlane& p) { p.covariance->at(3) = infinity; }) ==
        "plane 3: the covariance holds what is not a finite number");
  CHECK(table_breach([](MapPlane& p) { p.covariance->at(0) = -1e-30; }) == indefinite);
  CHECK(table_breach([](MapPlane& p) { p.covariance->at(9) = -1e-30; }) == indefinite);
  CHECK(table_breach([](MapPlane& p) { p.covariance->at(3) = 1.59e-5; }) == indefinite);
  CHECK(table_breach([](MapPlane& p) { p.covariance->at(8) = 1e-8; }) == indefinite);
  CHECK(table_breach([](MapPlane& p) { p.moments->weight = -1; }) ==
        "plane 3: the weight of its moments is negative");
  CHECK(table_breach([](MapPlane& p) { p.moments->mean.z = not_a_number; }) ==
        "plane 3: the moments hold what is not a finite number");
  CHECK(table_breach([](MapPlane& p) { p.moments->scatter[1] = 1.01; }) ==
        "plane 3: the scatter of its moments is not positive semidefinite");
  CHECK(is_good([](MapPlane& p) { p.covariance->at(3) = 1.58e-5; }));  // nearly wholly correlated
  CHECK(is_good([](MapPlane& p) { p.covariance.emplace(); }));
  CHECK(is_good([](MapPlane& p) { p.moments.emplace(); }));
  CHECK(is_good([](MapPlane& p) { p.moments->scatter = {1e300, 1e300, 0, 1e300, 0, 0}; }));
}

TEST_CASE("rules of polygons") {
  CHECK(polygon_breach(0, [](auto& points) { points.resize(2); }) ==
        "plane 3, polygon 1: has fewer than three points");
  CHECK(polygon_breach(1, [](auto& points) { points.clear(); }) ==
        "plane 3, polygon 2: has fewer than three points");
  CHECK(polygon_breach(0, [](auto& points) { points[2].x = infinity; }) ==
        "plane 3, polygon 1: a point is not finite");
  CHECK(polygon_breach(0, [](auto& points) { points[2].z = 0.7501; }) ==
        "plane 3, polygon 1: point 3 lies 0.0001 off the plane");
  CHECK(polygon_breach(0, [](auto& points) { std::reverse(points.begin(), points.end()); }) ==
        "plane 3, polygon 1: runs clockwise seen from where the normal points");
  CHECK(polygon_breach(1, [](auto& points) { std::reverse(points.begin(), points.end()); }) ==
        "plane 3, polygon 2: is a hole and runs counter-clockwise seen from where the normal points");
  CHECK(polygon_breach(1, [](auto& points) { points[2] = points[0]; }) ==
        "plane 3, polygon 2: its area is zero");
  const std::vector<Vector3> far{{0, 0, 0.75}, {1e300, 0, 0.75}, {0, 1e300, 0.75}};
  CHECK(is_good([&](MapPlane& p) { p.polygons[0].points = far; }));
}

TEST_CASE("semidefinite: against the eigenvalues of matrices made from them") {
  const std::uint32_t seed = 31;
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int round = 0; round < 2000; ++round) {
    // B diag(e) Bᵀ with an orthonormal B made of two Householder mirrors.
    std::array<std::array<double, 4>, 4> b{};
    for (std::size_t i = 0; i < 4; ++i) b[i][i] = 1;
    for (int mirror = 0; mirror < 2; ++mirror) {
      std::array<double, 4> v{unit(generator), unit(generator), unit(generator), 1};
      const double square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + v[3] * v[3];
      for (auto& row : b) {
        const double along = row[0] * v[0] + row[1] * v[1] + row[2] * v[2] + row[3] * v[3];
        for (std::size_t i = 0; i < 4; ++i) row[i] -= 2 * along / square * v[i];
      }
    }
    std::array<double, 4> eigen{1, std::abs(unit(generator)), 0, 0};
    const bool good = round % 2 == 0;
    if (!good) eigen[3] = -1e-7 - std::abs(unit(generator)) * 0.5;
    std::array<double, 10> upper{};
    for (std::size_t row = 0, at = 0; row < 4; ++row) {
      for (std::size_t column = row; column < 4; ++column, ++at) {
        for (std::size_t k = 0; k < 4; ++k) upper[at] += eigen[k] * b[row][k] * b[column][k];
      }
    }
    INFO("seed " << seed << ", round " << round);
    REQUIRE(io::is_semidefinite(upper, std::array<double, 4>{1, 1, 1, 1}) == good);
  }
}
