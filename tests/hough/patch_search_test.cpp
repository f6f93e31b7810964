// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>

#include "patch_testing.hpp"
#include "support/catch.hpp"

using namespace straightedge;
using test::Face;
using test::find;
using test::Found;
using test::has;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr float nan_f = std::numeric_limits<float>::quiet_NaN();

const Face wall{test::plane_of({0.1, 0.05, 1}, 2.5)};
const Face floor_face{test::plane_of({0, 1, 0.3}, 1.2), 0, 150};
const Face box{test::plane_of({-0.6, 0.1, 0.8}, 1.3), 90, 60, 150, 130};

}  // namespace

TEST_CASE("patches: one wall is one candidate, close to the truth") {
  const Found found = find(test::room({wall}));
  REQUIRE(found.result.status == Status::ok);
  REQUIRE(found.candidates.size() == 1);
  CHECK(has(found, wall.plane, 0.003, 0.003));
  CHECK(found.candidates[0].readings > 0.95 * 320 * 240);
  CHECK(found.candidates[0].fit.n == found.candidates[0].readings);
  CHECK(found.result.readings == 320 * 240);
}

TEST_CASE("patches: wall, floor and a box's face are three, the largest first") {
  const Found found = find(test::room({wall, floor_face, box}));
  REQUIRE(found.candidates.size() == 3);
  CHECK(has(found, wall.plane, 0.01, 0.01));
  CHECK(has(found, floor_face.plane, 0.01, 0.01));
  CHECK(has(found, box.plane, 0.02, 0.01));
  CHECK(found.candidates[0].readings >= found.candidates[1].readings);
  CHECK(found.candidates[1].readings >= found.candidates[2].readings);
}

TEST_CASE("patches: parallel planes ten centimetres apart stay two") {
  const Face near{test::plane_of({0, 0, 1}, 2.0)};
  const Face behind{test::plane_of({0, 0, 1}, 2.1), 160};
  const Found found = find(test::room({near, behind}));
  REQUIRE(found.candidates.size() == 2);
  CHECK(has(found, near.plane, 0.005, 0.005));
  CHECK(has(found, behind.plane, 0.005, 0.005));
}

TEST_CASE("patches: a wall in two parts that an occluder divides is one candidate") {
  const Face pillar{test::plane_of({0, 0, 1}, 1.2), 130, 0, 190};
  const Found found = find(test::room({wall, pillar}));
  REQUIRE(found.candidates.size() == 2);
  CHECK(has(found, wall.plane, 0.004, 0.004));
}

TEST_CASE("patches: pixels with a label do not take part") {
  const auto picture = test::room({wall, floor_face});
  Image<std::uint16_t> mask(picture.size(), std::uint16_t{0});
  for (std::int32_t y = 0; y < 150; ++y) std::fill_n(mask.view().row(y), 320, std::uint16_t{7});
  const Found found = find(picture, {}, mask.view());
  REQUIRE(found.candidates.size() == 1);
  CHECK(has(found, floor_face.plane, 0.01, 0.01));
  CHECK(found.result.readings == 320 * 90);
}

TEST_CASE("patches: without readings there is nothing") {
  const Size size{320, 240};
  for (const float nothing : {0.0F, -1.0F, nan_f, std::numeric_limits<float>::infinity(), 2e4F}) {
    const Found found = find(Image<float>(size, nothing));
    CHECK(found.result.status == Status::ok);
    CHECK(found.candidates.empty());
    CHECK(found.result.readings == 0);
    CHECK(found.search->patches().empty());
  }
}

TEST_CASE("patches: readings of no number are holes, in whichever pattern") {
  auto picture = test::room({wall, floor_face});
  Pcg32 random(8);
  for (std::int32_t y = 0; y < 240; ++y) {
    for (std::int32_t x = 0; x < 320; ++x) {
      if (random.below(5) < 2) picture.at(x, y) = random.below(2) == 0 ? nan_f : 0.0F;
    }
  }
  const Found found = find(picture);
  REQUIRE(found.candidates.size() == 2);
  CHECK(has(found, wall.plane, 0.01, 0.01));
  CHECK(has(found, floor_face.plane, 0.01, 0.01));
}

TEST_CASE("patches: noise alone has no plane") {
  Image<float> picture({320, 240}, 0.0F);
  Pcg32 random(5);
  for (std::int32_t i = 0; i < 320 * 240; ++i) {
    picture.at(i % 320, i / 320) = static_cast<float>(0.3 + 0.5 * test::uniform(random));
  }
  const Found found = find(picture);
  CHECK(found.result.status == Status::ok);
  CHECK(found.candidates.empty());
}

