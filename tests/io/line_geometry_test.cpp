// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/line_geometry.hpp"

#include <cmath>
#include <random>

#include "catch.hpp"

using namespace straightedge;

TEST_CASE("the normal form keeps its ranges and the line, also at the seams") {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> rho_of(-100, 100);
  std::uniform_real_distribution<double> theta_of(-20, 20);
  for (int i = 0; i < 20000; ++i) {
    const double seams[] = {0, 1e-20, -1e-20, pi, -pi, pi / 2, -pi / 2, 2 * pi, std::nextafter(pi / 2, 4.0)};
    const double rho = i % 5 == 0 ? 0.0 : i % 7 == 0 ? -0.0 : rho_of(generator);
    const double theta = i % 3 == 0 ? seams[i / 3 % 9] : theta_of(generator);
    const NormalForm form = normalise_line(rho, theta);
    INFO("i " << i << " rho " << rho << " theta " << theta << " -> " << form.rho << " " << form.theta);
    REQUIRE(is_normal_form(form.rho, form.theta));
    // The same line: its foot stays, and the normal turns round exactly when told.
    const Point2 before = line_normal(theta);
    const Point2 after = line_normal(form.theta);
    REQUIRE(dot(before, after) == Approx(form.flipped ? -1 : 1));
    REQUIRE(std::abs(form.rho * after.x - rho * before.x) < 1e-12);
    REQUIRE(std::abs(form.rho * after.y - rho * before.y) < 1e-12);
    const NormalForm again = normalise_line(form.rho, form.theta);
    REQUIRE((again.rho == form.rho && again.theta == form.theta && !again.flipped));
  }
}

TEST_CASE("a line through two points holds both, whatever their order") {
  std::mt19937 generator(6);
  std::uniform_real_distribution<double> at(-500, 500);
  for (int i = 0; i < 2000; ++i) {
    const Point2 a{at(generator), at(generator)};
    const Point2 b{at(generator), at(generator)};
    const NormalForm line = line_through(a, b);
    REQUIRE(is_normal_form(line.rho, line.theta));
    REQUIRE(std::abs(signed_distance(a, line.rho, line.theta)) < 1e-11);
    REQUIRE(std::abs(signed_distance(b, line.rho, line.theta)) < 1e-11);
    const NormalForm back = line_through(b, a);
    REQUIRE(back.rho == Approx(line.rho).margin(1e-11));
    REQUIRE(back.theta == Approx(line.theta).margin(1e-9));
  }
}

TEST_CASE("projection lands on the line, at right angles") {
  const double theta = 0.7;
  const Point2 p = project_on_line({3, -8}, 5, theta);
  CHECK(std::abs(signed_distance(p, 5, theta)) < 1e-14);
  CHECK(std::abs(dot(line_direction(theta), {3 - p.x, -8 - p.y})) < 1e-14);
  CHECK(signed_distance({100, 0}, 5, 0) == 95);
}

TEST_CASE("ends are put in order along (-sin, cos)") {
  MapSegment segment{0, 0, 10, 0, -10, {}};
  CHECK(length_along(segment, 0) == -20);
  order_ends(segment, 0);
  CHECK(length_along(segment, 0) == 20);
  CHECK(second_end(segment) == Point2{0, 10});
  order_ends(segment, 0);
  CHECK(second_end(segment) == Point2{0, 10});
}

TEST_CASE("image plane and centre frame are inverses; y turns round") {
  CHECK(centre_from_image({0, 0}, {640, 401}) == Point2{-320, 200.5});
  CHECK(centre_from_image({0.5, 0.5}, {3, 3}) == Point2{-1, 1});
  CHECK(image_from_centre(centre_from_image({12.25, 7.5}, {33, 21}), {33, 21}) == Point2{12.25, 7.5});
  CHECK(flip(FreeSide::plus) == FreeSide::minus);
  CHECK(flip(FreeSide::both) == FreeSide::both);
}
