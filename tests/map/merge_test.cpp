// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/merge.hpp"

#include "stage_lines.hpp"

using namespace straightedge;
using stage::axis;
using stage::face;

namespace {

const Picture blank = understand_picture(Image<std::uint8_t>({200, 100}, 255), PictureKind::map, {});

std::size_t count_after_merging(std::vector<WallLine> lines) {
  const std::size_t before = lines.size();
  const std::uint32_t vanished = merge_fragments(lines, blank, {});
  CHECK(before - vanished == lines.size());
  return lines.size();
}

}  // namespace

TEST_CASE("two pieces that overlap on one line become one with the pixels of both") {
  const WallLine a = face({10, 20}, {60, 20}), b = face({50, 20}, {90, 20});
  std::vector<WallLine> lines{a, b};
  CHECK(merge_fragments(lines, blank, {}) == 1);
  REQUIRE(lines.size() == 1);
  stage::check_ends(lines[0], {10, 20}, {90, 20}, 1e-6);
  CHECK(lines[0].pixels == a.pixels + b.pixels);
  CHECK(lines[0].votes == a.votes + b.votes);
  CHECK(lines[0].count == 2);
  CHECK(lines[0].moments.count == a.moments.count + b.moments.count);
  CHECK(lines[0].moments.weight == Approx(a.moments.weight + b.moments.weight));
}

TEST_CASE("what is not one line stays apart") {
  const WallLine a = face({10, 20}, {60, 20});
  CHECK(count_after_merging({a, face({10, 26}, {60, 26})}) == 2);   // beside
  CHECK(count_after_merging({a, face({60, 21}, {10, 21})}) == 2);   // light on the other side
  CHECK(count_after_merging({a, axis({10, 20}, {60, 20})}) == 2);   // of another kind
  CHECK(count_after_merging({a, face({80, 20}, {120, 20})}) == 2);  // a door between
  CHECK(count_after_merging({a, face({35, 0}, {35, 40})}) == 2);    // across
}

TEST_CASE("axes merge whichever way their normals point") {
  std::vector<WallLine> lines{axis({10, 20}, {60, 20}, 2), axis({90, 20}, {55, 20}, 3)};
  lines[0].free_plus = true;
  lines[1].free_minus = true;
  CHECK(merge_fragments(lines, blank, {}) == 1);
  REQUIRE(lines.size() == 1);
  CHECK(lines[0].free_plus);
  CHECK_FALSE(lines[0].free_minus);
  CHECK(lines[0].width > 2);
  CHECK(lines[0].width < 3);
  CHECK(lines[0].length() == Approx(80).margin(1e-6));
}

TEST_CASE("of two that overlap in a bent wall the shorter keeps what is left over") {
  const WallLine straight = face({10, 20}, {80, 20});
  const WallLine bent = face({70, 20.3}, {110, 26});
  std::vector<WallLine> lines{bent, straight};
  CHECK(merge_fragments(lines, blank, {}) == 0);
  REQUIRE(lines.size() == 2);
  stage::check_ends(lines[0], {10, 20}, {80, 20}, 1e-6);
  CHECK(stage::begin_of(lines[1]).x == Approx(80).margin(0.5));
  CHECK(stage::end_of(lines[1]).x == Approx(110).margin(1e-6));
}

TEST_CASE("a wall and its doors are one group with one fit, longest first") {
  std::vector<WallLine> lines{face({10, 20.05}, {40, 20}), face({60, 20}, {120, 20.04}),
                              face({30, 50}, {90, 50}), face({140, 20}, {165, 19.97})};
  const auto groups = group_collinear(lines, blank, {});
  REQUIRE(groups.size() == 2);
  std::size_t members = 0;
  for (const auto& group : groups) {
    members += group.size();
    for (std::size_t k = 0; k < group.size(); ++k) {
      const WallLine& first = lines[group.front()];
      const WallLine& line = lines[group[k]];
      CHECK(line.nx == Approx(first.nx).margin(1e-12));
      CHECK(line.ny == Approx(first.ny).margin(1e-12));
      CHECK(first.across(stage::begin_of(line).x, stage::begin_of(line).y) == Approx(0).margin(1e-6));
      if (k > 0) CHECK(lines[group[k - 1]].length() >= line.length() - 1e-9);
    }
  }
  CHECK(members == 4);
  CHECK(std::max(groups[0].size(), groups[1].size()) == 3);
}

TEST_CASE("parallel walls two pixels apart are two groups") {
  std::vector<WallLine> lines{face({10, 20}, {60, 20}), face({80, 22}, {130, 22})};
  CHECK(group_collinear(lines, blank, {}).size() == 2);
}

TEST_CASE("nothing merges into nothing") {
  std::vector<WallLine> none;
  CHECK(merge_fragments(none, blank, {}) == 0);
  CHECK(group_collinear(none, blank, {}).empty());
}
