// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>

#include "cloud_testing.hpp"
#include "support/catch.hpp"

using namespace straightedge;
using test::Cloud;
using test::CloudFound;
using test::corner;
using test::find_planes;
using test::has_corner;
using test::options_for;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr float nan_f = std::numeric_limits<float>::quiet_NaN();
constexpr HoughPlaneVoting votings[] = {HoughPlaneVoting::standard, HoughPlaneVoting::randomized};

}  // namespace

TEST_CASE("clouds: a corner and a table: four planes, in either accumulator, by either voting") {
  const Cloud cloud = corner(1);
  for (const HoughPlaneVoting voting : votings) {
    for (const HoughCells cells : {HoughCells::array, HoughCells::ball}) {
      INFO("voting " << static_cast<int>(voting) << " cells " << static_cast<int>(cells));
      HoughPlaneOptions options = options_for(voting);
      options.accumulator.cells = cells;
      const CloudFound found = find_planes(cloud.view(), options);
      REQUIRE(found.status == Status::ok);
      CHECK(found.planes.size() == 4);
      CHECK(has_corner(found));
      CHECK(found.found.readings == cloud.size());
      CHECK(found.found.seed == 1);
      CHECK(found.search->confident());
    }
  }
}

TEST_CASE("clouds: labels, inliers and order fit together") {
  const Cloud cloud = corner(2);
  for (const HoughPlaneVoting voting : votings) {
    const CloudFound found = find_planes(cloud.view(), options_for(voting));
    std::uint32_t labelled = 0;
    for (std::size_t i = 0; i < found.planes.size(); ++i) {
      const auto own = std::count(found.labels.begin(), found.labels.end(), i + 1);
      CHECK(static_cast<std::uint32_t>(own) == found.planes[i].inliers);
      CHECK(found.planes[i].score >= 3);
      CHECK(found.planes[i].iterations >= 1);
      if (i > 0) CHECK(found.planes[i].inliers <= found.planes[i - 1].inliers);
      labelled += found.planes[i].inliers;
    }
    CHECK(labelled == found.found.labelled);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      if (found.labels[i] == 0) continue;
      const Plane& plane = found.planes[found.labels[i] - 1U].fit.plane;
      const double off = plane.signed_distance(cloud.view().at(i));
      CHECK((off <= 0.0200001 && off >= -0.0200001));
    }
  }
}

TEST_CASE("clouds: a kilometre away the same planes are found") {
  const Vector3 at{1000, -800, 500};
  const Cloud cloud = corner(3, at);
  for (const HoughPlaneVoting voting : votings) {
    const CloudFound found = find_planes(cloud.view(), options_for(voting));
    CHECK(found.planes.size() == 4);
    // An angle of a thousandth is a metre there.
    CHECK(has_corner(found, at, 6));
    CHECK(length(found.search->origin() - at) < 5);
  }
}

TEST_CASE("clouds: points with a coordinate that is no number have no label and do no harm") {
  Cloud cloud = corner(4);
  Pcg32 random(9);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (random.below(3) != 0) continue;
    (i % 3 == 0   ? cloud.x
     : i % 3 == 1 ? cloud.y
                  : cloud.z)[i] = i % 2 == 0 ? nan_f : std::numeric_limits<float>::infinity();
  }
  for (const HoughPlaneVoting voting : votings) {
    const CloudFound found = find_planes(cloud.view(), options_for(voting));
    CHECK(has_corner(found));
    CHECK(found.found.readings < 0.7 * static_cast<double>(cloud.size()));
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      if (!finite(cloud.view().at(i))) CHECK(found.labels[i] == 0);
    }
  }
}

TEST_CASE("clouds: clouds without a plane give an empty result") {
  Cloud empty, equal, line, two, strip;
  Pcg32 random(5);
  for (int i = 0; i < 2000; ++i) {
    empty.add({not_a_number, not_a_number, not_a_number});
    equal.add({1, 2, 3});
    const double t = test::uniform(random);
    line.add({t, 1 + 2 * t, 3 - t});
    strip.add({t, 0.004 * test::normal_number(random), 3 + 0.004 * test::normal_number(random)});
  }
  two.add({0, 0, 1});
  two.add({1, 0, 1});
  for (const HoughPlaneVoting voting : votings) {
    HoughPlaneOptions options = options_for(voting);
    options.max_draws = 5'000;
    for (const Cloud* cloud : {&empty, &equal, &line, &two, &strip}) {
      const CloudFound found = find_planes(cloud->view(), options);
      CHECK(found.status == Status::ok);
      CHECK(found.planes.empty());
      CHECK(std::count(found.labels.begin(), found.labels.end(), 0) ==
            static_cast<std::ptrdiff_t>(cloud->size()));
    }
  }
}