TEST_CASE("patches: sizes that no cell divides, down to one pixel") {
  for (const Size size : {Size{1, 1}, Size{7, 5}, Size{8, 8}, Size{33, 65}, Size{129, 70}}) {
    const Found found = find(test::depth_scene(size, test::camera_for(size), {wall}, 0, 1));
    CHECK(found.result.status == Status::ok);
    CHECK(found.result.readings == static_cast<std::uint32_t>(size.width * size.height));
    const bool enough = size.width * size.height >= 300;
    REQUIRE(found.candidates.size() == (enough ? 1 : 0));
    if (enough) CHECK(has(found, wall.plane, 0.01, 0.01, test::camera_for(size)));
  }
}

TEST_CASE("patches: planes far beyond the greatest distance share a cell and are still found") {
  HoughPatchOptions options;
  options.gate.inverse_sigma = 1e-7;
  const Face far{test::plane_of({0.2, 0, 1}, 1000)};
  const Face aside{test::plane_of({-0.5, 0.1, 1}, 900), 160};
  const Found found = find(test::room({far, aside}, 1e-7), options);
  REQUIRE(found.candidates.size() == 2);
  CHECK(has(found, far.plane, 0.01, 5));
  CHECK(has(found, aside.plane, 0.01, 5));
}

TEST_CASE("patches: a fixed threshold in metres serves too") {
  const Found found = find(test::room({wall, floor_face}, 2e-4), {.gate = {.fixed_m = 0.02}});
  REQUIRE(found.candidates.size() == 2);
  CHECK(has(found, wall.plane, 0.01, 0.01));
  CHECK(has(found, floor_face.plane, 0.01, 0.01));
}

TEST_CASE("patches: none is smaller than the smallest that is wanted") {
  const Image<float> picture = test::room({wall, floor_face, box});
  for (const std::int32_t smallest : {8, 16, 32, 64}) {
    const Found found = find(picture, {.smallest_patch = smallest});
    std::int32_t least = 64;
    for (const HoughPatch& patch : found.search->patches()) least = std::min(least, patch.side);
    CHECK(least == smallest);
    CHECK(has(found, wall.plane, 0.01, 0.01));
    CHECK(has(found, floor_face.plane, 0.01, 0.01));
  }
}

TEST_CASE("patches: options that are no numbers or out of range are refused") {
  const auto refused = [](auto member, auto value) {
    HoughPatchOptions options;
    options.*member = value;
    HoughPatchSearch search;
    std::vector<std::byte> memory(1 << 20);
    CHECK(HoughPatchSearch::workspace_bytes({64, 64}, options) == 0);
    CHECK(HoughPatchSearch::prepare(search, {64, 64}, options, memory) == Status::invalid_option);
  };
  using O = HoughPatchOptions;
  for (const double bad : {not_a_number, -1.0, std::numeric_limits<double>::infinity()}) {
    for (auto member :
         {&O::max_distance_m, &O::shared_noise_pixels, &O::max_spread_rad, &O::warp_sigmas, &O::bend_rad}) {
      refused(member, bad);
    }
  }
  refused(&O::max_distance_m, 0.0);
  refused(&O::max_spread_rad, 1.1);
  for (const int bad : {0, -1, 12, 128}) refused(&O::largest_patch, bad);
  for (const int bad : {0, 4, 24, 128}) refused(&O::smallest_patch, bad);
  CHECK(HoughPatchSearch::workspace_bytes({64, 64}, {.largest_patch = 16, .smallest_patch = 32}) == 0);
  for (const int bad : {0, -5, 1025}) refused(&O::max_candidates, bad);
  for (const int bad : {0, 17}) refused(&O::rounds, bad);
  refused(&O::accumulator, HoughAccumulatorOptions{HoughCells::ball, 2, 10});
}

