// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "catch.hpp"
#include "random_plane_map.hpp"
#include "straightedge/host/cloud.hpp"
#include "straightedge/host/label_picture.hpp"
#include "straightedge/host/ply.hpp"
#include "temporary_folder.hpp"

using namespace straightedge;

namespace {

std::string body_of(const std::string& bytes) {
  const std::string end = "end_header\n";
  return bytes.substr(bytes.find(end) + end.size());
}

std::uint32_t word_at(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << 8 * i;
  return value;
}

struct Points {
  std::vector<float> x{1, 2, std::numeric_limits<float>::quiet_NaN(), 4}, y{5, 6, 7, 8}, z{-1, -2, -3, -4};
  std::vector<std::uint32_t> labels{0, 1, 2, 4000000000u};
  PointsView view() const {
    PointsView points;
    points.x = x.data();
    points.y = y.data();
    points.z = z.data();
    points.count = x.size();
    return points;
  }
};

}  // namespace

TEST_CASE("PLY of points: what is written is what is read, with labels and their colours") {
  const TemporaryFolder folder;
  const Points points;
  REQUIRE(
      write_points_ply(folder / "p.ply", points.view(), points.labels, {"straightedge 0.1", "two\nlines"}));
  const std::string bytes = bytes_of(folder / "p.ply");
  CHECK(
      bytes.starts_with("ply\nformat binary_little_endian 1.0\ncomment straightedge 0.1\ncomment two lines\n"
                        "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                        "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uint label\n"
                        "end_header\n"));
  const auto cloud = read_cloud(folder / "p.ply");
  REQUIRE(cloud);
  CHECK(cloud->x == std::vector<float>{1, 2, 4});
  CHECK(cloud->y == std::vector<float>{5, 6, 8});
  CHECK(cloud->z == std::vector<float>{-1, -2, -4});
  const std::string body = body_of(bytes);
  REQUIRE(body.size() == 3 * 19);
  const std::uint32_t labels[] = {0, 1, 4000000000u};
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(word_at(body, 19 * i + 15) == labels[i]);
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(body[19 * i + 12 + k]); };
    CHECK(Rgb{byte(0), byte(1), byte(2)} == plane_colour(labels[i]));
  }
}

TEST_CASE("PLY of points: with those that are no readings, and without labels") {
  const TemporaryFolder folder;
  const Points points;
  REQUIRE(write_points_ply(folder / "p.ply", points.view(), {}, {}, InvalidPoints::keep));
  const auto cloud = read_cloud(folder / "p.ply");
  REQUIRE(cloud);
  REQUIRE(cloud->x.size() == 4);
  CHECK(std::isnan(cloud->x[2]));
  CHECK(cloud->y[3] == 8);
  CHECK(word_at(body_of(bytes_of(folder / "p.ply")), 19 + 15) == 0);
}

TEST_CASE("PLY of points: collected over frames, each moved by its pose") {
  const TemporaryFolder folder;
  const Points points;
  PointsPly ply({"a sequence"});
  Pose pose;
  pose.rotation = {0, -1, 0, 1, 0, 0, 0, 0, 1};
  pose.translation = {100, 0, 0};
  REQUIRE(ply.add(points.view(), points.labels));
  REQUIRE(ply.add(points.view(), points.labels, pose));
  ply.add({7, 8, 9}, 3);
  CHECK(ply.count() == 7);
  REQUIRE(ply.write(folder / "a.ply"));
  const auto cloud = read_cloud(folder / "a.ply");
  REQUIRE(cloud);
  CHECK(cloud->x == std::vector<float>{1, 2, 4, 95, 94, 92, 7});
  CHECK(cloud->y == std::vector<float>{5, 6, 8, 1, 2, 4, 8});
  for (int i = 0; i < 100; ++i) ply.add({1, 1, 1}, 0);
  REQUIRE(ply.write(folder / "b.ply"));
  CHECK(read_cloud(folder / "b.ply")->x.size() == 107);
}

TEST_CASE("PLY of points: none, too few labels, nowhere to write") {
  const TemporaryFolder folder;
  const Points points;
  REQUIRE(write_points_ply(folder / "none.ply", PointsView{}, {}));
  CHECK(read_cloud(folder / "none.ply")->x.empty());
  const auto few = write_points_ply(folder / "few.ply", points.view(), std::span(points.labels).first(2));
  REQUIRE_FALSE(few);
  CHECK(few.failure().problem == Problem::bad_option);
  CHECK(few.failure().sentence == (folder / "few.ply").string() + ": there are 2 labels for 4 points");
  CHECK_FALSE(std::filesystem::exists(folder / "few.ply"));
  const auto nowhere = write_points_ply(folder / "no/p.ply", points.view(), points.labels);
  REQUIRE_FALSE(nowhere);
  CHECK(nowhere.failure().problem == Problem::cannot_write);
}

TEST_CASE("PLY of polygons: triangles of every plane with its colour and id") {
  const TemporaryFolder folder;
  PlaneMap map = small_plane_map();
  map.planes[1].polygons = {{false, {{0, 0, 0}, {1, 0, 0}, {0, 0.8, 0.6}}}};
  REQUIRE(write_polygons_ply(folder / "m.ply", map));
  const std::string bytes = bytes_of(folder / "m.ply");
  CHECK(
      bytes.starts_with("ply\nformat binary_little_endian 1.0\ncomment straightedge 0.1\n"
                        "comment planes room --seed 1\nelement vertex 10\n"));
  CHECK(bytes.find("element face 8\nproperty list uchar int vertex_indices\nend_header\n") !=
        std::string::npos);
  const auto cloud = read_cloud(folder / "m.ply");
  REQUIRE(cloud);
  REQUIRE(cloud->x.size() == 10);
  const std::string faces = body_of(bytes).substr(10 * 19);
  REQUIRE(faces.size() == 8 * 13);
  double table = 0, wall = 0;
  for (std::size_t f = 0; f < 8; ++f) {
    CHECK(faces[13 * f] == 3);
    Vector3 corner[3];
    std::uint32_t at = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      at = word_at(faces, 13 * f + 1 + 4 * k);
      REQUIRE(at < 10);
      corner[k] = cloud->view().at(at);
    }
    const double area = length(cross(corner[1] - corner[0], corner[2] - corner[0])) / 2;
    (at < 7 ? table : wall) += area;
  }
  CHECK(table == Approx(1 - 0.005));
  CHECK(wall == Approx(0.5));
  CHECK(word_at(body_of(bytes), 9 * 19 + 15) == 5);
}

TEST_CASE("PLY of polygons: no planes, and the same bytes again") {
  const TemporaryFolder folder;
  REQUIRE(write_polygons_ply(folder / "empty.ply", PlaneMap{}));
  CHECK(read_cloud(folder / "empty.ply")->x.empty());
  RandomPlaneMaps maps(60);
  for (int i = 0; i < 20; ++i) {
    const PlaneMap map = maps.next();
    REQUIRE(write_polygons_ply(folder / "a.ply", map));
    REQUIRE(write_polygons_ply(folder / "b.ply", map));
    CHECK(bytes_of(folder / "a.ply") == bytes_of(folder / "b.ply"));
    REQUIRE(read_cloud(folder / "a.ply"));
  }
}