TEST_CASE("clouds: one plane only, and one with three points") {
  Pcg32 random(6);
  Cloud cloud, three;
  cloud.add_disc({1, 2, 3}, normalized({1, 1, 1}), 1, 3000, 0, random);
  for (const Vector3& p : {Vector3{0, 0, 1}, Vector3{1, 0, 1}, Vector3{0, 1, 1}}) three.add(p);
  for (const HoughPlaneVoting voting : votings) {
    HoughPlaneOptions options = options_for(voting);
    const CloudFound found = find_planes(cloud.view(), options);
    REQUIRE(found.planes.size() == 1);
    CHECK(test::has(found, test::plane_of({1, 1, 1}, 6 / __builtin_sqrt(3.0)), 1e-5, 1e-5));
    CHECK(found.planes[0].inliers == 3000);
    options.min_points = 3;
    options.every = 1;
    options.triple_threshold = 1;
    options.triple_max_m = 2;
    const CloudFound small = find_planes(three.view(), options);
    REQUIRE(small.planes.size() == 1);
    CHECK(test::has(small, test::plane_of({0, 0, 1}, 1), 1e-6, 1e-6));
  }
}

TEST_CASE("clouds: a depth camera's noise model gates by 1/z") {
  Pcg32 random(7);
  Cloud cloud;
  // A wall four metres away, where the sensor's noise is 2.3 cm: a fixed gate of 2 cm would lose half of it.
  for (int i = 0; i < 6000; ++i) {
    const double z = 1 / (0.25 + 1.425e-3 * test::normal_number(random));
    cloud.add({z * (test::uniform(random) - 0.5), z * (test::uniform(random) - 0.5), z});
  }
  for (const HoughPlaneVoting voting : votings) {
    HoughPlaneOptions options = options_for(voting);
    options.gate = {};
    const CloudFound found = find_planes(cloud.view(), options);
    REQUIRE(found.planes.size() == 1);
    CHECK(found.planes[0].inliers > 5900);
    CHECK(test::has(found, test::plane_of({0, 0, 1}, 4), 0.003, 0.01));
  }
}

TEST_CASE("clouds: options that are no numbers or out of range are refused") {
  const auto refused = [](auto member, auto value) {
    HoughPlaneOptions options;
    options.*member = value;
    HoughPlanes search;
    std::vector<std::byte> memory(8 << 20);
    CHECK(HoughPlanes::workspace_bytes(100, options) == 0);
    CHECK(HoughPlanes::prepare(search, 100, options, memory) == Status::invalid_option);
  };
  using O = HoughPlaneOptions;
  for (const double bad : {not_a_number, -1.0, std::numeric_limits<double>::infinity()}) {
    for (auto member : {&O::distance_step_m, &O::triple_min_m, &O::triple_max_m, &O::confidence}) {
      refused(member, bad);
    }
  }
  refused(&O::confidence, 1.0);
  refused(&O::triple_min_m, 1.0);
  refused(&O::gate, PlaneGate{.sigmas = not_a_number});
  refused(&O::voting, static_cast<HoughPlaneVoting>(5));
  refused(&O::min_points, 2U);
  refused(&O::max_planes, 0U);
  refused(&O::max_planes, 1025U);
  refused(&O::every, 0U);
  refused(&O::triple_threshold, 0U);
  refused(&O::max_draws, 0U);
  refused(&O::accumulator, HoughAccumulatorOptions{HoughCells::ball, 45, 0});
}

