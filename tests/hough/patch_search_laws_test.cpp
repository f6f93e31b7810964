// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <vector>

#include "patch_testing.hpp"
#include "support/catch.hpp"

using namespace straightedge;
using test::Face;
using test::find_with;
using test::Found;
using test::plane_of;

namespace {

const std::vector<Face> faces{{plane_of({0.1, 0.05, 1}, 2.5)},
                              {plane_of({0, 1, 0.3}, 1.2), 0, 170},
                              {plane_of({-0.6, 0.1, 0.8}, 1.3), 90, 60, 150, 130}};
constexpr Size size{256, 256};
constexpr PinholeCamera camera{260, 260, 127.5, 127.5};

}  // namespace

TEST_CASE("patches: a picture turned by 90 degrees has the same planes, turned") {
  const Image<float> picture = test::depth_scene(size, camera, faces, 1.425e-3, 5);
  Image<float> turned(size, 0.0F);
  for (std::int32_t y = 0; y < 256; ++y) {
    for (std::int32_t x = 0; x < 256; ++x) turned.at(255 - y, x) = picture.at(x, y);
  }
  const Found found = find_with(camera, picture);
  const Found again = find_with(camera, turned);
  REQUIRE(found.candidates.size() == 3);
  REQUIRE(again.candidates.size() == 3);
  CHECK(found.result.patches == again.result.patches);
  for (std::size_t i = 0; i < 3; ++i) {
    const Plane plane = test::plane_of(found.candidates[i], camera);
    const Plane expected{{-plane.normal.y, plane.normal.x, plane.normal.z}, plane.distance};
    CHECK(test::has(again, expected, 1e-3, 1e-3, camera));
    CHECK(again.candidates[i].readings == Approx(found.candidates[i].readings).epsilon(0.02));
  }
}

TEST_CASE("patches: a mirrored camera sees the same planes in the mirrored picture") {
  const Image<float> picture = test::depth_scene(size, camera, faces, 1.425e-3, 6);
  Image<float> mirrored(size, 0.0F);
  for (std::int32_t y = 0; y < 256; ++y) {
    for (std::int32_t x = 0; x < 256; ++x) mirrored.at(x, 255 - y) = picture.at(x, y);
  }
  const PinholeCamera upside_down{260, -260, 127.5, 127.5};
  const Found found = find_with(camera, picture);
  const Found again = find_with(upside_down, mirrored);
  REQUIRE(found.candidates.size() == 3);
  REQUIRE(again.candidates.size() == 3);
  for (const ProposedPlane& candidate : found.candidates) {
    CHECK(test::has(again, test::plane_of(candidate, camera), 1e-3, 1e-3, upside_down));
  }
}

TEST_CASE("patches: equal input gives equal bits, whatever the stride and the run before") {
  const Image<float> picture = test::depth_scene(size, camera, faces, 1.425e-3, 7);
  const Image<float> other = test::depth_scene(size, camera, {faces[0]}, 1.425e-3, 8);
  constexpr std::ptrdiff_t wide = 271;
  std::vector<float> strided(wide * 256, -7.0F);
  for (std::int32_t y = 0; y < 256; ++y) {
    for (std::int32_t x = 0; x < 256; ++x) strided[static_cast<std::size_t>(y * wide + x)] = picture.at(x, y);
  }
  const ImageView<const float> view(strided.data(), size, wide * static_cast<std::ptrdiff_t>(sizeof(float)));
  Found found = find_with(camera, picture);
  std::vector<ProposedPlane> again(64);
  CHECK(found.search->run(other, camera, {}, again).status == Status::ok);
  const HoughPatchResult result = found.search->run(view, camera, {}, again);
  REQUIRE(result.candidates == found.candidates.size());
  for (std::size_t i = 0; i < found.candidates.size(); ++i) {
    CHECK(again[i].fit.plane == found.candidates[i].fit.plane);
    CHECK(again[i].score == found.candidates[i].score);
  }
  // A mask that masks nothing takes the other way through the code.
  const Image<std::uint16_t> none(size, std::uint16_t{0});
  CHECK(found.search->run(picture, camera, none.view(), again).candidates == result.candidates);
  for (std::size_t i = 0; i < found.candidates.size(); ++i) {
    CHECK(again[i].fit.plane == found.candidates[i].fit.plane);
  }
}

TEST_CASE("patches: any plane that fills the picture is found, whichever way it faces") {
  const std::uint64_t seed = 40;
  Pcg32 random(seed);
  int tried = 0;
  while (tried < 60) {
    const Vector3 normal = test::random_direction(random);
    const Plane plane = plane_of(normal, 0.5 + 2 * test::uniform(random));
    // All of it between half a metre and five.
    bool seen = true;
    for (const auto& [x, y] : {std::pair{0, 0}, std::pair{255, 0}, std::pair{0, 255}, std::pair{255, 255}}) {
      const double q = dot(plane.normal, camera.ray(x, y)) / plane.distance;
      seen = seen && q > 0.2 && q < 2;
    }
    if (!seen) continue;
    ++tried;
    const Found found = find_with(camera, test::depth_scene(size, camera, {{plane}}, 1.425e-3, seed));
    INFO("seed " << seed << " plane " << tried);
    REQUIRE(found.candidates.size() == 1);
    CHECK(test::has(found, plane, 0.005, 0.01, camera));
    CHECK(found.candidates[0].readings > 0.95 * 256 * 256);
  }
}

TEST_CASE("patches: small faces in front of a wall are found, down to a thousand pixels") {
  const std::uint64_t seed = 41;
  Pcg32 random(seed);
  int found_faces = 0;
  for (int i = 0; i < 40; ++i) {
    const std::int32_t side = 34 + static_cast<std::int32_t>(random.below(20));
    const std::int32_t x = static_cast<std::int32_t>(random.below(200)),
                       y = static_cast<std::int32_t>(random.below(200));
    Vector3 normal = test::random_direction(random);
    const Vector3 ray = normalized(camera.ray(x + side / 2, y + side / 2));
    if (dot(normal, ray) < 0) normal = -normal;
    if (dot(normal, ray) < 0.4) normal = normalized(normal + ray);
    const Plane plane = plane_of(normal, dot(normal, 1.6 * ray));
    const Face face{plane, x, y, x + side, y + side};
    const Found found = find_with(camera, test::depth_scene(size, camera, {{plane_of({0, 0, 1}, 2.6)}, face},
                                                            1.425e-3, seed + static_cast<std::uint64_t>(i)));
    found_faces += test::has(found, plane, 0.07, 0.05, camera) ? 1 : 0;
  }
  INFO("seed " << seed);
  CHECK(found_faces >= 38);
}
