// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <vector>

#include "scene.hpp"
#include "straightedge/host/frame_cells.hpp"
#include "straightedge/ransac_search.hpp"
#include "support/catch.hpp"

using namespace straightedge;

namespace {

constexpr ProposedPlane untouched{.score = -1, .readings = 77};

struct Found {
  RansacSearchResult result;
  std::vector<ProposedPlane> candidates;
};

Found search(ImageView<const float> q, const RansacSearchOptions& options = {},
             ImageView<const std::uint16_t> mask = {}, std::size_t room = 64) {
  std::vector<std::byte> workspace(RansacSearch::workspace_bytes(q.size(), options));
  RansacSearch object;
  REQUIRE(RansacSearch::prepare(object, q.size(), options, workspace) == Status::ok);
  Found found;
  found.candidates.assign(room, untouched);
  found.result = object.run(FrameCells(q).view(), mask, found.candidates);
  for (std::size_t i = found.result.candidates; i < room; ++i) CHECK(found.candidates[i].readings == 77);
  found.candidates.resize(found.result.candidates);
  return found;
}

/// Share of the pixels of a true plane that are within three sigma of the candidate.
double covered(const scene::Frame& frame, int label, const InverseDepthPlane& truth,
               const InverseDepthPlane& p) {
  std::size_t inside = 0, all = 0;
  for (std::int32_t v = 0; v < scene::size.height; ++v)
    for (std::int32_t u = 0; u < scene::size.width; ++u) {
      if (frame.truth[static_cast<std::size_t>(v * scene::size.width + u)] != label) continue;
      ++all;
      const double off = truth.at(u, v) - p.at(u, v);
      inside += off * off < 9 * scene::sigma * scene::sigma ? 1 : 0;
    }
  return static_cast<double>(inside) / static_cast<double>(all);
}

bool has_candidate(const Found& found, const scene::Frame& frame, int label, const Plane& truth) {
  for (const ProposedPlane& c : found.candidates) {
    PlaneFit fit;
    if (to_plane_fit(c.fit, scene::sigma, scene::camera, fit) != Status::ok) return false;
    if (scene::error_of(fit.plane, truth).angle < 2 * 0.0175 &&
        covered(frame, label, to_inverse_depth(truth, scene::camera), c.fit.plane) > 0.95)
      return true;
  }
  return false;
}

}  // namespace

TEST_CASE("Walls, floor and faces of a box have candidates, with holes too", "[ransac]") {
  for (const double holes : {0.0, 0.6}) {
    int missed = 0, all = 0, surplus = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      CAPTURE(seed, holes);
      Pcg32 random(seed);
      const scene::Room room = scene::room_by_chance(random);
      const scene::Frame frame = scene::render(room, scene::sigma, holes, random);
      const Found found = search(frame.view(), {.seed = seed});
      REQUIRE(found.result.status == Status::ok);
      CHECK(found.result.seed == seed);
      CHECK(found.result.noise < 1.1);
      CHECK(found.result.explained <= found.result.readings);
      int label = 0;
      const auto look = [&](const Plane& plane) {
        if (frame.pixels_of(++label) < (holes > 0 ? 400U : 1000U)) return;
        ++all;
        missed += has_candidate(found, frame, label, plane) ? 0 : 1;
      };
      for (const Plane& plane : room.planes) look(plane);
      for (const scene::Face& face : room.faces) look(face.plane);
      surplus += static_cast<int>(found.candidates.size()) - label;
      for (std::size_t i = 1; i < found.candidates.size(); ++i)
        CHECK(found.candidates[i - 1].score >= found.candidates[i].score);
    }
    CAPTURE(holes, all);
    CHECK(missed * 50 <= all);
    CHECK(surplus <= 8);
  }
}

TEST_CASE("A strip of two cells along the right or lower border has a candidate in pictures of any size",
          "[ransac]") {
  constexpr std::int32_t thick = 8, length = 200;
  constexpr InverseDepthPlane wall{1e-4, 2e-4, 0.3}, strip{-1e-4, 3e-4, 0.5};
  for (std::int32_t side = 120; side < 160; side += 4) {
    for (const bool below : {false, true}) {
      CAPTURE(side, below);
      const Size size = below ? Size{length, side} : Size{side, length};
      Pcg32 random(1);
      std::vector<float> q;
      for (std::int32_t v = 0; v < size.height; ++v)
        for (std::int32_t u = 0; u < size.width; ++u) {
          const InverseDepthPlane& seen = (below ? v : u) >= side - thick ? strip : wall;
          q.push_back(static_cast<float>(seen.at(u, v) + scene::sigma * scene::noise(random)));
        }
      bool has_strip = false;
      for (const ProposedPlane& c : search({q.data(), size}).candidates) {
        bool near = true;
        for (const std::int32_t along : {std::int32_t{0}, std::int32_t{length - 1}})
          for (const std::int32_t across : {side - thick, side - 1}) {
            const std::int32_t u = below ? along : across, v = below ? across : along;
            near = near && std::abs(c.fit.plane.at(u, v) - strip.at(u, v)) < 3 * scene::sigma;
          }
        has_strip = has_strip || near;
      }
      CHECK(has_strip);
    }
  }
}