TEST_CASE("clouds: clouds, labels and memory that do not fit are told") {
  const Cloud cloud = corner(8);
  HoughPlanes search;
  PlanesFound found;
  std::vector<std::uint16_t> labels(cloud.size());
  std::vector<FoundPlane> planes(8);
  CHECK(search.run(cloud.view(), labels, planes, found) == Status::not_prepared);
  const std::size_t bytes = HoughPlanes::workspace_bytes(cloud.size(), {});
  std::vector<std::byte> memory(bytes + 64);
  const auto start = reinterpret_cast<std::uintptr_t>(memory.data());
  std::byte* worst = memory.data() + (65 - start % 64) % 64;  // an address that wastes most
  CHECK(HoughPlanes::prepare(search, cloud.size(), {}, {worst, bytes - 1}) == Status::workspace_too_small);
  CHECK(search.run(cloud.view(), labels, planes, found) == Status::not_prepared);
  REQUIRE(HoughPlanes::prepare(search, cloud.size(), {}, {worst, bytes}) == Status::ok);
  CHECK(search.run({}, labels, planes, found) == Status::invalid_image);
  CHECK(search.run(cloud.view(), std::span(labels).first(5), planes, found) == Status::size_mismatch);
  PointsView more = cloud.view();
  more.count += 1;
  CHECK(search.run(more, labels, planes, found) == Status::too_large);
  CHECK(search.run(cloud.view(), labels, {}, found) == Status::ok);
  CHECK(found.planes == 0);
  CHECK(search.run(cloud.view(), labels, std::span(planes).first(2), found) == Status::ok);
  CHECK(found.planes == 2);
  CHECK(HoughPlanes::prepare(search, 0, {}, memory) == Status::invalid_image);
  CHECK(HoughPlanes::prepare(search, std::size_t{1} << 30U, {}, memory) == Status::too_large);
}

TEST_CASE("clouds: the trace sees every vote and plane, and can stop the run") {
  struct Seen {
    std::uint32_t counts[3] = {};
    std::uint32_t stop_after = UINT32_MAX;
  };
  const auto watch = [](void* user, const HoughPlaneEvent& event) {
    Seen& seen = *static_cast<Seen*>(user);
    ++seen.counts[static_cast<int>(event.step)];
    return seen.counts[0] + seen.counts[1] + seen.counts[2] < seen.stop_after;
  };
  const Cloud cloud = corner(9);
  for (const HoughPlaneVoting voting : votings) {
    Seen seen;
    const CloudFound found = find_planes(cloud.view(), options_for(voting), 64, {watch, &seen});
    CHECK(found.status == Status::ok);
    CHECK(seen.counts[0] > 100);
    CHECK(seen.counts[0] <= found.found.iterations);
    CHECK(seen.counts[1] >= seen.counts[2]);
    CHECK(seen.counts[2] == 4);
    Seen impatient;
    impatient.stop_after = 7;
    const CloudFound stopped = find_planes(cloud.view(), options_for(voting), 64, {watch, &impatient});
    CHECK(stopped.status == Status::cancelled);
    CHECK(impatient.counts[0] + impatient.counts[1] + impatient.counts[2] == 7);
  }
}

TEST_CASE("clouds: the number of draws follows its bound, and max_draws ends sooner") {
  HoughPlaneOptions options;
  options.min_points = 1000;
  options.triple_threshold = 1;
  options.confidence = 0.99;
  // k = 4.60517, sqrt = ((9.21034)^0.5 + (13.21034)^0.5) / 2 = 3.33473, squared 11.1204; times 8 cells.
  CHECK(triples_needed(1000, options) == 89);
  const double ten = 10.0 * (9999.0 / 999) * (9998.0 / 998);
  CHECK(static_cast<double>(triples_needed(10'000, options)) == Approx(8 * 11.1204 * ten).epsilon(1e-4));
  CHECK(triples_needed(999, options) == 0);
  options.min_points = 3;
  CHECK(triples_needed(std::size_t{1} << 29U, options) == 4'000'000'000'000'000'000U);

  HoughPlaneOptions few = options_for(HoughPlaneVoting::randomized);
  few.max_draws = 10;
  const Cloud cloud = corner(10);
  const CloudFound found = find_planes(cloud.view(), few);
  CHECK(found.found.iterations == 10);
  CHECK_FALSE(found.search->confident());
}

TEST_CASE("clouds: standard: found planes take their votes back, every one") {
  HoughPlaneOptions options = options_for(HoughPlaneVoting::standard);
  options.every = 1;
  Pcg32 random(11);
  Cloud cloud;
  cloud.add_disc({0, 0, 3}, {0, 0, 1}, 1, 2000, 0, random);
  const CloudFound found = find_planes(cloud.view(), options);
  REQUIRE(found.planes.size() == 1);
  CHECK(found.found.iterations == 2000);
  for (const std::uint32_t votes : found.search->accumulator().votes()) REQUIRE(votes == 0);
}
