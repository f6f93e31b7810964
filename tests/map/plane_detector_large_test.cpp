// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>

#include "detector_testing.hpp"
#include "straightedge/host/camera_file.hpp"
#include "straightedge/host/depth_file.hpp"

using namespace detector;

namespace {

constexpr Size size{640, 480};
constexpr double all_pixels = 640 * 480;

std::filesystem::path fixtures() {
  return std::filesystem::path(STRAIGHTEDGE_FIXTURES) / "depth";
}

/// Pixels of a plane with each label of another picture.
std::map<std::uint16_t, int> labels_under(const DetectedPlanes& planes, std::size_t k,
                                          const Image<std::uint16_t>& other) {
  std::map<std::uint16_t, int> count;
  for (std::int32_t y = 0; y < size.height; ++y) {
    for (std::int32_t x = 0; x < size.width; ++x) {
      if (planes.labels.at(x, y) == k + 1) ++count[other.at(x, y)];
    }
  }
  return count;
}

std::uint16_t most_frequent(const std::map<std::uint16_t, int>& count) {
  const auto fewer = [](const auto& a, const auto& b) { return a.second < b.second; };
  return std::max_element(count.begin(), count.end(), fewer)->first;
}

/// Most of its pixels have one label there, of a plane that is near.
bool is_among(const DetectedPlanes& all, std::size_t k, const DetectedPlanes& large) {
  const PlaneFit& fit = all.planes[k].fit;
  const auto under = labels_under(all, k, large.labels);
  const std::uint16_t label = most_frequent(under);
  if (label == 0 || 2 * under.at(label) < static_cast<int>(all.planes[k].inliers)) return false;
  const Plane& other = large.planes[label - 1U].fit.plane;
  return dot(other.normal, fit.plane.normal) > std::cos(4 * pi / 180) &&
         std::abs(other.signed_distance(fit.centroid)) < 0.03;
}

/// The planes with 6 % of the pixels and more (10 % without a truth) must be among those that the options for
/// 5 % find. Without a truth all planes are taken to be there. Returns how many there are.
int compare(const DepthView& depth, PlaneMethod method, const Image<std::uint16_t>* truth) {
  auto all = detect_planes(depth, by(method));
  auto large = detect_planes(depth, for_large_planes(by(method), size));
  REQUIRE(all);
  REQUIRE(large);
  // The books of a shelf make one plane or another.
  const double least = truth != nullptr ? 0.06 : 0.1;
  int asked = 0;
  for (const FoundPlane& plane : large->planes) CHECK(plane.inliers >= 0.05 * all_pixels);
  for (std::size_t k = 0; k < all->planes.size(); ++k) {
    if (all->planes[k].inliers < least * all_pixels) continue;
    // A strip of a pillar is no loss.
    if (truth != nullptr && most_frequent(labels_under(*all, k, *truth)) == 0) continue;
    INFO(name_of(method) << ", plane " << k + 1 << " of " << all->planes[k].inliers << " pixels");
    CHECK(is_among(*all, k, *large));
    ++asked;
  }
  return asked;
}

}  // namespace

TEST_CASE("large planes alone: those of the furnished room that are found among all planes") {
  const auto camera = read_camera(fixtures() / "room" / "camera.json");
  REQUIRE(camera);
  for (const PlaneMethod method : both_methods) {
    int asked = 0;
    for (int i = 0; i < 12; ++i) {
      const std::string name = std::to_string(100 + i).substr(1) + ".png";
      INFO(name);
      const auto raw = read_depth_image(fixtures() / "room" / "depth" / name),
                 truth = read_depth_image(fixtures() / "room" / "labels" / name);
      REQUIRE(raw);
      REQUIRE(truth);
      asked += compare({*raw, camera->metres_per_unit(), camera->pinhole}, method, &*truth);
    }
    CHECK(asked >= 40);
  }
}

TEST_CASE("large planes alone: the wall of a real frame") {
  const auto camera = read_camera(fixtures() / "mrpt_office" / "camera.json");
  const auto raw = read_depth_image(fixtures() / "mrpt_office" / "depth.png");
  REQUIRE(camera);
  REQUIRE(raw);
  for (const PlaneMethod method : both_methods) {
    CHECK(compare({*raw, camera->metres_per_unit(), camera->pinhole}, method, nullptr) >= 1);
  }
}