TEST_CASE("patches: views, sizes, gates and memory that do not fit are told") {
  const Size size{64, 48};
  HoughPatchSearch search;
  std::array<ProposedPlane, 4> out;
  const Image<float> picture(size, 0.5F);
  const PinholeCamera camera = test::camera_for(size);
  CHECK(search.run(picture, camera, {}, out).status == Status::not_prepared);
  const std::size_t bytes = HoughPatchSearch::workspace_bytes(size, {});
  static_assert(HoughPatchSearch::workspace_bytes({640, 480}, {}) < 16 << 20);
  std::vector<std::byte> memory(bytes + 64);
  const auto start = reinterpret_cast<std::uintptr_t>(memory.data());
  std::byte* worst = memory.data() + (65 - start % 64) % 64;  // an address that wastes most
  CHECK(HoughPatchSearch::prepare(search, size, {}, {worst, bytes - 1}) == Status::workspace_too_small);
  CHECK(search.run(picture, camera, {}, out).status == Status::not_prepared);
  REQUIRE(HoughPatchSearch::prepare(search, size, {}, {worst, bytes}) == Status::ok);
  CHECK(search.run(picture, camera, {}, out).status == Status::ok);
  CHECK(search.run({}, camera, {}, out).status == Status::invalid_image);
  CHECK(search.run(picture, PinholeCamera{0, 1, 0, 0}, {}, out).status == Status::invalid_image);
  CHECK(search.run(picture, PinholeCamera{not_a_number, 1, 0, 0}, {}, out).status == Status::invalid_image);
  CHECK(HoughPatchSearch::prepare(search, size, {.gate = {.inverse_sigma = not_a_number}}, memory) ==
        Status::invalid_option);
  REQUIRE(HoughPatchSearch::prepare(search, size, {}, {worst, bytes}) == Status::ok);
  CHECK(search.run(Image<float>({64, 47}), camera, {}, out).status == Status::size_mismatch);
  const Image<std::uint16_t> mask({63, 48});
  CHECK(search.run(picture, camera, mask.view(), out).status == Status::size_mismatch);
  CHECK(HoughPatchSearch::prepare(search, {0, 5}, {}, memory) == Status::invalid_image);
  CHECK(HoughPatchSearch::prepare(search, {32768, 1}, {}, memory) == Status::too_large);
  CHECK(HoughPatchSearch::workspace_bytes({32767, 32767}, {}) == 0);
}

TEST_CASE("patches: a full output has the largest") {
  const auto picture = test::room({wall, floor_face, box});
  const Found all = find(picture);
  REQUIRE(all.candidates.size() == 3);
  const Found some = find(picture, {}, {}, 2);
  CHECK(some.result.status == Status::output_full);
  REQUIRE(some.candidates.size() == 2);
  CHECK(some.candidates[0].fit.plane == all.candidates[0].fit.plane);
  CHECK(some.candidates[1].fit.plane == all.candidates[1].fit.plane);
  HoughPatchOptions one;
  one.max_candidates = 1;
  CHECK(find(picture, one).candidates.size() == 1);
}

TEST_CASE("patches: the trace sees votes, peaks and planes, and can stop the run") {
  struct Seen {
    std::uint32_t counts[3] = {};
    std::uint32_t stop_after = UINT32_MAX;
  };
  const auto watch = [](void* user, const HoughPlaneEvent& event) {
    Seen& seen = *static_cast<Seen*>(user);
    ++seen.counts[static_cast<int>(event.step)];
    CHECK(length(event.plane.normal) == Approx(1).epsilon(1e-12));
    return seen.counts[0] + seen.counts[1] + seen.counts[2] < seen.stop_after;
  };
  const auto picture = test::room({wall, floor_face});
  Seen seen;
  const Found found = find(picture, {}, {}, 64, {watch, &seen});
  CHECK(found.result.status == Status::ok);
  CHECK(seen.counts[0] == found.result.votes);
  CHECK(seen.counts[1] >= seen.counts[2]);
  CHECK(seen.counts[2] == 2);
  Seen impatient;
  impatient.stop_after = 5;
  CHECK(find(picture, {}, {}, 64, {watch, &impatient}).result.status == Status::cancelled);
  CHECK(impatient.counts[0] == 5);
}

TEST_CASE("patches: what a run leaves behind: patches that tile, votes that count readings") {
  HoughPatchOptions options;
  options.rounds = 1;
  const Found found = find(test::room({wall, floor_face}), options);
  Image<std::uint8_t> covered({320, 240}, std::uint8_t{0});
  double votes = 0;
  for (const HoughPatch& patch : found.search->patches()) {
    for (std::int32_t y = patch.y; y < std::min<std::int32_t>(240, patch.y + patch.side); ++y) {
      for (std::int32_t x = patch.x; x < std::min<std::int32_t>(320, patch.x + patch.side); ++x)
        ++covered.at(x, y);
    }
    if (patch.votes) votes += hough_patch_vote * static_cast<double>(patch.cell.n);
  }
  const std::uint8_t* first = covered.view().data;
  CHECK(*std::max_element(first, first + 320 * 240) == 1);
  double cast = 0;
  for (const std::uint32_t cell : found.search->accumulator().votes()) cast += cell;
  CHECK(cast == Approx(votes).epsilon(0.1));
}
