// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include "run_planes.hpp"
#include "straightedge/host/frame_cells.hpp"
#include "straightedge/ransac_search.hpp"

using namespace straightedge;

namespace {

constexpr double nan_d = std::numeric_limits<double>::quiet_NaN();
constexpr float nan_f = std::numeric_limits<float>::quiet_NaN();
constexpr float inf_f = std::numeric_limits<float>::infinity();

scene::Cloud repeated(std::size_t n, float x, float y, float z) {
  scene::Cloud cloud;
  cloud.x.assign(n, x);
  cloud.y.assign(n, y);
  cloud.z.assign(n, z);
  return cloud;
}

void check_planeless(const scene::Cloud& cloud, std::uint32_t readings_in_metres) {
  for (const double fixed : {0.0, 0.02}) {
    for (const double near : {0.0, 0.5}) {
      CAPTURE(fixed, near);
      RansacOptions options{
          .near_radius = near, .max_iterations = 200, .max_planes = 3, .min_inliers = 3, .split = true};
      options.gate.fixed_m = fixed;
      const scene::FoundPlanes found = scene::find(cloud.view(), options);
      CHECK(found.result.status == Status::ok);
      CHECK(found.planes.empty());
      CHECK(found.result.found.labelled == 0);
      if (fixed > 0) CHECK(found.result.found.readings == readings_in_metres);
      for (const std::uint16_t label : found.labels) REQUIRE(label == 0);
    }
  }
}

template <class Change>
Status prepare_with(Change change) {
  RansacOptions options;
  change(options);
  std::vector<std::byte> workspace(1 << 20);
  RansacPlanes object;
  const Status status = RansacPlanes::prepare(object, 1000, options, workspace);
  CHECK((RansacPlanes::workspace_bytes(1000, options) == 0) == (status == Status::invalid_option));
  return status;
}

template <class Change>
Status prepare_search_with(Change change) {
  RansacSearchOptions options;
  change(options);
  std::vector<std::byte> workspace(1 << 20);
  RansacSearch object;
  const Status status = RansacSearch::prepare(object, {64, 48}, options, workspace);
  CHECK((RansacSearch::workspace_bytes({64, 48}, options) == 0) == (status == Status::invalid_option));
  return status;
}

}  // namespace

TEST_CASE("Clouds without a plane have none", "[ransac]") {
  check_planeless(repeated(1000, nan_f, 1, 2), 0);
  check_planeless(repeated(1000, 1, inf_f, 2), 0);
  check_planeless(repeated(1000, 1, 1, 2), 1000);
  check_planeless(repeated(2, 1, 1, 2), 2);
  check_planeless(repeated(1, 0, 0, 0), 1);
  scene::Cloud two = repeated(1000, 1, 1, 2);
  for (std::size_t i = 0; i < 500; ++i) two.x[i] = 3;
  check_planeless(two, 1000);
  scene::Cloud line = repeated(1000, 0, 0, 0);
  for (std::size_t i = 0; i < 1000; ++i) {
    line.x[i] = static_cast<float>(i) * 0.25F;
    line.y[i] = 1 - static_cast<float>(i) * 0.5F;
    line.z[i] = 2 + static_cast<float>(i);
  }
  check_planeless(line, 1000);
}

TEST_CASE("Readings that say nothing of their depth make no plane", "[ransac]") {
  // A kilometre away the noise of 1/z is larger than 1/z.
  scene::Cloud cloud;
  scene::add_square(cloud, {0, 0, 1000}, {1, 0, 0}, {0, 1, 0}, 40, 10);
  CHECK(scene::find(cloud.view(), {}).planes.empty());
  RansacOptions metres;
  metres.gate.fixed_m = 0.02;
  const scene::FoundPlanes found = scene::find(cloud.view(), metres);
  REQUIRE(found.planes.size() == 1);
  CHECK(found.planes[0].fit.plane.distance == Approx(1000));
  CHECK(found.planes[0].inliers == 1600);
}

TEST_CASE("One plane alone is found, and once", "[ransac]") {
  scene::Frame frame;
  frame.q.assign(320 * 240, 0.5F);
  const scene::FoundPlanes found = scene::find(frame, {.max_planes = 5});
  REQUIRE(found.planes.size() == 1);
  CHECK(found.planes[0].inliers == 320 * 240);
  CHECK(found.planes[0].fit.plane.distance == Approx(2));
  CHECK(found.planes[0].confidence == 1);
}

