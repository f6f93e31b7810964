// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <vector>

#include "ransac/frame_labels.hpp"
#include "scene.hpp"
#include "support/catch.hpp"

using namespace straightedge;

namespace {

/// A wall, and the plane of a box that stands before its left half and cuts through the wall on the right.
struct Crossing {
  Plane wall = scene::plane_of({0, 0, 1}, 3);
  Plane box = scene::plane_of({0.55, 0, 1}, 2.6);
  scene::Frame frame;

  explicit Crossing(std::uint64_t seed) {
    Pcg32 random(seed);
    frame = scene::render({{wall}, {{box, 20, 60, 80, 180}}}, scene::sigma, 0.1, random);
  }
};

}  // namespace

TEST_CASE("Every pixel gets its nearest plane within the gate, in frames as by hand", "[ransac]") {
  const Crossing c(3);
  for (const double fixed : {0.0, 0.03}) {
    ransac::Readings readings;
    readings.frame = c.frame.view();
    readings.camera = scene::camera;
    readings.gate.fixed_m = fixed;
    std::vector<FoundPlane> planes(2);
    planes[0].fit.plane = c.wall;
    planes[1].fit.plane = c.box;
    std::vector<std::uint16_t> labels(c.frame.q.size(), 0);
    const std::uint32_t labelled = ransac::label_nearest_pixels(readings, planes, labels);
    std::size_t different = 0, counted = 0;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      const double q = static_cast<double>(c.frame.q[i]);
      double nearest = fixed > 0 ? fixed * q * q : 3 * scene::sigma;
      int label = 0;
      for (int k = 0; k < 2; ++k) {
        const InverseDepthPlane p =
            to_inverse_depth(planes[static_cast<std::size_t>(k)].fit.plane, scene::camera);
        const double off = q - p.at(static_cast<double>(i % 320), static_cast<double>(i / 320));
        if (q <= 0 || (off < 0 ? -off : off) >= nearest) continue;
        nearest = off < 0 ? -off : off;
        label = k + 1;
      }
      different += labels[i] == label ? 0 : 1;
      counted += labels[i] != 0 ? 1 : 0;
    }
    CHECK(different <= 3);  // ties but for the rounding of floats
    CHECK(counted == labelled);
    std::vector<FoundPlane> refitted = planes;
    ransac::refit_labelled_pixels(readings, labels, refitted);
    CHECK(refitted[0].inliers + refitted[1].inliers == labelled);
    CHECK(scene::error_of(refitted[0].fit.plane, c.wall).angle < 2e-3);
  }
}
