// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "straightedge/edge_position.hpp"
#include "straightedge/trigonometry.hpp"
#include "support/catch.hpp"
#include "support/drawing.hpp"
#include "support/edge_scene.hpp"

using namespace straightedge;

namespace {

struct Errors {
  double worst = 0, sum = 0, squares = 0;
  int count = 0;
  void add(double error) {
    worst = std::fmax(worst, std::fabs(error));
    sum += error;
    squares += error * error;
    ++count;
  }
  double bias() const { return std::fabs(sum / count); }
  double rms() const { return std::sqrt(squares / count); }
};

/// Draws dark on one side of x cos theta + y sin theta = rho, about the picture's centre, and measures every
/// edge pixel that Canny finds away from the border.
void measure(double theta, double rho, double sigma, Errors& errors) {
  constexpr Size size{64, 64};
  support::Canvas canvas(size, 250);
  const double nx = std::cos(theta), ny = std::sin(theta);
  const auto at = [&](double across, double along) {
    return support::Point2{32 + across * nx - along * ny, 32 + across * ny + along * nx};
  };
  canvas.paint({at(rho, -90), at(rho, 90), at(-90, 90), at(-90, -90)}, 10);
  CannyOptions options;
  options.sigma = sigma;
  const support::EdgeScene scene(canvas.picture(), options);
  for (int y = 8; y < 56; ++y) {
    for (int x = 8; x < 56; ++x) {
      if (scene.mask.at(x, y) == 0) continue;
      const EdgePosition edge = edge_position(scene.field(), x, y);
      errors.add((edge.x + 0.5 - 32) * nx + (edge.y + 0.5 - 32) * ny - rho);
      REQUIRE(edge.variance > 0);
      REQUIRE(edge.variance < 1);
    }
  }
}

Errors measure_all(double sigma) {
  Errors all;
  for (int slope = 0; slope < 24; ++slope) {
    const double theta = slope * 15 * degree + (slope % 2 == 0 ? 0.0 : 0.06);
    Errors here;
    for (int step = 0; step < 10; ++step) measure(theta, -2 + step * 0.37, sigma, here);
    CAPTURE(slope, sigma, here.bias());
    REQUIRE(here.count > 300);
    CHECK(here.bias() < 0.02);
    all.sum += here.sum;
    all.squares += here.squares;
    all.count += here.count;
    all.worst = std::fmax(all.worst, here.worst);
  }
  return all;
}

}  // namespace

TEST_CASE("a blurred step edge is found to a part of a pixel, whatever its slope and place") {
  const Errors errors = measure_all(1.4);
  CAPTURE(errors.worst, errors.rms(), errors.bias());
  CHECK(errors.worst < 0.06);
  CHECK(errors.rms() < 0.02);
  CHECK(errors.bias() < 0.003);
}

TEST_CASE("a sharp step edge is found to a part of a pixel") {
  const Errors errors = measure_all(0);
  CAPTURE(errors.worst, errors.rms(), errors.bias());
  CHECK(errors.worst < 0.35);
  CHECK(errors.rms() < 0.12);
  CHECK(errors.bias() < 0.01);
}
