// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstdint>
#include <vector>

#include "frame_testing.hpp"

using namespace frame;

namespace {

constexpr Size size{320, 240};

struct Room {
  std::vector<Plane> planes = support::box_planes();
  DepthScene scene = support::box_room(size, planes);
  std::vector<InverseDepthPlane> truth = seen_by(scene.camera(), planes);
};

void check_walls(const FoundFrame& result, const std::vector<Plane>& planes) {
  CHECK(result.status == Status::ok);
  CHECK(result.planes.size() == planes.size());
  for (std::size_t k = 0; k < planes.size(); ++k) {
    INFO("wall " << k);
    CHECK(count_of(result.planes, planes[k]) == 1);
  }
}

}  // namespace

TEST_CASE("true planes of a box room get their readings") {
  const Room room;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    INFO("seed " << seed);
    const DepthFrame frame = support::frame_of(room.scene, {}, seed);
    const FoundFrame result = find(frame, room.truth);
    check_walls(result, room.planes);
    CHECK(agreement(result, frame, room.scene.truth()) > 0.98);
    check_counts(result, frame);
    CHECK(result.calls == 1);  // nothing is left over to look at again
    for (const FoundPlane& plane : result.planes) CHECK(plane.iterations == 7);
    CHECK(result.found.iterations == 7);
  }
}

TEST_CASE("planes that are a little wrong are fitted to their readings") {
  const Room room;
  const DepthFrame frame = support::frame_of(room.scene, {}, 4);
  std::vector<InverseDepthPlane> wrong = room.truth;
  for (std::size_t k = 0; k < wrong.size(); ++k) {
    wrong[k].c += (k % 2 == 0 ? 1 : -1) * 1.2e-3;
    wrong[k].a += 6e-6;
  }
  const FoundFrame result = find(frame, wrong);
  check_walls(result, room.planes);
  CHECK(agreement(result, frame, room.scene.truth()) > 0.97);
}

TEST_CASE("a plane proposed twice becomes one") {
  const Room room;
  const DepthFrame frame = support::frame_of(room.scene, {}, 5);
  std::vector<InverseDepthPlane> twice = room.truth;
  for (InverseDepthPlane plane : room.truth) {
    twice.push_back(plane);
    plane.c += 5e-4;
    plane.b -= 4e-6;
    twice.push_back(plane);
  }
  const FoundFrame result = find(frame, twice);
  check_walls(result, room.planes);
  CHECK(agreement(result, frame, room.scene.truth()) > 0.97);
  check_counts(result, frame);
}

TEST_CASE("planes that no surface has get nothing") {
  const Room room;
  const DepthFrame frame = support::frame_of(room.scene, {}, 6);
  std::vector<InverseDepthPlane> garbage = room.truth;
  garbage.insert(garbage.begin(),
                 {{0, 0, 0}, {0, 0, 5}, {0, 0, -1}, {1e300, -1e300, 1e300}, {1e-3, 0, -0.2}});
  const double infinity = 1e308 * 10;
  garbage.insert(garbage.end(), {{1e150, 0, 0}, {infinity, 0, 0}, {0, -infinity, infinity}});
  const FoundFrame result = find(frame, garbage);
  check_walls(result, room.planes);
  CHECK(agreement(result, frame, room.scene.truth()) > 0.97);
  check_counts(result, frame);
}

TEST_CASE("a plane that cuts through walls gets no stripe there") {
  const Room room;
  const DepthFrame frame = support::frame_of(room.scene, {}, 7);
  std::vector<Plane> cutting{{normalized({0.2, 0.1, 1}), 2.6},   {normalized({-0.3, 0.05, 1}), 2.9},
                             {normalized({1, 0.3, 0.5}), 1.6},   {normalized({0.1, 1, 0.35}), 1.3},
                             {normalized({-0.8, -0.4, 1}), 2.0}, {normalized({0.02, 0.9, 1}), 2.4}};
  std::vector<InverseDepthPlane> proposed = seen_by(frame.camera, cutting);
  proposed.insert(proposed.end(), room.truth.begin(), room.truth.end());
  const FoundFrame result = find(frame, proposed);
  check_walls(result, room.planes);
  CHECK(agreement(result, frame, room.scene.truth()) > 0.97);
  check_counts(result, frame);
}

TEST_CASE("a plane that leans a little against the wall gets no stripe where they cross") {
  const Room room;
  const Plane& back = room.planes[4];
  for (const double lean_rad : {0.04, 0.08, 0.15}) {
    const double c = std::cos(lean_rad), s = std::sin(lean_rad);
    std::vector<Plane> leaning;
    for (const double aside : {-0.3, 0.0, 0.3}) {
      const Vector3 normal = normalized(c * back.normal + s * Vector3{1, 0.3, 0});
      leaning.push_back({normal, dot(normal, Vector3{aside, 0, 0} + back.distance * back.normal)});
    }
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      INFO("lean " << lean_rad << ", seed " << seed);
      const DepthFrame frame = support::frame_of(room.scene, {}, seed);
      std::vector<InverseDepthPlane> proposed = seen_by(frame.camera, leaning);
      proposed.insert(proposed.end(), room.truth.begin(), room.truth.end());
      proposed.back().c += 1e-3;
      const FoundFrame result = find(frame, proposed);
      check_walls(result, room.planes);
      CHECK(agreement(result, frame, room.scene.truth()) > 0.97);
    }
  }
}

