// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstdint>
#include <vector>

#include "frame_testing.hpp"

using namespace frame;

namespace {

constexpr Size size{640, 480};
const Plane wall{normalized({0.05, 0.1, 1}), 2.6};
const Vector3 ball_centre{-0.5, 0.1, 1.6}, pillar_foot{0.5, 0, 1.6};
constexpr double ball_radius = 0.25, pillar_radius = 0.25;

DepthScene round_things() {
  DepthScene scene(size);
  scene.draw_plane(1, wall);
  scene.draw_round(0, ball_centre, {}, ball_radius);
  scene.draw_round(0, pillar_foot, {0, 1, 0}, pillar_radius);
  return scene;
}

/// Planes that touch them a little below the surface, as a search finds them.
std::vector<InverseDepthPlane> with_strips(const PinholeCamera& camera) {
  std::vector<Plane> planes{wall};
  for (const double aside : {-0.6, -0.2, 0.2, 0.6}) {
    for (const double above : {-0.4, 0.0, 0.4}) {
      const Vector3 n = normalized({aside, above, 1});
      planes.push_back({n, dot(n, ball_centre) - 0.985 * ball_radius});
    }
    const Vector3 n = normalized({aside, 0, 1});
    planes.push_back({n, dot(n, pillar_foot) - 0.985 * pillar_radius});
  }
  return seen_by(camera, planes);
}

int on_round(const FoundFrame& result, const DepthScene& scene) {
  int count = 0;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      count += scene.truth().at(x, y) == 0 && result.labels.at(x, y) != 0 ? 1 : 0;
    }
  }
  return count;
}

}  // namespace

TEST_CASE("strips of a ball and a pillar are no planes unless asked for") {
  const DepthScene scene = round_things();
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    INFO("seed " << seed);
    const DepthFrame frame = support::frame_of(scene, {}, seed);
    FramePlanesOptions options;
    const FoundFrame flat = find(frame, with_strips(frame.camera), options);
    CHECK(flat.planes.size() == 1);
    CHECK(count_of(flat.planes, wall) == 1);
    CHECK(on_round(flat, scene) < 800);
    CHECK(agreement(flat, frame, scene.truth()) > 0.97);
    check_counts(flat, frame);
    options.reject_curved = false;
    const FoundFrame all = find(frame, with_strips(frame.camera), options);
    CHECK(all.planes.size() >= 4);
    CHECK(count_of(all.planes, wall) == 1);
    CHECK(on_round(all, scene) > 20000);
    check_counts(all, frame);
  }
}

TEST_CASE("what was found to be round is no reading any more, but counts as one") {
  const DepthScene scene = round_things();
  const DepthFrame frame = support::frame_of(scene, {}, 1);
  Finder finder(size, {});
  const FoundFrame result = finder.run(frame.view(), with_strips(frame.camera));
  int readings = 0, cleared = 0, cleared_wall = 0;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      if (frame.raw.at(x, y) == 0) continue;
      ++readings;
      if (finder.planes.inverse_depth().at(x, y) > 0) continue;
      ++cleared;
      cleared_wall += scene.truth().at(x, y) == 1 ? 1 : 0;
    }
  }
  CHECK(result.found.readings == static_cast<std::uint32_t>(readings));
  CHECK(cleared > 20000);
  CHECK(cleared_wall < cleared / 20);
  double in_cells = 0;
  const DepthCells& cells = finder.planes.cells();
  for (std::size_t i = 0; i < DepthCells::cell_count(cells.size(3)); ++i) in_cells += cells.moments(3, i).n;
  CHECK(in_cells == readings - cleared);
}

TEST_CASE("a wall whose picture is bent by some deviations is one plane") {
  const Plane plane{normalized({0.1, 0, 1}), 2};
  DepthScene scene(size);
  scene.draw_plane(1, plane);
  for (const double deviations : {-9.0, -3.0, 3.0, 9.0}) {
    SensorNoise noise;
    noise.sag = deviations * 1.425e-3;
    const DepthFrame frame = support::frame_of(scene, noise, 11);
    std::vector<InverseDepthPlane> proposed = seen_by(frame.camera, {plane, plane, plane});
    proposed[0].c += noise.sag / 3;
    proposed[1].a += noise.sag / size.width;
    proposed[1].c -= noise.sag / 2;
    proposed[2].a -= noise.sag / size.width;
    proposed[2].c += noise.sag / 2;
    const FoundFrame result = find(frame, proposed);
    CHECK(result.planes.size() == 1);
    CHECK(result.found.labelled > 0.98 * result.found.readings);
    check_counts(result, frame);
  }
}

TEST_CASE("pixels along an occluding edge go to the surface they look at") {
  const Plane board{normalized({-0.3, 0.1, 1}), 1.3};
  DepthScene scene(size);
  scene.draw_plane(1, wall);
  scene.draw_part(2, board, [](const Vector3& p) { return 0.7 * p.x + p.y < 0.05 && p.x > -0.2; });
  const DepthFrame frame = support::frame_of(scene, {}, 12);
  const FoundFrame result = find(frame, seen_by(frame.camera, {wall, board}));
  REQUIRE(result.planes.size() == 2);
  const std::uint16_t of_wall = result.labels.at(5, 475);
  int wrong = 0;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const std::uint16_t label = result.labels.at(x, y);
      wrong += label != 0 && (label == of_wall) != (scene.truth().at(x, y) == 1) ? 1 : 0;
    }
  }
  CHECK(wrong == 0);  // the two are some hundred deviations apart
}