TEST_CASE("large planes alone: how coarse the search is follows from the pixels of the smallest plane") {
  PlaneDetectorOptions options = by(PlaneMethod::hough);
  options.frame.max_planes = 7;
  options.ransac.seed = 99;
  const PlaneDetectorOptions large = for_large_planes(options, size, 0.05);
  CHECK(large.method == PlaneMethod::hough);
  CHECK(large.frame.max_planes == 7);
  CHECK(large.ransac.seed == 99);
  CHECK(large.frame.min_pixels == 15360);
  CHECK(large.frame.cell == 8);
  CHECK(large.ransac.cell == 8);
  CHECK(large.ransac.min_pixels == 3840);
  CHECK(large.hough.min_pixels == 3840);
  CHECK(large.hough.smallest_patch == 16);
  const PlaneDetectorOptions small = for_large_planes(options, {160, 120}, 0.05);
  CHECK(small.frame.cell == 4);
  CHECK(small.ransac.cell == 4);
  CHECK(small.hough.smallest_patch == 8);
  for (const double share : {0.0, -1.0, 1e-9, 0.02, 1.0, 1e300, std::nan("")}) {
    for (const Size picture : {Size{1, 1}, Size{64, 48}, size}) {
      CHECK(PlaneDetector::create(picture, for_large_planes(options, picture, share)));
    }
  }
}

TEST_CASE("a result that is used again holds the new frame alone") {
  const Size small{320, 240};
  const DepthScene room = support::box_room(small, support::box_planes());
  SensorNoise with_holes;
  with_holes.holes = 0.3;
  const DepthFrame walls = support::frame_of(room, {}, 4), holes = support::frame_of(room, with_holes, 5);
  DepthFrame nothing = walls;
  for (std::int32_t y = 0; y < small.height; ++y) {
    std::fill_n(nothing.raw.view().row(y), small.width, std::uint16_t{0});
  }
  for (const PlaneMethod method : both_methods) {
    auto detector = PlaneDetector::create(small, by(method));
    REQUIRE(detector);
    DetectedPlanes again;
    again.labels = Image<std::uint16_t>({3, 3}, std::uint16_t{9});
    const DepthFrame& blank = nothing;
    for (const DepthFrame* frame : {&walls, &holes, &blank, &walls}) {
      REQUIRE(detector->detect(frame->view(), again));
      const DetectedPlanes fresh = detect(*frame, by(method));
      CHECK(again.labels == fresh.labels);
      REQUIRE(again.planes.size() == fresh.planes.size());
      for (std::size_t k = 0; k < fresh.planes.size(); ++k) {
        CHECK(again.planes[k].inliers == fresh.planes[k].inliers);
        CHECK(again.planes[k].fit.plane == fresh.planes[k].fit.plane);
      }
      CHECK(again.found.labelled == fresh.found.labelled);
      CHECK(again.found.seed == fresh.found.seed);
    }
  }
}

TEST_CASE("large planes alone: faces that stray by three deviations of the noise have their labels") {
  // The front of a shelf: books that stand out by up to 14 mm at 1.3 m, where sigma is 2.4 mm.
  Image<std::uint16_t> raw(size);
  Pcg32 random(5);
  std::uint16_t book = 1300;
  for (std::int32_t x = 0; x < size.width; ++x) {
    if (x % 12 == 0) book = static_cast<std::uint16_t>(1293 + random.below(15));
    for (std::int32_t y = 0; y < size.height; ++y) raw.at(x, y) = book;
  }
  DepthView depth;
  depth.raw = raw;
  for (const PlaneMethod method : both_methods) {
    const auto large = detect_planes(depth, for_large_planes(by(method), size));
    REQUIRE(large);
    INFO(name_of(method));
    CHECK(large->found.labelled > 0.97 * all_pixels);
    CHECK(large->planes.size() == 1);
  }
}

TEST_CASE("large planes alone: slack that is asked for stays") {
  PlaneDetectorOptions options;
  CHECK(for_large_planes(options, size).frame.slack == 2);
  options.frame.slack = 3;
  CHECK(for_large_planes(options, size).frame.slack == 3);
}
