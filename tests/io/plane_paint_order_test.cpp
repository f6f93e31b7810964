// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "io/plane_paint_order.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "catch.hpp"
#include "io/plane_rings.hpp"
#include "room_plane_map.hpp"
#include "straightedge/trigonometry.hpp"

using namespace straightedge;
using namespace straightedge::io;

namespace {

struct Hit {
  double depth = 0;  // towards the eye
  std::size_t piece = 0;
};

/// The pieces that a ray of sight goes through, the farthest first.
std::vector<Hit> hits(const PlaneScene& scene, const ParallelView& view, const Vector3& through) {
  std::vector<Hit> found;
  for (std::size_t i = 0; i < scene.pieces.size(); ++i) {
    const ScenePiece& piece = scene.pieces[i];
    const Plane& plane = scene.planes[piece.plane].plane->plane;
    const double slope = dot(plane.normal, view.to_eye);
    if (std::abs(slope) < 1e-3) continue;
    const double t = -plane.signed_distance(through) / slope;
    const PlaneBasis basis(plane.normal);
    std::vector<Ring> rings;
    for (const auto& border : piece.rings) {
      rings.emplace_back();
      for (const Vector3& p : border) rings.back().push_back(basis.flat(p));
    }
    if (inside(basis.flat(through + t * view.to_eye), rings)) found.push_back({t, i});
  }
  std::ranges::sort(found, {}, &Hit::depth);
  return found;
}

}  // namespace

TEST_CASE("a ray of sight meets the pieces in the order in which they are painted") {
  const PlaneMap map = room_plane_map();
  const PlaneScene scene = plane_scene(map, UpAxis::z, {});
  const unsigned seed = 5;
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> share(0, 1);
  int compared = 0;
  for (int round = 0; round < 150; ++round) {
    const ParallelView view = ParallelView::from(2 * pi * share(generator), pi * (share(generator) - 0.5));
    const std::vector<std::size_t> order = paint_order(scene, view);
    REQUIRE(order.size() == scene.pieces.size());
    std::vector<std::size_t> rank(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = i;
    for (int ray = 0; ray < 100; ++ray) {
      const std::vector<Hit> met =
          hits(scene, view, {5.2 * share(generator), 4.1 * share(generator), 2.6 * share(generator)});
      for (std::size_t i = 1; i < met.size(); ++i) {
        // What lies upon one another has no order that anybody could see.
        if (met[i].depth - met[i - 1].depth < 1e-3) continue;
        INFO("seed " << seed << ", round " << round << ", pieces " << met[i - 1].piece << " "
                     << met[i].piece);
        CHECK(rank[met[i - 1].piece] < rank[met[i].piece]);
        ++compared;
      }
    }
  }
  CHECK(compared > 10000);
}

TEST_CASE("every piece is painted once, also where pieces hide one another in a circle") {
  RoomMaker maker;  // three planks, each with one end upon the next
  const Vector3 above{0, 0, 100};
  for (int k = 0; k < 3; ++k) {
    const double c = std::cos(2 * pi * k / 3), s = std::sin(2 * pi * k / 3);
    const auto at = [&](double x, double y, double z) { return Vector3{c * x - s * y, s * x + c * y, z}; };
    maker.add({at(-3, 0.5, 0), at(3, 0.5, 2), at(3, 1.5, 2), at(-3, 1.5, 0)}, above);
  }
  const PlaneMap map = maker.take();
  const PlaneScene scene = plane_scene(map, UpAxis::z, {});
  std::vector<std::size_t> order = paint_order(scene, ParallelView::from(0.3, 1.2));
  std::ranges::sort(order);
  CHECK(order == std::vector<std::size_t>{0, 1, 2});
  CHECK(paint_order(PlaneScene{}, ParallelView::from(0, 0)).empty());
}

TEST_CASE("from above, up on the paper is the map's y") {
  const ParallelView plan = ParallelView::from(-pi / 2, pi / 2);
  CHECK(plan.on_paper({2, 3, 7}).x == Approx(2));
  CHECK(plan.on_paper({2, 3, 7}).y == Approx(3));
  CHECK(plan.to_eye.z == Approx(1));
}
