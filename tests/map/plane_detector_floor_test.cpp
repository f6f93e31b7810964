// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <filesystem>
#include <string>

#include "detector_testing.hpp"
#include "straightedge/host/camera_file.hpp"
#include "straightedge/host/depth_file.hpp"

using namespace detector;

namespace {

struct Floor {
  double correct, precision, purity, coverage;
};

support::SegmentationScore score_of(const PlaneDetectorOptions& options) {
  const std::filesystem::path folder = std::filesystem::path(STRAIGHTEDGE_FIXTURES) / "depth" / "room";
  const auto camera = read_camera(folder / "camera.json");
  REQUIRE(camera);
  auto detector = PlaneDetector::create({640, 480}, options);
  REQUIRE(detector);
  support::SegmentationScore score;
  for (int i = 0; i < 12; ++i) {
    const std::string name = std::to_string(100 + i).substr(1) + ".png";
    const auto raw = read_depth_image(folder / "depth" / name),
               truth = read_depth_image(folder / "labels" / name);
    REQUIRE(raw);
    REQUIRE(truth);
    const auto result = detector->detect({*raw, camera->metres_per_unit(), camera->pinhole});
    REQUIRE(result);
    score.add(result->labels, *raw, *truth);
  }
  return score;
}

void check_floor(PlaneMethod method, const Floor& floor) {
  const support::SegmentationScore score = score_of(by(method));
  INFO(name_of(method) << ": " << score.correct << " of " << score.surfaces << " surfaces correct, "
                       << score.found << " found; precision " << score.precision() << ", purity "
                       << score.purity() << ", coverage " << score.coverage());
  CHECK(score.surfaces > 100);
  CHECK(score.correct_share() >= floor.correct);
  CHECK(score.precision() >= floor.precision);
  CHECK(score.purity() >= floor.purity);
  CHECK(score.coverage() >= floor.coverage);
}

}  // namespace

TEST_CASE("the planes of the furnished room do not get worse, by RANSAC") {
  check_floor(PlaneMethod::ransac, {0.74, 0.86, 0.96, 0.985});
}

TEST_CASE("the planes of the furnished room do not get worse, by Hough") {
  check_floor(PlaneMethod::hough, {0.78, 0.85, 0.965, 0.985});
}
