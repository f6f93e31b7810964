// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <vector>

#include "ransac/contest.hpp"
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

TEST_CASE("A plane that cuts through a wall keeps no stripe of it", "[ransac]") {
  const Crossing c(5);
  const RansacSearchOptions options;
  std::vector<std::byte> bytes(RansacSearch::workspace_bytes(scene::size, options));
  Arena arena(bytes);
  const detail::RansacSearchMemory memory = detail::RansacSearchMemory::take(arena, scene::size, options);
  const ransac::Lattice lattice(scene::size, options, memory);
  ransac::clear_lattice(lattice);
  REQUIRE(ransac::draw_lattice(lattice, c.frame.view(), {}, options) > 4000);
  const InverseDepthPlane box_plane = to_inverse_depth(c.box, scene::camera);
  const InverseDepthPlane wall_plane = to_inverse_depth(c.wall, scene::camera);
  for (const std::size_t box_at : {std::size_t{0}, std::size_t{1}}) {
    CAPTURE(box_at);
    std::vector<ProposedPlane> candidates(2);
    for (ProposedPlane& candidate : candidates) {
      candidate.column1 = lattice.columns * lattice.cell;
      candidate.row1 = lattice.rows * lattice.cell;
    }
    candidates[box_at].fit.plane = box_plane;
    candidates[1 - box_at].fit.plane = wall_plane;
    ransac::contest_cells(lattice, candidates);
    int stripe_of_single_readings = 0, stripe = 0, box = 0;
    for (std::int32_t row = 0; row < lattice.rows; ++row) {
      for (std::int32_t column = 0; column < lattice.columns; ++column) {
        const std::size_t i = lattice.at(column, row);
        if (memory.q[i] < 0) continue;
        const bool on_box = column >= 5 && column < 20 && row >= 15 && row < 45;
        const bool owned = memory.owner[i] == static_cast<float>(box_at + 1);
        const double q = static_cast<double>(memory.q[i]);
        const double u = static_cast<double>(memory.u[i]), v = static_cast<double>(memory.v[i]);
        const double off_box = q - box_plane.at(u, v), off_wall = q - wall_plane.at(u, v);
        stripe_of_single_readings += !on_box && off_box * off_box < off_wall * off_wall ? 1 : 0;
        stripe += !on_box && owned ? 1 : 0;
        box += on_box && owned ? 1 : 0;
      }
    }
    CHECK(box > 400);
    CHECK(stripe_of_single_readings > 30);
    CHECK(stripe * 2 < stripe_of_single_readings);
    // Refitted to what they own, both are the planes that they were.
    ransac::refit_owners(lattice, candidates, 30, scene::sigma);
    CHECK(candidates[box_at].readings > 400);
    PlaneFit fit;
    REQUIRE(to_plane_fit(candidates[1 - box_at].fit, scene::sigma, scene::camera, fit) == Status::ok);
    CHECK(scene::error_of(fit.plane, c.wall).angle < 2e-3);
  }
}