TEST_CASE("Frames of no use have no planes and no candidates", "[ransac]") {
  for (const float q : {0.0F, nan_f, inf_f, -1.0F, 1e30F, 1e-4F}) {
    CAPTURE(q);
    scene::Frame frame;
    frame.q.assign(320 * 240, q);
    CHECK(scene::find(frame, {.max_planes = 5}).result.found.readings == 0);
    std::vector<std::byte> workspace(RansacSearch::workspace_bytes(scene::size, {}));
    RansacSearch object;
    REQUIRE(RansacSearch::prepare(object, scene::size, {}, workspace) == Status::ok);
    std::vector<ProposedPlane> out(8);
    const RansacSearchResult result = object.run(FrameCells(frame.view()).view(), {}, out);
    CHECK(result.status == Status::ok);
    CHECK(result.candidates == 0);
    CHECK(result.readings == 0);
  }
}

TEST_CASE("White noise in depth has no candidates", "[ransac]") {
  scene::Frame frame;
  Pcg32 random(31);
  for (int i = 0; i < 320 * 240; ++i)
    frame.q.push_back(0.2F + static_cast<float>(random.below(1000)) / 1000.0F);
  std::vector<std::byte> workspace(RansacSearch::workspace_bytes(scene::size, {}));
  RansacSearch object;
  REQUIRE(RansacSearch::prepare(object, scene::size, {}, workspace) == Status::ok);
  std::vector<ProposedPlane> out(8);
  CHECK(object.run(FrameCells(frame.view()).view(), {}, out).candidates == 0);
}

TEST_CASE("Frames of any size can be searched", "[ransac]") {
  for (const Size size : {Size{1, 1}, Size{1, 300}, Size{300, 1}, Size{17, 13}, Size{129, 67}}) {
    CAPTURE(size.width, size.height);
    std::vector<float> q(static_cast<std::size_t>(size.width * size.height), 0.4F);
    for (const std::int32_t cell : {4, 8, 16}) {
      const RansacSearchOptions options{.cell = cell, .min_pixels = 50};
      std::vector<std::byte> workspace(RansacSearch::workspace_bytes(size, options));
      RansacSearch object;
      REQUIRE(RansacSearch::prepare(object, size, options, workspace) == Status::ok);
      std::vector<ProposedPlane> out(8);
      const RansacSearchResult result = object.run(FrameCells({q.data(), size}).view(), {}, out);
      CHECK(result.status == Status::ok);
      CHECK(result.candidates == (size.width > (cell < 16 ? 16 : 100) && size.height > 12 ? 1U : 0U));
    }
  }
}

TEST_CASE("Options out of range are refused", "[ransac]") {
  CHECK(prepare_with([](RansacOptions&) {}) == Status::ok);
  CHECK(prepare_with([](RansacOptions& o) { o.gate.sigmas = nan_d; }) == Status::invalid_option);
  CHECK(prepare_with([](RansacOptions& o) { o.gate.fixed_m = nan_d; }) == Status::invalid_option);
  CHECK(prepare_with([](RansacOptions& o) { o.subset = 15; }) == Status::invalid_option);
  CHECK(prepare_with([](RansacOptions& o) { o.near_radius = nan_d; }) == Status::invalid_option);
  CHECK(prepare_with([](RansacOptions& o) { o.near_radius = -1; }) == Status::invalid_option);
  CHECK(prepare_with([](RansacOptions& o) { o.confidence = nan_d; }) == Status::invalid_option);
  CHECK(prepare_with([](RansacOptions& o) { o.confidence = 1; }) == Status::invalid_option);
  CHECK(prepare_with([](RansacOptions& o) { o.max_iterations = 0; }) == Status::invalid_option);
  CHECK(prepare_with([](RansacOptions& o) { o.max_planes = 65536; }) == Status::invalid_option);
  CHECK(prepare_with([](RansacOptions& o) { o.min_inliers = 2; }) == Status::invalid_option);
  CHECK(prepare_with([](RansacOptions& o) { o.min_share = nan_d; }) == Status::invalid_option);
  CHECK(prepare_with([](RansacOptions& o) { o.piece_cell_m = 0; }) == Status::invalid_option);
  CHECK(prepare_search_with([](RansacSearchOptions&) {}) == Status::ok);
  CHECK(prepare_search_with([](RansacSearchOptions& o) { o.gate.inverse_sigma = nan_d; }) ==
        Status::invalid_option);
  CHECK(prepare_search_with([](RansacSearchOptions& o) { o.cell = 5; }) == Status::invalid_option);
  CHECK(prepare_search_with([](RansacSearchOptions& o) { o.min_pixels = 0; }) == Status::invalid_option);
  CHECK(prepare_search_with([](RansacSearchOptions& o) { o.max_candidates = 0; }) == Status::invalid_option);
  CHECK(prepare_search_with([](RansacSearchOptions& o) { o.max_rms = nan_d; }) == Status::invalid_option);
  CHECK(prepare_search_with([](RansacSearchOptions& o) { o.rough_rms = 1.1; }) == Status::invalid_option);
  CHECK(prepare_search_with([](RansacSearchOptions& o) { o.most_noise = 0.5; }) == Status::invalid_option);
  CHECK(prepare_search_with([](RansacSearchOptions& o) { o.confidence = 0; }) == Status::invalid_option);
  CHECK(prepare_search_with([](RansacSearchOptions& o) { o.max_draws = 0; }) == Status::invalid_option);
}

