// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "plane_scene.hpp"

using namespace straightedge;
using scene::Frame;
using scene::Rectangle;

namespace {

PlaneMapReading mapped(const std::vector<Frame>& frames, const PlaneMapOptions& options = scene::options()) {
  PlaneMapBuilder builder(options);
  for (const Frame& frame : frames) scene::add(builder, frame);
  return scene::read(builder);
}

/// The map's plane nearest to n·x = d.
const MapPlane& plane_at(const PlaneMap& map, const Vector3& n, double d) {
  const MapPlane* best = nullptr;
  double least = 1e9;
  for (const MapPlane& plane : map.planes) {
    const double side = dot(plane.plane.normal, n) < 0 ? -1 : 1;
    const double off = scene::angle_to(plane, n) + std::abs(side * plane.plane.distance - d);
    if (off < least) best = &plane;
    least = std::min(least, off);
  }
  REQUIRE(best != nullptr);
  return *best;
}

const std::vector<Rectangle> wall{{{-2, 2, 0}, {4, 0, 0}, {0, 0, 2.5}, {}, 1}};

}  // namespace

TEST_CASE("a room seen all round is its eight planes, each once and exact") {
  const PlaneMapReading reading = mapped(scene::tour(scene::room(), 16, 7));
  CHECK(reading.map.planes.size() == 8);
  CHECK(reading.report.frames == 16);
  const std::vector<std::pair<Vector3, double>> truth{{{0, 0, 1}, 0},   {{0, 0, 1}, 2.4}, {{0, 1, 0}, 0},
                                                      {{0, 1, 0}, 3},   {{1, 0, 0}, 0},   {{1, 0, 0}, 4},
                                                      {{0, 1, 0}, 2.2}, {{0, 0, 1}, 0.8}};
  for (const auto& [n, d] : truth) {
    CAPTURE(n.x, n.y, n.z, d);
    const MapPlane& plane = plane_at(reading.map, n, d);
    CHECK(scene::angle_to(plane, n) < 0.5 * degree);
    const double side = dot(plane.plane.normal, n) < 0 ? -1 : 1;
    CHECK(std::abs(side * dot(n, plane.moments->mean) - side * d) < 0.005);
  }
}

TEST_CASE("planes come largest first, ids count from one, numbers add up") {
  const PlaneMapReading reading = mapped(scene::tour(scene::room(), 8, 1));
  std::uint64_t points = 0;
  for (std::size_t i = 0; i < reading.map.planes.size(); ++i) {
    const MapPlane& plane = reading.map.planes[i];
    CHECK(plane.id == i + 1);
    if (i > 0) CHECK(*plane.points <= *reading.map.planes[i - 1].points);
    points += *plane.points;
    CHECK(plane.covariance.has_value());
    CHECK(plane.moments->weight > 0);
  }
  CHECK(points <= reading.report.readings);
  CHECK(points > reading.report.readings * 9 / 10);
}

TEST_CASE("fifty frames of one wall are one plane, seen fifty times") {
  std::vector<Frame> frames;
  for (int i = 0; i < 50; ++i) {
    const Pose pose = scene::look({-1 + 0.04 * i, -1, 1.2}, {0.02 * i - 0.5, 2, 1.2});
    frames.push_back(scene::seen(wall, pose, 100 + static_cast<std::uint64_t>(i)));
  }
  const PlaneMapReading reading = mapped(frames);
  REQUIRE(reading.map.planes.size() == 1);
  CHECK(reading.map.planes[0].count == 50U);
  CHECK(scene::angle_to(reading.map.planes[0], {0, 1, 0}) < 0.1 * degree);
  CHECK(std::abs(reading.map.planes[0].plane.distance - 2) < 0.003);
}

