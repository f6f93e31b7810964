// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "../support/golden_hough.hpp"
#include "hough_testing.hpp"

using namespace straightedge;

namespace {

const test::GoldenHough& golden() {
  static const test::GoldenHough content =
      test::read_golden_hough(STRAIGHTEDGE_FIXTURES "/golden/hough/hough.golden");
  return content;
}

bool same_ends(const std::vector<HoughSegment>& a, const std::vector<HoughSegment>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i].x0 != b[i].x0 || a[i].y0 != b[i].y0 || a[i].x1 != b[i].x1 || a[i].y1 != b[i].y1) return false;
  return true;
}

}  // namespace

TEST_CASE("the golden file is whole") {
  REQUIRE(golden().good);
  CHECK(golden().images.size() >= 100);
  std::size_t lines = 0;
  for (const auto& one : golden().cases) lines += one.peaks.size() + one.segments.size();
  CHECK(lines > 10'000);
}

TEST_CASE("the standard transform gives OpenCV's lines, votes and order") {
  for (const auto& expected : golden().cases) {
    if (expected.options.method != HoughMethod::standard) continue;
    const auto& image = golden().images.at(expected.image);
    const HoughFound found = hough_lines(image.edges, expected.options);
    INFO(image.name << " rho " << expected.options.rho_step << " theta " << expected.options.theta_step
                    << " from " << expected.options.min_theta << " to " << expected.options.max_theta
                    << " threshold " << expected.options.threshold);
    REQUIRE(found.result.status == Status::ok);
    REQUIRE(found.peaks.size() == expected.peaks.size());
    REQUIRE(found.peaks == expected.peaks);
  }
}

TEST_CASE("the progressive transform gives OpenCV's segments in OpenCV's order") {
  for (const auto& expected : golden().cases) {
    if (expected.options.method != HoughMethod::progressive) continue;
    const auto& image = golden().images.at(expected.image);
    const HoughFound found = hough_lines(image.edges, expected.options);
    INFO(image.name << " rho " << expected.options.rho_step << " theta " << expected.options.theta_step
                    << " threshold " << expected.options.threshold << " length "
                    << expected.options.min_length << " gap " << expected.options.max_gap);
    REQUIRE(found.result.status == Status::ok);
    REQUIRE(found.segments.size() == expected.segments.size());
    REQUIRE(same_ends(found.segments, expected.segments));
  }
}