TEST_CASE("The same seed gives the same bits, and a stride changes none", "[ransac]") {
  Pcg32 random(3);
  const scene::Frame frame = scene::render(scene::room_by_chance(random), scene::sigma, 0.3, random);
  const Found a = search(frame.view());
  const Found b = search(frame.view());
  std::vector<float> wide(static_cast<std::size_t>((scene::size.width + 7) * scene::size.height), 9.0F);
  const ImageView<float> strided(wide.data(), scene::size,
                                 static_cast<std::ptrdiff_t>(sizeof(float)) * (scene::size.width + 7));
  for (std::int32_t v = 0; v < scene::size.height; ++v)
    for (std::int32_t u = 0; u < scene::size.width; ++u) strided.at(u, v) = frame.view().at(u, v);
  const Found c = search(strided);
  REQUIRE(a.candidates.size() >= 4);
  REQUIRE(b.candidates.size() == a.candidates.size());
  REQUIRE(c.candidates.size() == a.candidates.size());
  for (std::size_t i = 0; i < a.candidates.size(); ++i) {
    CHECK(b.candidates[i].fit.plane == a.candidates[i].fit.plane);
    CHECK(c.candidates[i].fit.plane == a.candidates[i].fit.plane);
    CHECK(c.candidates[i].readings == a.candidates[i].readings);
  }
}

TEST_CASE("Masked pixels take no part", "[ransac]") {
  Pcg32 random(5);
  const scene::Room room = scene::room_by_chance(random);
  const scene::Frame frame = scene::render(room, scene::sigma, 0, random);
  std::vector<std::uint16_t> mask;
  for (const int t : frame.truth) mask.push_back(t == 2 ? 1 : 0);
  // Plane 1 is a strip of 771 pixels.
  const RansacSearchOptions options{.min_pixels = 385};
  const Found found = search(frame.view(), options, {mask.data(), scene::size});
  CHECK(has_candidate(found, frame, 1, room.planes[0]));
  CHECK(has_candidate(found, frame, 3, room.planes[2]));
  CHECK_FALSE(has_candidate(found, frame, 2, room.planes[1]));
  scene::Frame changed = frame;
  for (std::size_t i = 0; i < mask.size(); ++i) changed.q[i] = mask[i] != 0 ? 0.7F : frame.q[i];
  const Found same = search(changed.view(), options, {mask.data(), scene::size});
  CHECK(same.result.readings == found.result.readings);
  REQUIRE(same.candidates.size() == found.candidates.size());
  for (std::size_t i = 0; i < found.candidates.size(); ++i)
    CHECK(same.candidates[i].fit.plane == found.candidates[i].fit.plane);
  CHECK(search(changed.view(), options).candidates[0].fit.plane != found.candidates[0].fit.plane);
}

TEST_CASE("A noisy frame gets a wider gate; a gate in metres stays", "[ransac]") {
  Pcg32 random(9);
  const scene::Room room = scene::room_by_chance(random);
  const scene::Frame frame = scene::render(room, 2 * scene::sigma, 0, random);
  const Found found = search(frame.view());
  CHECK(found.result.noise == Approx(2).epsilon(0.2));
  CHECK(found.candidates.size() >= 3);
  RansacSearchOptions metres;
  metres.gate.fixed_m = 0.03;
  const Found fixed = search(scene::render(room, 0, 0, random).view(), metres);
  CHECK(fixed.result.noise == 1);
  CHECK(fixed.candidates.size() >= 4);
}

TEST_CASE("A short output holds the strongest candidates", "[ransac]") {
  Pcg32 random(13);
  const scene::Frame frame = scene::render(scene::room_by_chance(random), scene::sigma, 0, random);
  const Found all = search(frame.view());
  const Found two = search(frame.view(), {}, {}, 2);
  CHECK(two.result.status == Status::output_full);
  REQUIRE(two.candidates.size() == 2);
  CHECK(two.candidates[1].fit.plane == all.candidates[1].fit.plane);
}
