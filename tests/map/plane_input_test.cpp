// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <limits>

#include "plane_scene.hpp"
#include "straightedge/host/plane_leaves_file.hpp"

using namespace straightedge;
using scene::Frame;

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double endless = std::numeric_limits<double>::infinity();

const Frame& good_frame() {
  static const Frame frame = scene::tour(scene::room(), 3, 11)[0];
  return frame;
}

Problem problem_of(const Frame& frame, const PlaneMapOptions& options = scene::options()) {
  PlaneMapBuilder builder(options);
  const auto result = builder.add(frame.view(), frame.labels.view(), frame.planes, frame.pose);
  REQUIRE_FALSE(result);
  CHECK_FALSE(result.failure().sentence.empty());
  CHECK(builder.leaves().size() == 0);
  return result.failure().problem;
}

}  // namespace

TEST_CASE("poses that are not finite or no rotation are refused") {
  Frame frame = good_frame();
  const int fault = GENERATE(range(0, 7));
  CAPTURE(fault);
  if (fault == 0) frame.pose.translation.x = no_number;
  if (fault == 1) frame.pose.translation.z = endless;
  if (fault == 2) frame.pose.rotation[4] = no_number;
  if (fault == 3) frame.pose.rotation = {1, 0, 0, 0, 1, 0, 0, 0, -1};  // a mirror
  if (fault == 4) frame.pose.rotation = {2, 0, 0, 0, 2, 0, 0, 0, 2};
  if (fault == 5) frame.pose.rotation = {1, 0.1, 0, 0, 1, 0, 0, 0, 1};
  if (fault == 6) frame.pose.translation.y = 1e6;
  CHECK(problem_of(frame) == Problem::bad_content);
}

TEST_CASE("planes that are none, and labels without plane, are refused") {
  Frame frame = good_frame();
  const int fault = GENERATE(range(0, 5));
  CAPTURE(fault);
  Plane& plane = frame.planes[0].fit.plane;
  if (fault == 0) plane.normal = {0, 0, 0};
  if (fault == 1) plane.normal.x = no_number;
  if (fault == 2) plane.distance = -1;
  if (fault == 3) plane.distance = no_number;
  if (fault == 4) frame.labels.view().at(3, 3) = 999;
  CHECK(problem_of(frame) == Problem::bad_content);
}

TEST_CASE("views without pixels, without camera or of unequal size are refused") {
  const Frame& frame = good_frame();
  PlaneMapBuilder builder(scene::options());
  DepthView depth = frame.view();
  depth.camera.fx = 0;
  CHECK_FALSE(builder.add(depth, frame.labels.view(), frame.planes, frame.pose));
  depth.camera.fx = no_number;
  CHECK_FALSE(builder.add(depth, frame.labels.view(), frame.planes, frame.pose));
  CHECK_FALSE(builder.add(DepthView{}, frame.labels.view(), frame.planes, frame.pose));
  const Image<std::uint16_t> small(Size{3, 3});
  CHECK_FALSE(builder.add(frame.view(), small.view(), frame.planes, frame.pose));
  CHECK_FALSE(builder.add(PointsView{}, {}, frame.planes, frame.pose));
  CHECK(builder.leaves().size() == 0);
}

TEST_CASE("options out of range are refused") {
  PlaneMapOptions options;
  const int fault = GENERATE(range(0, 6));
  CAPTURE(fault);
  if (fault == 0) options.gate.inverse_sigma = 0;
  if (fault == 1) options.shared_noise = no_number;
  if (fault == 2) options.max_angle = -1;
  if (fault == 3) options.chi_square = 0;
  if (fault == 4) options.max_gap = 11;
  if (fault == 5) options.floor.offset_m = no_number;
  CHECK(problem_of(good_frame(), options) == Problem::bad_option);
  CHECK(PlaneMapBuilder(options).build().failure().problem == Problem::bad_option);
}

