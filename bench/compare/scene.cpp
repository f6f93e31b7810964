// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "scene.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "straightedge/octree.hpp"
#include "straightedge/plane_fit.hpp"

namespace compare {
namespace {

using namespace straightedge;

Scene scene_of(const char* name, bench::FixtureFrame frame) {
  Scene scene{name, std::move(frame), {}, {}, {}};
  const ImageView<const std::uint16_t> raw = scene.frame.raw.view();
  const PinholeCamera& camera = scene.frame.camera;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  scene.picture.width = raw.width;
  for (std::int32_t v = 0; v < raw.height; ++v) {
    for (std::int32_t u = 0; u < raw.width; ++u) {
      const double z = raw.row(v)[u] * scene.frame.metres_per_unit;
      const Vector3 point = z * camera.ray(u, v);
      scene.picture.add(z > 0 ? point : Vector3{none, none, none});
      if (z > 0) scene.cloud.add(point);
    }
  }
  return scene;
}

/// What the room is built of, seen from the camera.
std::vector<Plane> room_truth(const Pose& world_from_camera) {
  std::ifstream file(STRAIGHTEDGE_FIXTURES "/depth/room/truth.json");
  const nlohmann::json json = nlohmann::json::parse(file);
  const std::array<double, 9>& r = world_from_camera.rotation;
  std::vector<Plane> truth;
  for (const auto& entry : json.at("planes")) {
    const std::array<double, 3> at = entry.at("normal");
    const Vector3 n{at[0], at[1], at[2]};
    const Vector3 columns[] = {{r[0], r[3], r[6]}, {r[1], r[4], r[7]}, {r[2], r[5], r[8]}};
    truth.push_back({{dot(columns[0], n), dot(columns[1], n), dot(columns[2], n)},
                     entry.at("distance").get<double>() - dot(n, world_from_camera.translation)});
  }
  return truth;
}

}  // namespace

void Points::add(const Vector3& point) {
  x.push_back(static_cast<float>(point.x));
  y.push_back(static_cast<float>(point.y));
  z.push_back(static_cast<float>(point.z));
}

PointsView Points::view() const {
  PointsView view;
  view.x = x.data();
  view.y = y.data();
  view.z = z.data();
  view.count = x.size();
  view.width = width;
  return view;
}

std::vector<Scene> scenes() {
  std::vector<Scene> all;
  all.push_back(scene_of("office", bench::office_frames().front()));
  all.push_back(scene_of("room", bench::room_frames().front()));
  all.back().truth = room_truth(all.back().frame.world_from_camera);
  return all;
}

Points normals_of(const Points& cloud) {
  const auto count = static_cast<std::uint32_t>(cloud.size());
  std::vector<std::byte> memory(Octree::workspace_bytes(count, {}));
  Octree octree;
  if (Octree::prepare(octree, count, {}, memory) != Status::ok ||
      octree.build(cloud.view()).status != Status::ok) {
    std::fprintf(stderr, "no octree for normals\n");
    std::exit(70);
  }
  Points normals;
  OctreeNeighbour near[16];
  for (std::uint32_t i = 0; i < count; ++i) {
    const OctreeFound found = octree.k_nearest(cloud.at(i), near);
    PlaneMoments around;
    for (std::uint32_t k = 0; k < found.written; ++k) around.add(cloud.at(near[k].index));
    PlaneFit fit;
    const bool flat = fit_plane(around, fit) == Status::ok;
    const Vector3 n = flat ? fit.plane.normal : normalized(cloud.at(i));
    normals.add(dot(n, cloud.at(i)) > 0 ? -n : n);
  }
  return normals;
}

}  // namespace compare
