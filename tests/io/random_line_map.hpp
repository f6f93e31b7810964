// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <random>
#include <string>

#include "straightedge/host/line_geometry.hpp"
#include "straightedge/host/line_map.hpp"

/// Maps that keep every rule of the format, drawn from one generator.
class RandomLineMaps {
 public:
  explicit RandomLineMaps(std::uint32_t seed) : generator_(seed) {}

  straightedge::LineMap next() {
    using namespace straightedge;
    LineMap map;
    map.meta.name = word();
    map.meta.tool = word();
    map.meta.description = word();
    if (coin()) map.image = image();
    if (map.image && coin()) map.unit = MapUnit::metre;
    const int lines = whole(0, 12);
    for (int i = 0; i < lines; ++i) map.lines.push_back(line(static_cast<std::uint32_t>(3 * i)));
    return map;
  }

  double real(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator_);
  }
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(generator_); }
  bool coin() { return whole(0, 1) == 1; }

 private:
  std::string word() {
    static const std::string sharp_s = std::string("Stra\xC3\x9F") + "e";
    static const std::string words[] = {"",     "floor 4",        "a<b & \"c\"", sharp_s,
                                        "it's", "  two  blanks ", "]]>"};
    return words[whole(0, 6)];
  }

  straightedge::MapImage image() {
    using namespace straightedge;
    MapImage image{word() + ".png", {whole(1, 3000), whole(1, 3000)}, {}, {}};
    if (coin()) image.placement = {real(0.001, 2), real(-100, 100), real(-100, 100), real(-7, 7)};
    if (coin()) {
      image.meaning = {coin(), real(0.5, 1), real(0, 0.5), static_cast<RosMapMode>(whole(0, 2))};
    }
    return image;
  }

  straightedge::MapLine line(std::uint32_t id) {
    using namespace straightedge;
    const double sizes[] = {1e-3, 1.0, 1000.0, 1e9};
    const double size = sizes[whole(0, 3)];
    // Every tenth line goes through the origin, where theta has the smaller range.
    const NormalForm form = normalise_line(whole(0, 9) == 0 ? 0.0 : real(-size, size), real(-pi, pi));
    MapLine line;
    line.id = id;
    line.rho = form.rho;
    line.theta = form.theta;
    if (coin()) line.votes = static_cast<std::uint32_t>(generator_());
    if (coin()) line.width = real(0, 4);
    if (coin()) line.count = static_cast<std::uint32_t>(whole(1, 9));
    if (coin()) line.source = word();
    line.free = static_cast<FreeSide>(whole(0, 3));
    const Point2 normal = line_normal(line.theta);
    const Point2 along = line_direction(line.theta);
    const auto at = [&](double s) {
      return Point2{line.rho * normal.x + s * along.x, line.rho * normal.y + s * along.y};
    };
    if (coin()) line.covariance = {at(0).x, at(0).y, real(0, 1e-3), real(0, 1)};
    const int segments = whole(0, 3);
    double s = real(-size, 0);
    for (int i = 0; i < segments; ++i) {
      const Point2 a = at(s);
      const Point2 b = at(s + size * real(0.01, 1));
      line.segments.push_back({next_segment_++, a.x, a.y, b.x, b.y, {}});
      if (coin()) line.segments.back().pixels = static_cast<std::uint32_t>(whole(0, 10000));
      s += size * 1.5;
    }
    return line;
  }

  std::mt19937 generator_;
  std::uint32_t next_segment_ = 0;
};

/// A small good map that refusal tests break in one place.
inline straightedge::LineMap small_line_map() {
  using namespace straightedge;
  LineMap map;
  map.meta = {"floor 4", "", "straightedge 0.1", "lines floor4.png --seed 1", ""};
  map.image = MapImage{"floor4.png", {640, 400}, MapPlacement{0.05, -12, -25, 0}, RosMeaning{}};
  MapLine wall;
  wall.id = 3;
  wall.rho = 101.25;
  wall.theta = pi / 2;
  wall.votes = 312;
  wall.width = 2.1;
  wall.free = FreeSide::both;
  wall.covariance = LineCovariance{3.5, 101.25, 2.9e-06, 0.04};
  wall.segments = {{10, 120.5, 101.25, -113.5, 101.25, 229}, {11, -120.5, 101.25, -150.5, 101.25, 30}};
  MapLine face;
  face.id = 5;
  face.rho = 20;
  face.theta = 0;
  face.free = FreeSide::minus;
  face.segments = {{12, 20, -60, 20, 80, 140}};
  map.lines = {wall, face};
  return map;
}