TEST_CASE("nothing in, nothing out") {
  CHECK(scene::read(PlaneMapBuilder()).map.planes.empty());
  Frame frame = good_frame();
  for (std::int32_t v = 0; v < scene::frame_size.height; ++v)
    for (std::int32_t u = 0; u < scene::frame_size.width; ++u) frame.labels.view().at(u, v) = 0;
  PlaneMapBuilder builder;
  const RegisteredFrame empty = scene::add(builder, frame);
  CHECK(empty.placed == 0);
  CHECK(builder.leaves().frames == 1);
  CHECK(scene::read(builder).map.planes.empty());
  frame.planes.clear();
  scene::add(builder, frame);
  CHECK(builder.leaves().size() == 0);
}

TEST_CASE("readings nowhere near their plane, without reading or out of range are left out and counted") {
  Frame frame = good_frame();
  std::uint64_t labelled = 0;
  for (std::int32_t v = 0; v < scene::frame_size.height; ++v)
    for (std::int32_t u = 0; u < scene::frame_size.width; ++u)
      labelled += frame.labels.view().at(u, v) != 0 ? 1 : 0;
  std::int32_t u = 0;
  while (frame.labels.view().at(u, 60) == 0 || frame.labels.view().at(u + 1, 60) == 0) ++u;
  frame.depth.view().at(u, 60) = 60000;
  frame.depth.view().at(u + 1, 60) = 0;
  PlaneMapBuilder builder(scene::options());
  const RegisteredFrame here = scene::add(builder, frame);
  CHECK(here.off_plane == 1);
  CHECK(here.placed == labelled - 2);
  frame.pose.translation.x = plane_grid::reach_m - 0.5;  // some of the room lies beyond the grid
  const RegisteredFrame edge = scene::add(builder, frame);
  CHECK(edge.out_of_range > 0);
  CHECK(edge.placed + edge.out_of_range == labelled - 2);
  CHECK(scene::read(builder).report.readings == here.placed + edge.placed);
}

TEST_CASE("a leaf that would overflow refuses further frames and merging") {
  PlaneLeaves leaves;
  PlaneLeafSums& sums = leaves.at(leaves.place({12345, 6}));
  sums.readings = plane_grid::most_readings;
  sums.weight = static_cast<std::int64_t>(plane_grid::most_readings);
  sums.nx = sums.weight << 14;
  leaves.note_fullest(sums.readings);
  PlaneMapBuilder builder(scene::options());
  REQUIRE(builder.merge(leaves));
  const Frame& frame = good_frame();
  const auto added = builder.add(frame.view(), frame.labels.view(), frame.planes, frame.pose);
  REQUIRE_FALSE(added);
  CHECK(added.failure().problem == Problem::bad_content);
  CHECK_FALSE(builder.merge(leaves));
  CHECK(builder.leaves().size() == 1);
}

TEST_CASE("cameras with negative focal lengths see the same world") {
  // Columns and rows turned round, and the sign of both focal lengths with them.
  const Frame& frame = good_frame();
  Frame turned = frame;
  turned.camera = {-frame.camera.fx, -frame.camera.fy, 159 - frame.camera.cx, 119 - frame.camera.cy};
  for (std::int32_t v = 0; v < 120; ++v) {
    for (std::int32_t u = 0; u < 160; ++u) {
      turned.depth.view().at(u, v) = frame.depth.view().at(159 - u, 119 - v);
      turned.labels.view().at(u, v) = frame.labels.view().at(159 - u, 119 - v);
    }
  }
  PlaneMapBuilder a(scene::options()), b(scene::options());
  scene::add(a, frame);
  scene::add(b, turned);
  const PlaneMap one = scene::read(a).map, other = scene::read(b).map;
  REQUIRE(one.planes.size() == other.planes.size());
  for (std::size_t i = 0; i < one.planes.size(); ++i)
    CHECK(scene::angle_to(other.planes[i], one.planes[i].plane.normal) < 1e-3);
}
