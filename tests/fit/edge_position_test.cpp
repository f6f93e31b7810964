// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/edge_position.hpp"

#include "support/catch.hpp"
#include "support/guarded_image.hpp"

using namespace straightedge;

namespace {

/// A 5x5 field with the same gradient everywhere, its magnitudes given for the row or column through the middle.
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
  Field& row(int before, int here, int after) {
    magnitude.at(1, 2) = before;
    magnitude.at(2, 2) = here;
    magnitude.at(3, 2) = after;
    return *this;
  }
  Field& column(int before, int here, int after) {
    magnitude.at(2, 1) = before;
    magnitude.at(2, 2) = here;
    magnitude.at(2, 3) = after;
    return *this;
  }
  GradientField view() const { return {x.view(), y.view(), magnitude.view()}; }
};

/// Four times a parabola whose top lies at `top` quarters of a pixel.
int parabola(int at, int top) {
  const int d = 4 * at - top;
  return 2000 - 10 * d * d;
}

}  // namespace

TEST_CASE("the top of a parabola is found where it is, across the edge alone") {
  for (int top = -2; top <= 2; ++top) {
    CAPTURE(top);
    const int before = parabola(-1, top), here = parabola(0, top), after = parabola(1, top);
    for (const int gx : {-300, 300}) {
      const EdgePosition edge = edge_position(Field(gx, 90).row(before, here, after).view(), 2, 2);
      CHECK(edge.x == Approx(2 + top / 4.0).epsilon(1e-12));
      CHECK(edge.y == 2);
    }
    for (const int gy : {-300, 300}) {
      const EdgePosition edge = edge_position(Field(90, gy).column(before, here, after).view(), 2, 2);
      CHECK(edge.x == 2);
      CHECK(edge.y == Approx(2 + top / 4.0).epsilon(1e-12));
    }
  }
}

TEST_CASE("an edge is never moved by more than half a pixel") {
  CHECK(edge_position(Field(100, 0).row(0, 100, 199).view(), 2, 2).x == 2.5);
  CHECK(edge_position(Field(100, 0).row(199, 100, 0).view(), 2, 2).x == 1.5);
}

TEST_CASE("where there is no top the pixel's centre is the answer") {
  for (const int here : {0, 50, 100}) {
    CAPTURE(here);
    const EdgePosition edge = edge_position(Field(100, 0).row(100, here, 100).view(), 2, 2);
    CHECK(edge.x == 2);
    CHECK(edge.y == 2);
    CHECK(edge.variance > 0);
  }
}

TEST_CASE("at the border the pixel's centre is the answer") {
  Field field(100, 0);
  for (int r = 0; r < 5; ++r) {
    for (int c = 0; c < 5; ++c) field.magnitude.at(c, r) = 100 + 7 * c * c + 3 * r;
  }
  for (int i = 0; i < 5; ++i) {
    for (const int border : {0, 4}) {
      const EdgePosition edge = edge_position(field.view(), border, i);
      CHECK(edge.x == border);
      CHECK(edge.y == i);
      CHECK(edge.variance > 0);
    }
  }
  Field steep(0, 100);
  for (int i = 0; i < 5; ++i) {
    for (const int border : {0, 4}) {
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
    const double variance = edge_position(Field(100, 0).row(side, 1000, side).view(), 2, 2).variance;
    CHECK(variance > last);
    last = variance;
  }
  CHECK(edge_position(Field(100, 0).row(0, 1 << 30, 0).view(), 2, 2).variance > 1e-4);
}