TEST_CASE("millions of readings do not split a wall whose frames differ by the floor") {
  // Four places, each seen with its own small error of the pose, again and again.
  PlaneMapBuilder builder(scene::options());
  for (int i = 0; i < 4; ++i) {
    Frame frame = scene::seen(wall, scene::look({-1 + 0.6 * i, -1, 1.2}, {-1 + 0.6 * i, 2, 1.2}), 9);
    frame.pose.translation.y += 0.004 * (i - 1.5);
    for (int n = 0; n < 60; ++n) scene::add(builder, frame);
  }
  const PlaneMapReading reading = scene::read(builder);
  CHECK(reading.report.readings > 3'000'000);
  CHECK(reading.map.planes.size() == 1);
}

TEST_CASE("planes ten centimetres apart stay two, and so does a step of five") {
  const double step = GENERATE(0.10, 0.05);
  const std::vector<Rectangle> walls{{{-2, 2, 0}, {2, 0, 0}, {0, 0, 2.5}, {}, 1},
                                     {{0, 2 - step, 0}, {2, 0, 0}, {0, 0, 2.5}, {}, 2}};
  std::vector<Frame> frames;
  for (int i = 0; i < 10; ++i) {
    const Pose pose = scene::look({-1 + 0.2 * i, 0, 1.2}, {-1 + 0.2 * i, 2, 1.2});
    frames.push_back(scene::seen(walls, pose, 5 + static_cast<std::uint64_t>(i)));
  }
  const PlaneMapReading reading = mapped(frames);
  CAPTURE(step);
  REQUIRE(reading.map.planes.size() == 2);
  CHECK(std::abs(plane_at(reading.map, {0, 1, 0}, 2).plane.distance - 2) < 0.005);
  CHECK(std::abs(plane_at(reading.map, {0, 1, 0}, 2 - step).plane.distance - (2 - step)) < 0.005);
}

TEST_CASE(
    "a wall that a wrong pose shows behind itself is one plane; what can be seen beside it is another") {
  Frame right = scene::seen(wall, scene::look({0, 0, 1.2}, {0, 2, 1.2}), 12);
  Frame wrong = right;
  wrong.pose.translation.y += 0.05;
  CHECK(mapped({right, wrong}).map.planes.size() == 1);
  wrong.pose.translation.x += 3;
  CHECK(mapped({right, wrong}).map.planes.size() == 2);
}

TEST_CASE("readings that scatter too much are a plane only when two frames say so, or when they are many") {
  const Pose pose = scene::look({0, 0, 1.2}, {0, 2, 1.2});
  const Frame rough = scene::seen(wall, pose, 13, 2.2), smooth = scene::seen(wall, pose, 13);
  CHECK(mapped({smooth}).map.planes.size() == 1);
  PlaneMapOptions options = scene::options();
  const std::uint64_t readings = mapped({rough}).report.readings;
  options.sure_points = readings + 1;
  CHECK(mapped({rough}, options).map.planes.empty());
  CHECK(mapped({rough}, options).report.too_rough == 1);
  CHECK(mapped({rough, scene::seen(wall, pose, 14, 2.2)}, options).map.planes.size() == 1);
  options.sure_points = readings;
  CHECK(mapped({rough}, options).map.planes.size() == 1);
}

TEST_CASE("two pieces of one infinite plane are one plane with two borders") {
  const std::vector<Rectangle> pieces{{{-2.5, 2, 0}, {1.5, 0, 0}, {0, 0, 2}, {}, 1},
                                      {{1, 2, 0}, {1.5, 0, 0}, {0, 0, 2}, {}, 2}};
  const PlaneMapReading reading =
      mapped({scene::seen(pieces, scene::look({-1.75, -0.5, 1}, {-1.75, 2, 1}), 1),
              scene::seen(pieces, scene::look({1.75, -0.5, 1}, {1.75, 2, 1}), 2)});
  REQUIRE(reading.map.planes.size() == 1);
  CHECK(reading.map.planes[0].polygons.size() == 2);
}

