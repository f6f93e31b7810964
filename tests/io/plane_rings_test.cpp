// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "io/plane_rings.hpp"

#include "catch.hpp"

using namespace straightedge;
using namespace straightedge::io;

namespace {

const Ring square{{1, 1}, {5, 1}, {5, 5}, {1, 5}};
/// A frame round an empty middle that has the centroid in it.
const std::vector<Ring> frame{square, {{2, 2}, {2, 4}, {4, 4}, {4, 2}}};

}  // namespace

TEST_CASE("area has the sign of the turn, the centroid does not") {
  Ring turned(square.rbegin(), square.rend());
  CHECK(signed_area(square) == Approx(16));
  CHECK(signed_area(turned) == Approx(-16));
  CHECK(centroid(turned).x == Approx(3));
  CHECK(centroid(turned).y == Approx(3));
  const Ring corner{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}};
  CHECK(signed_area(corner) == Approx(6));
  CHECK(centroid(corner).x == Approx((4 * 2 + 2 * 0.5) / 6));
  CHECK(centroid(corner).y == Approx((4 * 0.5 + 2 * 2) / 6));
}

TEST_CASE("a border without area has the middle of its points for a centroid") {
  CHECK(signed_area({}) == 0);
  CHECK(centroid({{2, 2}, {2, 2}, {2, 2}}) == Point2{2, 2});
  CHECK(centroid({{0, 0}, {2, 2}, {4, 4}}) == Point2{2, 2});
}

TEST_CASE("a hole is outside") {
  CHECK(inside({1.5, 3}, frame));
  CHECK_FALSE(inside({3, 3}, frame));
  CHECK_FALSE(inside({0.5, 3}, frame));
  CHECK_FALSE(inside({7, 3}, frame));
}

TEST_CASE("an id stands in the middle, or where there is something to stand on") {
  CHECK(label_place({square}) == Point2{3, 3});
  const Point2 beside = label_place(frame);
  CHECK(inside(beside, frame));
  const std::vector<Ring> corner{{{0, 0}, {9, 0}, {9, 1}, {1, 1}, {1, 9}, {0, 9}}};
  CHECK(inside(label_place(corner), corner));
  CHECK(label_place({{{2, 2}, {2, 2}, {2, 2}}}) == Point2{2, 2});
}

TEST_CASE("the smallest rectangle turns with what it is round") {
  const Ring turned{{0, 0}, {4 * 0.8, 4 * 0.6}, {4 * 0.8 - 0.6, 4 * 0.6 + 0.8}, {-0.6, 0.8}};
  const Point2 sides = smallest_rectangle({turned});
  CHECK(sides.x == Approx(4).margin(0.02));  // whole degrees: 36.87 is met by 37
  CHECK(sides.y == Approx(1).margin(0.02));
  CHECK(smallest_rectangle({}) == Point2{0, 0});
}

TEST_CASE("a basis on a plane is right-handed, and level on walls") {
  for (const Vector3& normal :
       {Vector3{0, 0, 1}, Vector3{0, 0, -1}, Vector3{1, 0, 0}, Vector3{0.6, 0, 0.8}}) {
    const PlaneBasis basis(normal);
    CHECK(squared_length(cross(basis.u, basis.v) - normal) < 1e-24);
    CHECK(basis.u.z == 0);
  }
}
