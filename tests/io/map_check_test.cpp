// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <functional>
#include <limits>

#include "catch.hpp"
#include "random_line_map.hpp"
#include "straightedge/host/map_file.hpp"

using namespace straightedge;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The one breach that the change causes.
MapBreach breach_of(const std::function<void(LineMap&)>& change) {
  LineMap map = small_line_map();
  change(map);
  const auto breaches = check_line_map(map);
  REQUIRE(breaches.size() == 1);
  const auto xml = line_map_to_xml(map);
  REQUIRE_FALSE(xml);
  CHECK(xml.failure().problem == Problem::bad_option);
  CHECK(xml.failure().sentence == "the map breaks a rule of its format: " + breaches[0].sentence);
  return breaches[0];
}

}  // namespace

TEST_CASE("a good map breaks no rule") {
  CHECK(check_line_map(LineMap{}).empty());
  CHECK(check_line_map(small_line_map()).empty());
}

TEST_CASE("random good maps break no rule") {
  const std::uint32_t seed = 20;
  RandomLineMaps maps(seed);
  for (int i = 0; i < 300; ++i) {
    const auto breaches = check_line_map(maps.next());
    INFO("seed " << seed << ", map " << i << ": " << (breaches.empty() ? "" : breaches[0].sentence));
    REQUIRE(breaches.empty());
  }
}

TEST_CASE("each rule of the image") {
  const auto sentence = [](const std::function<void(MapImage&)>& change) {
    return breach_of([&](LineMap& map) { change(*map.image); }).sentence;
  };
  CHECK(sentence([](MapImage& i) { i.size.width = 0; }) == "image: width and height are not above zero");
  CHECK(sentence([](MapImage& i) { i.placement->resolution = 0; }) ==
        "image: the resolution is not above zero");
  CHECK(sentence([](MapImage& i) { i.placement->resolution = -1; }) ==
        "image: the resolution is not above zero");
  CHECK(sentence([](MapImage& i) { i.placement->resolution = not_a_number; }) ==
        "image: resolution or origin is not a finite number");
  CHECK(sentence([](MapImage& i) { i.placement->origin_y = infinity; }) ==
        "image: resolution or origin is not a finite number");
  CHECK(sentence([](MapImage& i) { i.placement->origin_yaw = 1e6; }) ==
        "image: the origin's yaw is outside of ±1000 radians");
  CHECK(sentence([](MapImage& i) { i.meaning->occupied_thresh = 1.5; }) ==
        "image: a threshold is outside of 0 to 1");
  CHECK(sentence([](MapImage& i) { i.meaning->free_thresh = 0.7; }) ==
        "image: free-thresh is above occupied-thresh");
}

TEST_CASE("each rule of a line") {
  const auto sentence = [](const std::function<void(MapLine&)>& change) {
    const MapBreach breach = breach_of([&](LineMap& map) { change(map.lines[0]); });
    CHECK(breach.line == 0u);
    CHECK_FALSE(breach.segment);
    return breach.sentence;
  };
  CHECK(sentence([](MapLine& l) { l.rho = not_a_number; }) == "line 3: rho or theta is not a finite number");
  CHECK(sentence([](MapLine& l) { l.theta = -infinity; }) == "line 3: rho or theta is not a finite number");
  CHECK(sentence([](MapLine& l) { l.rho = -1.5; }) == "line 3: rho is negative (-1.5)");
  CHECK(sentence([](MapLine& l) { l.theta = 3.5; }) == "line 3: theta is outside of its range (3.5)");
  CHECK(sentence([](MapLine& l) { l.theta = -pi; }).starts_with("line 3: theta is outside of its range"));
  CHECK(sentence([](MapLine& l) { l.rho = 0, l.theta = 2; }) == "line 3: theta is outside of its range (2)");
  CHECK(sentence([](MapLine& l) { l.width = -1; }) == "line 3: the width is negative or not a finite number");
  CHECK(sentence([](MapLine& l) { l.width = not_a_number; }) ==
        "line 3: the width is negative or not a finite number");
  CHECK(sentence([](MapLine& l) { l.covariance->var_theta = -1e-300; }) ==
        "line 3: the covariance is not positive semi-definite: a variance is negative");
  CHECK(sentence([](MapLine& l) { l.covariance->var_offset = -1; }) ==
        "line 3: the covariance is not positive semi-definite: a variance is negative");
  CHECK(sentence([](MapLine& l) { l.covariance->at_x = not_a_number; }) ==
        "line 3: the covariance has something that is not a finite number");
}

TEST_CASE("each rule of a segment") {
  const auto sentence = [](const std::function<void(MapSegment&)>& change) {
    const MapBreach breach = breach_of([&](LineMap& map) { change(map.lines[0].segments[1]); });
    CHECK(breach.line == 0u);
    CHECK(breach.segment == 1u);
    return breach.sentence;
  };
  CHECK(sentence([](MapSegment& s) { s.y1 = not_a_number; }) == "line 3, segment 11: an end is not finite");
  CHECK(sentence([](MapSegment& s) { s.x1 = s.x0; }) == "line 3, segment 11: its length is zero");
  CHECK(sentence([](MapSegment& s) { s.y0 += 0.5; }) == "line 3, segment 11: an end lies 0.5 off its line");
  CHECK(sentence([](MapSegment& s) { swap_ends(s); }) ==
        "line 3, segment 11: the ends are in the wrong order along (-sin theta, cos theta)");
}

TEST_CASE("the distance of an end from its line is judged by the size") {
  const auto off_by = [](double distance) {
    LineMap map = small_line_map();
    map.lines[0].segments[0].y0 += distance;
    return check_line_map(map).size();
  };
  CHECK(off_by(0.9e-6 * 640) == 0);
  CHECK(off_by(1.1e-6 * 640) == 1);
}

TEST_CASE("ids are unique: lines among lines, segments in the whole map") {
  MapBreach breach = breach_of([](LineMap& map) { map.lines[1].id = 3; });
  CHECK(breach.sentence == "line 3: another line has the same id");
  CHECK(breach.line == 1u);
  breach = breach_of([](LineMap& map) { map.lines[1].segments[0].id = 11; });
  CHECK(breach.sentence == "line 5, segment 11: another segment has the same id");
  // A line and a segment may share a number.
  LineMap map = small_line_map();
  map.lines[1].segments[0].id = 3;
  CHECK(check_line_map(map).empty());
}

TEST_CASE("every breach is told, not the first one alone") {
  LineMap map = small_line_map();
  map.image->placement->resolution = -1;
  map.lines[0].rho = -1;
  map.lines[1].segments[0].x0 = not_a_number;
  CHECK(check_line_map(map).size() == 3);
}