TEST_CASE("the side from which a plane was seen is kept") {
  const auto side_of = [](std::initializer_list<double> ys) {
    std::vector<Frame> frames;
    for (const double y : ys) frames.push_back(scene::seen(wall, scene::look({0, y, 1.2}, {0, 2, 1.2}), 3));
    const PlaneMapReading reading = mapped(frames);
    REQUIRE(reading.map.planes.size() == 1);
    CHECK(reading.map.planes[0].plane.normal.y > 0.9);
    return reading.map.planes[0].seen;
  };
  CHECK(side_of({0}) == SeenSide::minus);
  CHECK(side_of({4}) == SeenSide::plus);
  CHECK(side_of({0, 4}) == SeenSide::both);
}

TEST_CASE("a map a kilometre away is the same map there") {
  const Vector3 shift{1000, -800, 50};
  const PlaneMap near = mapped(scene::tour(scene::room(), 12, 4)).map;
  const PlaneMap far = mapped(scene::tour(scene::room(), 12, 4, shift)).map;
  for (const MapPlane& plane : far.planes) {
    for (const MapPolygon& polygon : plane.polygons) {
      for (const Vector3& v : polygon.points) CHECK(std::abs(plane.plane.signed_distance(v)) < 1e-9);
    }
  }
  REQUIRE(far.planes.size() == near.planes.size());
  for (std::size_t i = 0; i < near.planes.size(); ++i) {
    const MapPlane& p = near.planes[i];
    CHECK(scene::angle_to(far.planes[i], p.plane.normal) < 1e-3);
    CHECK(length(far.planes[i].moments->mean - shift - p.moments->mean) < 2e-3);
  }
}

TEST_CASE("crumbs are dropped, and their frames' labels get id 0") {
  const std::vector<Rectangle> scene{wall[0], {{0, 1, 1}, {0.06, 0, 0}, {0, 0, 0.3}, {}, 2}};
  PlaneMapBuilder builder(scene::options());
  const RegisteredFrame frame =
      scene::add(builder, scene::seen(scene, scene::look({0, -1, 1.2}, {0, 2, 1.2}), 3));
  REQUIRE(frame.planes.size() == 2);
  const PlaneMapReading reading = scene::read(builder);
  REQUIRE(reading.map.planes.size() == 1);
  CHECK(reading.report.too_few + reading.report.too_vague == 1);
  CHECK(reading.plane_id(frame.planes[0]) == 1);
  CHECK(reading.plane_id(frame.planes[1]) == 0);
  CHECK(reading.plane_id(PlaneAnchors{}) == 0);
}

TEST_CASE("a cloud gives the planes of the depth frame it came from") {
  const Frame frame = scene::tour(scene::room(), 12, 4)[1];
  std::vector<float> x, y, z;
  std::vector<std::uint16_t> labels;
  for (std::int32_t v = 0; v < scene::frame_size.height; ++v) {
    for (std::int32_t u = 0; u < scene::frame_size.width; ++u) {
      const double depth = frame.depth.view().at(u, v) / 5000.0;
      const Vector3 p = depth * frame.camera.ray(u, v);
      x.push_back(static_cast<float>(p.x));
      y.push_back(static_cast<float>(p.y));
      z.push_back(static_cast<float>(p.z));
      labels.push_back(frame.labels.view().at(u, v));
    }
  }
  PointsView points;
  points.x = x.data();
  points.y = y.data();
  points.z = z.data();
  points.count = x.size();
  PlaneMapBuilder of_depth(scene::options()), of_points(scene::options());
  const RegisteredFrame by_depth = scene::add(of_depth, frame);
  const auto by_points = of_points.add(points, labels, frame.planes, frame.pose);
  REQUIRE(by_points);
  CHECK(by_points->placed == by_depth.placed);
  const PlaneMap a = scene::read(of_depth).map, b = scene::read(of_points).map;
  REQUIRE(a.planes.size() == b.planes.size());
  for (std::size_t i = 0; i < a.planes.size(); ++i) {
    CHECK(scene::angle_to(b.planes[i], a.planes[i].plane.normal) < 1e-3);
    CHECK(a.planes[i].plane.distance == Approx(b.planes[i].plane.distance).margin(1e-3));
    CHECK(a.planes[i].points == b.planes[i].points);
  }
}
