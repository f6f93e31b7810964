// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/edge_position.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "support/catch.hpp"
#include "support/guarded_image.hpp"

using namespace straightedge;

namespace {

using Profile = std::array<int, 5>;

/// A 5x5 field with the same gradient everywhere; the magnitudes are given for the row or column through the
/// middle.
struct Field {
  support::GuardedImage<std::int16_t> x{{5, 5}, 3};
  support::GuardedImage<std::int16_t> y{{5, 5}, 1};
  support::GuardedImage<std::int32_t> magnitude{{5, 5}, 2};

  Field(int gx, int gy) {
    for (int r = 0; r < 5; ++r) {
      for (int c = 0; c < 5; ++c) {
        x.at(c, r) = static_cast<std::int16_t>(gx);
        y.at(c, r) = static_cast<std::int16_t>(gy);
      }
    }
  }
  Field& row(const Profile& values) {
    for (int c = 0; c < 5; ++c) magnitude.at(c, 2) = values[static_cast<std::size_t>(c)];
    return *this;
  }
  Field& column(const Profile& values) {
    for (int r = 0; r < 5; ++r) magnitude.at(2, r) = values[static_cast<std::size_t>(r)];
    return *this;
  }
  GradientField view() const { return {x.view(), y.view(), magnitude.view()}; }
};

/// A parabola whose top lies `top` quarters of a pixel from the middle.
Profile parabola(int top) {
  Profile out{};
  for (int i = 0; i < 5; ++i) {
    const int d = 4 * (i - 2) - top;
    out[static_cast<std::size_t>(i)] = 5000 - 10 * d * d;
  }
  return out;
}

}  // namespace

TEST_CASE("the top of a parabola is found where it is, across the edge alone") {
  // Beyond two quarters a neighbour is the largest: the pixel may come from another version of the picture.
  for (int top = -5; top <= 5; ++top) {
    CAPTURE(top);
    for (const int gx : {-300, 300}) {
      const EdgePosition edge = edge_position(Field(gx, 90).row(parabola(top)).view(), 2, 2);
      CHECK(edge.x == Approx(2 + top / 4.0).epsilon(1e-12));
      CHECK(edge.y == 2);
    }
    for (const int gy : {-300, 300}) {
      const EdgePosition edge = edge_position(Field(90, gy).column(parabola(top)).view(), 2, 2);
      CHECK(edge.x == 2);
      CHECK(edge.y == Approx(2 + top / 4.0).epsilon(1e-12));
    }
  }
}

TEST_CASE("an edge lies within half a pixel of the largest magnitude near its pixel") {
  for (const Profile& profile : {Profile{0, 100, 200, 199, 0}, Profile{0, 199, 200, 100, 0}}) {
    CHECK(std::fabs(edge_position(Field(100, 0).row(profile).view(), 2, 2).x - 2) <= 0.5);
  }
  CHECK(edge_position(Field(100, 0).row({0, 0, 100, 200, 900}).view(), 2, 2).x <= 3.5);
  CHECK(edge_position(Field(100, 0).row({900, 200, 100, 0, 0}).view(), 2, 2).x >= 0.5);
}

TEST_CASE("where there is no top the pixel's centre is the answer") {
  for (const int level : {0, 50, 100}) {
    CAPTURE(level);
    const EdgePosition edge =
        edge_position(Field(100, 0).row({level, level, level, level, level}).view(), 2, 2);
    CHECK(edge.x == 2);
    CHECK(edge.y == 2);
    CHECK(edge.variance > 0);
  }
}

TEST_CASE("within two pixels of the border the pixel's centre is the answer") {
  Field field(100, 0);
  for (int r = 0; r < 5; ++r) {
    for (int c = 0; c < 5; ++c) field.magnitude.at(c, r) = 100 + 7 * c * c + 3 * r;
  }
  for (int i = 0; i < 5; ++i) {
    for (const int border : {0, 1, 3, 4}) {
      const EdgePosition edge = edge_position(field.view(), border, i);
      CHECK(edge.x == border);
      CHECK(edge.y == i);
      CHECK(edge.variance > 0);
    }
  }
  Field steep(0, 100);
  for (int i = 0; i < 5; ++i) {
    for (const int border : {0, 1, 3, 4}) {
      const EdgePosition edge = edge_position(steep.view(), i, border);
      CHECK(edge.x == i);
      CHECK(edge.y == border);
    }
  }
}

TEST_CASE("a sharper top is surer, and no top is surer than the floor") {
  double last = 0;
  for (const int side : {0, 500, 900, 990}) {
    CAPTURE(side);
    const double variance = edge_position(Field(100, 0).row({0, side, 1000, side, 0}).view(), 2, 2).variance;
    CHECK(variance > last);
    last = variance;
  }
  CHECK(edge_position(Field(100, 0).row({0, 0, 1 << 30, 0, 0}).view(), 2, 2).variance > 1e-4);
}
