// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "hough_testing.hpp"

using namespace straightedge;
using test::EdgeImage;

TEST_CASE("one call owns its memory and grows its output") {
  const EdgeImage image = test::noise({300, 300}, 0.3, 11);
  HoughOptions options;
  options.method = HoughMethod::standard;
  options.threshold = 30;
  const HoughFound found = hough_lines(image, options);
  CHECK(found.result.status == Status::ok);
  CHECK(found.peaks.size() > 4096);
  CHECK(found.peaks.size() == found.result.peaks);

  options.method = HoughMethod::progressive;
  options.threshold = 1;
  options.min_length = 0;
  options.max_gap = 0;
  const HoughFound pieces = hough_lines(image, options);
  CHECK(pieces.result.status == Status::ok);
  CHECK(pieces.segments.size() > 4096);
  CHECK(pieces.peaks.empty());
}

TEST_CASE("the progressive method reports votes, pixels and seed") {
  EdgeImage image({200, 100});
  test::draw(image, 10, 50, 190, 50);
  HoughOptions options;
  options.seed = 77;
  const HoughFound found = hough_lines(image, options);
  REQUIRE(found.segments.size() == 1);
  CHECK(found.segments[0].votes == options.threshold);  // it is taken as soon as it stands out
  CHECK(found.segments[0].pixels == 181);
  CHECK(found.result.seed == 77);
  CHECK(found.result.edge_pixels == 181);
  CHECK(found.result.draws == 181);
}

TEST_CASE("length is Euclidean, but not where OpenCV is followed") {
  EdgeImage image({100, 100});
  test::draw(image, 10, 10, 50, 50);  // 40 steps, 56.6 long
  HoughOptions options;
  options.threshold = 20;
  options.min_length = 50;
  CHECK(hough_lines(image, options).segments.size() == 1);
  options.generator = HoughGenerator::opencv;
  CHECK(hough_lines(image, options).segments.empty());
}
