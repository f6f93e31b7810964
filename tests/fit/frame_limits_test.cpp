// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstdint>
#include <vector>

#include "frame_testing.hpp"

using namespace frame;

namespace {

constexpr Size size{160, 120};

struct Room {
  std::vector<Plane> planes = support::box_planes();
  DepthScene scene = support::box_room(size, planes);
  DepthFrame frame = support::frame_of(scene, {}, 3);
  std::vector<InverseDepthPlane> truth = seen_by(scene.camera(), planes);
};

DepthFrame filled(Size s, std::uint16_t value) {
  return {Image<std::uint16_t>(s, value), support::kinect(s)};
}

}  // namespace

TEST_CASE("planes below min_pixels leave, those well above stay") {
  const Room room;
  const FoundFrame all = find(room.frame, room.truth);
  REQUIRE(all.planes.size() == 5);
  FramePlanesOptions options;
  options.min_pixels = all.planes[0].inliers / 2;  // whole cells count: those along its border do not
  REQUIRE(all.planes[4].inliers < options.min_pixels);
  const FoundFrame large = find(room.frame, room.truth, options);
  CHECK(count_of(large.planes, all.planes[0].fit.plane) == 1);
  for (const FoundPlane& plane : large.planes) CHECK(plane.inliers >= options.min_pixels);
  check_counts(large, room.frame);
  options.min_pixels = all.planes[0].inliers + 500;
  const FoundFrame none = find(room.frame, room.truth, options);
  CHECK(none.status == Status::ok);
  CHECK(none.planes.empty());
  CHECK(none.found.labelled == 0);
  CHECK(none.found.readings == all.found.readings);
}

TEST_CASE("min_pixels 0 is a thousandth of the picture, at least 64") {
  // A board of some 250 pixels before a wall.
  const Plane wall{{0, 0, 1}, 2.5}, board{{0, 0, 1}, 1.5};
  DepthScene scene(size);
  scene.draw_plane(1, wall);
  scene.draw_part(2, board, [](const Vector3& p) { return std::fabs(p.x) < 0.09 && std::fabs(p.y) < 0.09; });
  const DepthFrame frame = support::frame_of(scene, {}, 2);
  const auto proposed = seen_by(frame.camera, {wall, board});
  FramePlanesOptions options;
  CHECK(find(frame, proposed, options).planes.size() == 2);
  options.min_pixels = 300;
  CHECK(find(frame, proposed, options).planes.size() == 1);
}

TEST_CASE("min_pixels counts readings, not pixels without one") {
  const Plane wall{{0, 0, 1}, 2.5}, board{{0, 0, 1}, 1.5};
  DepthScene scene({320, 240});
  scene.draw_plane(1, wall);
  scene.draw_part(2, board, [](const Vector3& p) { return std::fabs(p.x) < 0.12 && std::fabs(p.y) < 0.12; });
  SensorNoise noise;
  noise.holes = 0.6;
  noise.hole_side = 1;
  const DepthFrame frame = support::frame_of(scene, noise, 2);  // some 700 of the board's 1764 pixels
  const auto proposed = seen_by(frame.camera, {wall, board});
  FramePlanesOptions options;
  options.min_pixels = 600;
  CHECK(find(frame, proposed, options).planes.size() == 2);
  options.min_pixels = 800;
  CHECK(find(frame, proposed, options).planes.size() == 1);
}

TEST_CASE("max_planes bounds what the search may propose") {
  const Room room;
  for (const std::uint32_t most : {1U, 3U, 4U}) {
    FramePlanesOptions options;
    options.max_planes = most;
    FakeSearch fake{room.truth};
    Finder finder(size, options);
    Image<std::uint16_t> labels(size);
    std::vector<FoundPlane> planes(9);
    PlanesFound found;
    REQUIRE(finder.planes.run(room.frame.view(), as_search(fake), labels.view(), planes, found) ==
            Status::ok);
    CHECK(found.planes <= most);
    CHECK(found.planes >= 1);
    CHECK(fake.room + found.planes <= most + 1);  // of the last call: what the first has not filled
  }
}

TEST_CASE("a full output holds the largest planes; the others are unlabelled") {
  const Room room;
  const FoundFrame all = find(room.frame, room.truth);
  REQUIRE(all.planes.size() == 5);
  for (std::size_t space = 0; space < 5; ++space) {
    const FoundFrame some = find(room.frame, room.truth, {}, space);
    INFO("space for " << space);
    CHECK(some.status == Status::output_full);
    REQUIRE(some.planes.size() == space);
    check_counts(some, room.frame);
    for (std::size_t k = 0; k < space; ++k) CHECK(some.planes[k].fit.plane == all.planes[k].fit.plane);
    int wrong = 0;
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const std::uint16_t label = all.labels.at(x, y);
        wrong += some.labels.at(x, y) != (label <= space ? label : 0) ? 1 : 0;
      }
    }
    CHECK(wrong == 0);
  }
  CHECK(find(room.frame, room.truth, {}, 5).status == Status::ok);
}