TEST_CASE("Views and memory that do not fit are refused", "[ransac]") {
  RansacPlanes unprepared;
  const scene::Cloud cloud = repeated(10, 1, 1, 2);
  std::vector<FoundPlane> out(4);
  CHECK(unprepared.run(cloud.view(), out, {}).status == Status::not_prepared);
  std::vector<std::byte> workspace;
  RansacPlanes object = scene::prepared(10, {}, workspace);
  CHECK(object.run(PointsView{}, out, {}).status == Status::invalid_image);
  CHECK(object.run(repeated(11, 1, 1, 2).view(), out, {}).status == Status::size_mismatch);
  std::vector<std::uint16_t> labels(9);
  CHECK(object.run(cloud.view(), out, labels).status == Status::size_mismatch);
  CHECK(object.run(cloud.view(), {}, {}).status == Status::ok);
  const float q[12] = {};
  CHECK(object.run({q, Size{3, 4}}, scene::camera, out, {}).status == Status::size_mismatch);
  CHECK(object.run({q, Size{3, 3}}, PinholeCamera{0, 1, 1, 1}, out, {}).status == Status::invalid_image);
  CHECK(object.run({q, Size{3, 3}}, scene::camera, out, {labels.data(), Size{9, 1}}).status ==
        Status::size_mismatch);
  CHECK(RansacPlanes::prepare(object, 10, {}, std::span(workspace).first(workspace.size() - 64)) ==
        Status::workspace_too_small);
  CHECK(object.run(cloud.view(), out, {}).status == Status::not_prepared);
  CHECK(RansacPlanes::prepare(object, 0, {}, workspace) == Status::too_large);

  RansacSearch search;
  std::vector<ProposedPlane> candidates(4);
  const FrameCells cells({q, Size{3, 4}}), wide({q, Size{12, 1}}), coarse({q, Size{3, 4}}, 1);
  CHECK(search.run(cells.view(), {}, candidates).status == Status::not_prepared);
  std::vector<std::byte> memory(RansacSearch::workspace_bytes({3, 4}, {}));
  CHECK(RansacSearch::prepare(search, {3, 4}, {}, std::span(memory).first(100)) ==
        Status::workspace_too_small);
  CHECK(RansacSearch::prepare(search, {0, 4}, {}, memory) == Status::invalid_image);
  CHECK(RansacSearch::workspace_bytes({0, 4}, {}) == 0);
  REQUIRE(RansacSearch::prepare(search, {3, 4}, {}, memory) == Status::ok);
  CHECK(search.run(wide.view(), {}, candidates).status == Status::size_mismatch);
  CHECK(search.run(coarse.view(), {}, candidates).status == Status::size_mismatch);
  CHECK(search.run(DepthCells(), {}, candidates).status == Status::size_mismatch);
  const std::uint16_t mask[12] = {};
  CHECK(search.run(cells.view(), {mask, Size{4, 3}}, candidates).status == Status::size_mismatch);
  CHECK(search.run(cells.view(), {mask, Size{3, 4}}, candidates).status == Status::ok);
}
