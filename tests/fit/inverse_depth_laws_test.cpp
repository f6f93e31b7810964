// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "plane_error.hpp"
#include "simulated_patch.hpp"
#include "straightedge/inverse_depth.hpp"
#include "support/catch.hpp"

using namespace straightedge;

namespace {

struct BothFits {
  PlaneFit inverse, orthogonal;
};

/// The same readings fitted in inverse depth, and as points without weights.
BothFits fit_both(const simulated::Patch& patch, Pcg32& random) {
  InverseDepthMoments pixels;
  PlaneMoments points;
  const Vector3 origin = patch.truth.distance * patch.truth.normal;
  simulated::for_each_reading(patch, random, [&](double u, double v, double q) {
    pixels.add(u, v, q);
    points.add((1 / q) * simulated::camera.ray(u, v) - origin);
  });
  BothFits both;
  InverseDepthFit fit;
  REQUIRE(fit_inverse_depth(pixels, simulated::sigma, fit) == Status::ok);
  REQUIRE(to_plane_fit(fit, simulated::sigma, simulated::camera, both.inverse) == Status::ok);
  REQUIRE(fit_plane(points, both.orthogonal) == Status::ok);
  both.orthogonal = moved(both.orthogonal, {1, 0, 0, 0, 1, 0, 0, 0, 1}, origin);
  return both;
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

struct Errors {
  double inverse_degrees = 0, orthogonal_degrees = 0;  ///< medians
  double inverse_nees = 0;                             ///< mean

  double ratio() const { return orthogonal_degrees / inverse_degrees; }
};

template <class Draw>
Errors errors_of(int trials, Pcg32& random, Draw&& draw) {
  Errors errors;
  std::vector<double> inverse, orthogonal;
  for (int i = 0; i < trials; ++i) {
    const simulated::Patch patch = draw();
    const BothFits both = fit_both(patch, random);
    inverse.push_back(support::angle_between(both.inverse.plane.normal, patch.truth.normal) / degree);
    orthogonal.push_back(support::angle_between(both.orthogonal.plane.normal, patch.truth.normal) / degree);
    errors.inverse_nees += support::nees(both.inverse, patch.truth) / trials;
  }
  errors.inverse_degrees = median(inverse);
  errors.orthogonal_degrees = median(orthogonal);
  return errors;
}

/// Patches of 80x80 pixels in the picture's middle.
Errors table_row(double z, double tilt_degrees, int trials) {
  Pcg32 random(80, static_cast<std::uint64_t>(10 * z + 1000 * tilt_degrees));
  return errors_of(trials, random, [&] {
    const double turn = support::uniform(random, -pi, pi);
    return simulated::patch_at(z, tilt_degrees * degree, turn, 280, 200, 80);
  });
}

}  // namespace

TEST_CASE("errors of the fit in inverse depth are as large as its covariance says") {
  constexpr std::uint64_t seed = 81;
  CAPTURE(seed);
  Pcg32 random(seed);
  constexpr int trials = 4000;
  double mean = 0, rejected = 0;
  for (int i = 0; i < trials; ++i) {
    const simulated::Patch patch =
        simulated::random_patch(random, 60 * degree, 40 + static_cast<int>(random.below(40)));
    const double error = support::nees(fit_both(patch, random).inverse, patch.truth);
    mean += error / trials;
    rejected += error > 11.34 ? 1.0 / trials : 0;
  }
  CHECK(mean > 2.5);
  CHECK(mean < 3.5);
  CHECK(mean == Approx(3).margin(4 * std::sqrt(6.0 / trials)));
  CHECK(rejected == Approx(0.01).margin(4 * std::sqrt(0.01 * 0.99 / trials)));
}

TEST_CASE("the fit in inverse depth is at least one and a half times as exact as the orthogonal one") {
  constexpr std::uint64_t seed = 82;
  CAPTURE(seed);
  Pcg32 random(seed);
  const Errors errors =
      errors_of(300, random, [&] { return simulated::random_patch(random, 60 * degree, 80); });
  INFO("median angle errors: orthogonal " << errors.orthogonal_degrees << ", in inverse depth "
                                          << errors.inverse_degrees << " degrees, ratio " << errors.ratio());
  CHECK(errors.ratio() >= 1.5);
  CHECK(errors.inverse_nees > 2.5);
  CHECK(errors.inverse_nees < 3.5);
}

TEST_CASE("facing a wall both fits are alike, at every tilt the one in inverse depth is better") {
  for (const double z : {2.0, 2.75, 3.5}) {
    for (const double tilt : {0.0, 15.0, 30.0, 45.0, 60.0}) {
      const Errors errors = table_row(z, tilt, 100);
      INFO("at " << z << " m, tilt " << tilt << " degrees: orthogonal " << errors.orthogonal_degrees
                 << ", in inverse depth " << errors.inverse_degrees << " degrees");
      CHECK(errors.ratio() > (tilt > 0 ? 1.15 : 0.97));
      CHECK(errors.inverse_nees > 1.8);
      CHECK(errors.inverse_nees < 4.2);
    }
  }
}

TEST_CASE("noise along oblique rays pulls the orthogonal fit aside, not the one in inverse depth") {
  constexpr std::uint64_t seed = 83;
  CAPTURE(seed);
  Pcg32 random(seed);
  Vector3 inverse, orthogonal;
  const simulated::Patch patch = simulated::patch_at(3, 45 * degree, 0.4, 280, 200, 60);
  constexpr int trials = 200;
  for (int i = 0; i < trials; ++i) {
    const BothFits both = fit_both(patch, random);
    inverse = inverse + (1.0 / trials) * both.inverse.plane.normal;
    orthogonal = orthogonal + (1.0 / trials) * both.orthogonal.plane.normal;
  }
  const double bias = support::angle_between(inverse, patch.truth.normal);
  CHECK(bias < 0.02 * degree);
  CHECK(support::angle_between(orthogonal, patch.truth.normal) > 5 * bias);
  CHECK(support::angle_between(orthogonal, patch.truth.normal) > 0.1 * degree);
}

// Not run by default: the table of docs/plane-fit.md.
TEST_CASE("table of angle errors", "[.table]") {
  std::string table = "\n";
  for (const auto& [z, tilt] : std::vector<std::pair<double, double>>{
           {1, 30}, {2, 0}, {2, 30}, {2, 60}, {3.5, 0}, {3.5, 30}, {3.5, 60}}) {
    const Errors errors = table_row(z, tilt, 1000);
    char row[100];
    std::snprintf(row, sizeof row, "| %.1f | %.0f | %.3f | %.3f | %.1f | %.2f |\n", z, tilt,
                  errors.orthogonal_degrees, errors.inverse_degrees, errors.ratio(), errors.inverse_nees);
    table += row;
  }
  WARN(table);
}
