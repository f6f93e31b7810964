// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <string>

#include "straightedge/host/plane_map.hpp"

/// Maps that keep every rule of the format, drawn from one generator.
class RandomPlaneMaps {
 public:
  explicit RandomPlaneMaps(std::uint32_t seed) : generator_(seed) {}

  straightedge::PlaneMap next() {
    straightedge::PlaneMap map;
    map.meta.name = word();
    map.meta.options = word();
    const int planes = whole(0, 8);
    for (int i = 0; i < planes; ++i) map.planes.push_back(plane(static_cast<std::uint32_t>(1 + 2 * i)));
    return map;
  }

  double real(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator_);
  }
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(generator_); }
  bool coin() { return whole(0, 1) == 1; }

 private:
  std::string word() {
    static const std::string words[] = {"", "floor 4", "a<b & \"c\"", "Stra\xC3\x9F\x65", "]]>"};
    return words[whole(0, 4)];
  }

  straightedge::Vector3 direction() {
    while (true) {
      const straightedge::Vector3 v{real(-1, 1), real(-1, 1), real(-1, 1)};
      const double square = squared_length(v);
      if (square > 0.1 && square < 1) return normalized(v);
    }
  }

  straightedge::MapPlane plane(std::uint32_t id) {
    using namespace straightedge;
    const double sizes[] = {1e-3, 1.0, 1000.0, 1e9};
    const double size = sizes[whole(0, 3)];
    MapPlane plane;
    plane.id = id;
    // Every tenth plane goes through the origin, where the normal's sign has a rule of its own.
    plane.plane = canonical({direction(), whole(0, 9) == 0 ? 0.0 : real(-size, size)});
    if (coin()) plane.points = static_cast<std::uint64_t>(generator_()) << whole(0, 32);
    if (coin()) plane.count = generator_();
    if (coin()) plane.source = word();
    plane.seen = static_cast<SeenSide>(whole(0, 3));
    if (coin()) plane.covariance = covariance(size);
    if (coin()) plane.moments = moments(size);
    const Vector3 other = direction();
    const Vector3 u = normalized(cross(plane.plane.normal, other));
    const Vector3 v = cross(plane.plane.normal, u);
    const int polygons = whole(0, 3);
    for (int i = 0; i < polygons; ++i) plane.polygons.push_back(polygon(plane.plane, u, v, size));
    return plane;
  }

  /// A sum of outer products has no negative eigenvalue. Rank 3, as those of planes.
  std::array<double, 10> covariance(double size) {
    std::array<double, 10> upper{};
    for (int term = 0; term < 3; ++term) {
      const std::array<double, 4> v{real(-1, 1), real(-1, 1), real(-1, 1), size * real(-1, 1)};
      for (std::size_t row = 0, at = 0; row < 4; ++row) {
        for (std::size_t column = row; column < 4; ++column) upper[at++] += v[row] * v[column];
      }
    }
    return upper;
  }

  straightedge::MapMoments moments(double size) {
    straightedge::MapMoments moments;
    moments.weight = real(0, 1e9);
    moments.mean = {real(-size, size), real(-size, size), real(-size, size)};
    for (int term = 0; term < 3; ++term) {
      const std::array<double, 3> v{real(-size, size), real(-size, size), real(-size, size)};
      for (std::size_t row = 0, at = 0; row < 3; ++row) {
        for (std::size_t column = row; column < 3; ++column) moments.scatter[at++] += v[row] * v[column];
      }
    }
    return moments;
  }

  straightedge::MapPolygon polygon(const straightedge::Plane& plane, const straightedge::Vector3& u,
                                   const straightedge::Vector3& v, double size) {
    straightedge::MapPolygon polygon;
    polygon.hole = coin();
    const double s = real(-size, size), t = real(-size, size), w = size * real(0.1, 1);
    const std::array<std::array<double, 2>, 6> ell{
        {{0, 0}, {2 * w, 0}, {2 * w, w}, {w, w}, {w, 2 * w}, {0, 2 * w}}};
    for (std::size_t i = 0; i < 6; ++i) {
      const auto& corner = ell[polygon.hole ? 5 - i : i];
      polygon.points.push_back(plane.distance * plane.normal + (s + corner[0]) * u + (t + corner[1]) * v);
    }
    return polygon;
  }

  std::mt19937 generator_;
};

/// A small good map that refusal tests break in one place: a table with a hole, and a wall through the
/// origin.
inline straightedge::PlaneMap small_plane_map() {
  using namespace straightedge;
  PlaneMap map;
  map.meta = {"floor 4", "", "straightedge 0.1", "planes room --seed 1", ""};
  MapPlane table;
  table.id = 3;
  table.plane = {{0, 0, 1}, 0.75};
  table.points = 18231;
  table.count = 12;
  table.source = "ransac";
  table.seen = SeenSide::plus;
  table.covariance = {1e-06, 0, 0, 2e-06, 1e-06, 0, 0, 0, 0, 0.00025};
  table.moments = MapMoments{2500.5, {0.1, -0.2, 0.75}, {1, 0.5, 0, 1, 0, 0}};
  table.polygons = {{false, {{0, 0, 0.75}, {1, 0, 0.75}, {1, 1, 0.75}, {0, 1, 0.75}}},
                    {true, {{0.1, 0.1, 0.75}, {0.1, 0.2, 0.75}, {0.2, 0.1, 0.75}}}};
  MapPlane wall;
  wall.id = 5;
  wall.plane = {{0, 0.6, -0.8}, 0};
  map.planes = {table, wall};
  return map;
}
