// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>

#include "run_planes.hpp"

using namespace straightedge;

namespace {

constexpr double metres_per_unit = 0.0002;

struct RawFrame {
  std::vector<std::uint16_t> raw;
  std::vector<float> inverse;

  explicit RawFrame(const scene::Frame& frame) : inverse(frame.q.size()) {
    for (const float q : frame.q) {
      const double units = q > 0 ? 1 / (static_cast<double>(q) * metres_per_unit) : 0;
      raw.push_back(static_cast<std::uint16_t>(units < 65535 ? units : 0));
    }
    REQUIRE(inverse_depth_image(depth(), {inverse.data(), scene::size}) == Status::ok);
  }
  DepthView depth() const { return {{raw.data(), scene::size}, metres_per_unit, scene::camera}; }
  ImageView<const float> inverse_view() const { return {inverse.data(), scene::size}; }
};

RawFrame frame_by_chance(std::uint64_t seed, double holes) {
  Pcg32 random(seed);
  return RawFrame(scene::render(scene::room_by_chance(random), scene::sigma, holes, random));
}

void check_same(const RansacPlanesResult& a, const RansacPlanesResult& b) {
  CHECK(a.status == b.status);
  CHECK(a.found.planes == b.found.planes);
  CHECK(a.found.readings == b.found.readings);
  CHECK(a.found.labelled == b.found.labelled);
  CHECK(a.found.iterations == b.found.iterations);
}

}  // namespace

TEST_CASE("Raw depth gives the bits of the picture of 1/z", "[ransac][laws]") {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const RawFrame frame = frame_by_chance(seed, seed % 2 == 0 ? 0.6 : 0.1);
    for (const std::uint32_t planes : {1U, 3U}) {
      CAPTURE(seed, planes);
      RansacOptions options{.max_planes = planes, .split = seed == 3, .seed = seed};
      options.gate.fixed_m = seed == 4 ? 0.02 : 0;
      std::vector<std::byte> workspace;
      RansacPlanes ransac = scene::prepared(frame.raw.size(), options, workspace);
      std::vector<FoundPlane> of_raw(8), of_inverse(8);
      std::vector<std::uint16_t> raw_labels(frame.raw.size(), 7), inverse_labels(frame.raw.size(), 9);
      const auto a = ransac.run(frame.depth(), of_raw, {raw_labels.data(), scene::size});
      const auto b =
          ransac.run(frame.inverse_view(), scene::camera, of_inverse, {inverse_labels.data(), scene::size});
      check_same(a, b);
      REQUIRE(a.found.planes > 0);
      CHECK(raw_labels == inverse_labels);
      for (std::uint32_t i = 0; i < a.found.planes; ++i) {
        CHECK(of_raw[i].fit.plane == of_inverse[i].fit.plane);
        CHECK(of_raw[i].fit.covariance == of_inverse[i].fit.covariance);
        CHECK(of_raw[i].inliers == of_inverse[i].inliers);
      }
    }
  }
}

TEST_CASE("Who asks for no labels gets the same plane", "[ransac][laws]") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    CAPTURE(seed);
    const RawFrame frame = frame_by_chance(seed, 0.2);
    std::vector<std::byte> workspace;
    RansacPlanes ransac = scene::prepared(frame.raw.size(), {}, workspace);
    std::vector<FoundPlane> with(1), without(1);
    std::vector<std::uint16_t> labels(frame.raw.size(), 7);
    check_same(ransac.run(frame.depth(), with, {labels.data(), scene::size}),
               ransac.run(frame.depth(), without, {}));
    CHECK(with[0].fit.covariance == without[0].fit.covariance);
    CHECK(with[0].inliers == without[0].inliers);
    std::uint32_t labelled = 0;
    for (const std::uint16_t label : labels) {
      REQUIRE(label <= 1);
      labelled += label;
    }
    CHECK(labelled == with[0].inliers);
  }
}

TEST_CASE("The fit is that of all inliers, added up one by one", "[ransac][laws]") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    CAPTURE(seed);
    Pcg32 random(seed);
    const scene::Frame frame = scene::render(scene::room_by_chance(random), scene::sigma, 0.2, random);
    const scene::Cloud cloud = scene::to_cloud(frame);
    RansacOptions options{.seed = seed};
    options.gate.fixed_m = 0.02;
    const scene::FoundPlanes found = scene::find(cloud.view(), options);
    REQUIRE(found.planes.size() == 1);
    // One more step of the same least squares moves the plane by less than its noise.
    std::vector<FoundPlane> again = found.planes;
    REQUIRE(refit_labelled(cloud.view(), found.labels, options.gate, again) == Status::ok);
    CHECK(again[0].inliers == found.planes[0].inliers);
    CHECK(scene::error_of(again[0].fit.plane, found.planes[0].fit.plane).angle < 1e-3);
    CHECK(again[0].fit.rms == Approx(found.planes[0].fit.rms).epsilon(0.02));
    CHECK(again[0].fit.covariance[0] == Approx(found.planes[0].fit.covariance[0]).epsilon(0.05));
  }
}

TEST_CASE("Every seed finds a plane of nearly as many readings", "[ransac][laws]") {
  for (std::uint64_t room = 1; room <= 4; ++room) {
    const RawFrame frame = frame_by_chance(room, 0.2);
    std::vector<std::uint32_t> inliers;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
      const RansacOptions options{.seed = seed};
      std::vector<std::byte> workspace;
      RansacPlanes ransac = scene::prepared(frame.raw.size(), options, workspace);
      std::vector<FoundPlane> plane(1);
      REQUIRE(ransac.run(frame.depth(), plane, {}).found.planes == 1);
      inliers.push_back(plane[0].inliers);
    }
    std::sort(inliers.begin(), inliers.end());
    CAPTURE(room, inliers);
    CHECK(inliers[1] * 100 >= inliers.back() * 98);
  }
}

TEST_CASE("Depth that makes no sense is refused", "[ransac]") {
  const RawFrame frame = frame_by_chance(1, 0.2);
  std::vector<std::byte> workspace;
  RansacPlanes ransac = scene::prepared(frame.raw.size(), {}, workspace);
  std::vector<FoundPlane> plane(1);
  const auto status_of = [&](auto change) {
    DepthView depth = frame.depth();
    change(depth);
    return ransac.run(depth, plane, {}).status;
  };
  CHECK(status_of([](DepthView&) {}) == Status::ok);
  CHECK(status_of([](DepthView& d) { d.raw.data = nullptr; }) == Status::invalid_image);
  CHECK(status_of([](DepthView& d) { d.camera.fx = 0; }) == Status::invalid_image);
  CHECK(status_of([](DepthView& d) { d.metres_per_unit = 0; }) == Status::invalid_image);
  CHECK(status_of([](DepthView& d) { d.metres_per_unit = std::numeric_limits<double>::quiet_NaN(); }) ==
        Status::invalid_image);
  CHECK(status_of([](DepthView& d) { d.metres_per_unit = 1e-39; }) == Status::invalid_option);
  std::vector<std::uint16_t> labels(10);
  CHECK(ransac.run(frame.depth(), plane, {labels.data(), {5, 2}}).status == Status::size_mismatch);
  CHECK(RansacPlanes{}.run(frame.depth(), plane, {}).status == Status::not_prepared);
}