TEST_CASE("frames without a plane give an empty result") {
  const Room room;
  for (const std::uint16_t value : {std::uint16_t{0}, std::uint16_t{2000}}) {
    DepthFrame frame = filled(size, 0);
    frame.raw.at(77, 33) = value;  // no reading, or one
    const FoundFrame result = find(frame, room.truth);
    CHECK(result.status == Status::ok);
    CHECK(result.planes.empty());
    check_counts(result, frame);
  }
  const FoundFrame none = find(room.frame, {});
  CHECK(none.status == Status::ok);
  CHECK(none.planes.empty());
  check_counts(none, room.frame);
}

TEST_CASE("one value everywhere is a wall across the view") {
  for (const std::uint16_t value :
       {std::uint16_t{1}, std::uint16_t{700}, std::uint16_t{2000}, std::uint16_t{65535}}) {
    const DepthFrame frame = filled(size, value);
    const double z = value * 0.001;
    const FoundFrame result = find(frame, {{0, 0, 1 / z}});
    INFO("value " << value);
    REQUIRE(result.planes.size() == 1);
    CHECK(result.found.labelled == result.found.readings);
    check_counts(result, frame);
    CHECK(result.planes[0].fit.plane.distance == Approx(z).epsilon(1e-5));
    CHECK(result.planes[0].fit.plane.normal.z == Approx(1));
  }
}

TEST_CASE("a search may fill its span, round after round") {
  const Room room;
  std::vector<InverseDepthPlane> many;
  for (int i = 0; i < 300; ++i) many.push_back({1e-4 * (i % 17 - 8), 1e-4 * (i % 13 - 6), 0.2 + 0.002 * i});
  for (const std::uint32_t most : {64U, 256U}) {
    FramePlanesOptions options;
    options.max_planes = most;
    options.rounds = 8;
    const FoundFrame result = find(room.frame, many, options, 256);
    CHECK(result.status == Status::ok);
    CHECK(result.calls == 8);
    check_counts(result, room.frame);
  }
}

TEST_CASE("a search that claims more planes than it has room for is not believed") {
  const Room room;
  const auto boast = [](void*, ImageView<const float>, const DepthCells&, ImageView<const std::uint16_t>,
                        const PinholeCamera&, std::span<ProposedPlane> out, std::uint32_t& count) noexcept {
    for (ProposedPlane& plane : out) plane = {};
    count = 0xFFFFFFFFU;
    return Status::ok;
  };
  Finder finder(size, {});
  Image<std::uint16_t> labels(size);
  std::vector<FoundPlane> planes(8);
  PlanesFound found;
  CHECK(finder.planes.run(room.frame.view(), {nullptr, boast}, labels.view(), planes, found) == Status::ok);
  CHECK(found.planes == 0);
}

TEST_CASE("what a search refuses comes back") {
  const Room room;
  const auto refuse = [](void*, ImageView<const float>, const DepthCells&, ImageView<const std::uint16_t>,
                         const PinholeCamera&, std::span<ProposedPlane>,
                         std::uint32_t&) noexcept { return Status::not_prepared; };
  Finder finder(size, {});
  Image<std::uint16_t> labels(size);
  std::vector<FoundPlane> planes(8);
  PlanesFound found;
  CHECK(finder.planes.run(room.frame.view(), {nullptr, refuse}, labels.view(), planes, found) ==
        Status::not_prepared);
}

TEST_CASE("frames of any size, down to one pixel") {
  for (const Size s : {Size{1, 1}, Size{3, 2}, Size{1, 90}, Size{90, 1}, Size{33, 31}, Size{67, 50}}) {
    const DepthFrame frame = filled(s, 1500);
    FramePlanesOptions options;
    options.min_pixels = 3;
    const FoundFrame result = find(frame, {{0, 0, 1 / 1.5}}, options);
    INFO(s.width << " x " << s.height);
    CHECK(result.status == Status::ok);
    check_counts(result, frame);
    const bool wide = s.width >= 12 && s.height >= 12;
    if (wide) CHECK(result.found.labelled == result.found.readings);
    if (s.width == 1 || s.height == 1) CHECK(result.planes.empty());  // on one line: no plane
  }
}