TEST_CASE("pieces of one plane on both sides of what stands before it are one") {
  const Plane wall{normalized({0.1, 0.05, 1}), 2.5}, board{normalized({-0.2, 0, 1}), 1.4};
  DepthScene scene(size);
  scene.draw_plane(1, wall);
  scene.draw_part(2, board, [](const Vector3& p) { return std::fabs(p.x) < 0.2; });
  const DepthFrame frame = support::frame_of(scene, {}, 8);
  const auto proposed = seen_by(frame.camera, {wall, wall, board});
  const FoundFrame result = find(frame, proposed);
  check_walls(result, {wall, board});
  CHECK(agreement(result, frame, scene.truth()) > 0.97);
  CHECK(result.labels.at(10, 120) == result.labels.at(310, 120));
}

TEST_CASE("parallel planes 5 cm apart at 1.5 m are two") {
  const Vector3 normal = normalized({0.1, -0.1, 1});
  const Plane near{normal, 1.5}, far{normal, 1.55};
  DepthScene scene(size);
  scene.draw_plane(1, far);
  scene.draw_part(2, near, [](const Vector3& p) { return p.x + 0.2 * p.y < 0.1; });
  for (const double apart : {0.0, 0.001}) {
    const DepthFrame frame = support::frame_of(scene, {}, 9);
    auto proposed = seen_by(frame.camera, {near, far});
    proposed[0].c -= apart;
    const FoundFrame result = find(frame, proposed);
    check_walls(result, {near, far});
    CHECK(agreement(result, frame, scene.truth()) > 0.97);
  }
}

TEST_CASE("60 percent of holes change little") {
  const Room room;
  SensorNoise noise;
  noise.holes = 0.6;
  for (const int side : {1, 3, 7}) {
    noise.hole_side = side;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      INFO("holes of " << side << " pixels, seed " << seed);
      const DepthFrame frame = support::frame_of(room.scene, noise, seed);
      const FoundFrame result = find(frame, room.truth);
      check_walls(result, room.planes);
      CHECK(agreement(result, frame, room.scene.truth()) > 0.97);
      check_counts(result, frame);
    }
  }
}

TEST_CASE("the second round sees what the first left over") {
  const Room room;
  const DepthFrame frame = support::frame_of(room.scene, {}, 10);
  struct Watch {
    std::vector<InverseDepthPlane> planes;
    std::vector<std::uint32_t> free;
  } watch{room.truth, {}};
  const auto one_a_call = [](void* user, ImageView<const float> q, const DepthCells&,
                             ImageView<const std::uint16_t> labels, const PinholeCamera&,
                             std::span<ProposedPlane> out, std::uint32_t& count) noexcept {
    auto& w = *static_cast<Watch*>(user);
    std::uint32_t free = 0;
    for (int y = 0; y < q.height; ++y) {
      for (int x = 0; x < q.width; ++x) {
        const bool is_free = labels.data == nullptr || labels.at(x, y) == 0;
        free += q.at(x, y) > 0 && is_free ? 1U : 0U;
      }
    }
    out[0].fit.plane = w.planes[w.free.size()];
    w.free.push_back(free);
    count = 1;
    return Status::ok;
  };
  watch.free.reserve(8);
  FramePlanesOptions options;
  options.rounds = 5;
  Finder finder(size, options);
  Image<std::uint16_t> labels(size);
  std::vector<FoundPlane> planes(8);
  PlanesFound found;
  REQUIRE(finder.planes.run(frame.view(), {&watch, one_a_call}, labels.view(), planes, found) == Status::ok);
  REQUIRE(watch.free.size() == 5);
  CHECK(watch.free[0] == found.readings);
  for (std::size_t k = 1; k < 5; ++k) CHECK(watch.free[k] + 1000 < watch.free[k - 1]);
  CHECK(found.planes == 5);
}

TEST_CASE("a search runs as often as it asks, unless the options say how often") {
  const Room room;
  const DepthFrame frame = support::frame_of(room.scene, {}, 10);
  const auto finds_nothing = [](void* user, ImageView<const float>, const DepthCells&,
                                ImageView<const std::uint16_t>, const PinholeCamera&,
                                std::span<ProposedPlane>, std::uint32_t& count) noexcept {
    ++*static_cast<std::uint32_t*>(user);
    count = 0;
    return Status::ok;
  };
  const auto calls = [&](std::uint32_t in_options, std::uint32_t asked) {
    FramePlanesOptions options;
    options.rounds = in_options;
    Finder finder(size, options);
    Image<std::uint16_t> labels(size);
    std::vector<FoundPlane> planes(8);
    PlanesFound found;
    std::uint32_t count = 0;
    REQUIRE(finder.planes.run(frame.view(), {&count, finds_nothing, asked}, labels.view(), planes, found) ==
            Status::ok);
    return count;
  };
  for (const std::uint32_t n : {1U, 2U, 5U}) {
    CHECK(calls(0, n) == n);
    CHECK(calls(n, 3) == n);
  }
}

TEST_CASE("the covariance says how far a plane lies from the truth") {
  const Plane wall{normalized({0.3, -0.2, 1}), 2};
  DepthScene scene(size);
  scene.draw_plane(1, wall);
  SensorNoise noise;
  noise.sigma = 1.425e-3;
  noise.step = 0;
  noise.units_per_metre = 10000;
  FramePlanesOptions options;
  options.noise_pixels = 9;  // as many pixels share their noise in the scene
  constexpr int trials = 40;
  double mean = 0;
  for (std::uint64_t seed = 1; seed <= trials; ++seed) {
    const DepthFrame frame = support::frame_of(scene, noise, seed);
    const FoundFrame result = find(frame, seen_by(frame.camera, {wall}), options);
    REQUIRE(result.planes.size() == 1);
    PlaneFit truth = result.planes[0].fit;
    truth.plane = wall;
    truth.covariance = {};
    mean += plane_chi_square(result.planes[0].fit, truth) / trials;
  }
  CHECK(mean > 1.8);  // 3 is expected, give or take 0.39
  CHECK(mean < 4.2);
}
