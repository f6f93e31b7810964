// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "planes_room.hpp"

#include <cmath>
#include <fstream>

#include "io/number_text.hpp"
#include "straightedge/host/depth_file.hpp"
#include "support/catch.hpp"

using namespace straightedge;

namespace planes_room {
namespace {

constexpr double yaw_step = 0.4;  // radians
constexpr double height_m = 1.2;

/// Along the ray, in units of its direction.
double distance_to_box(const Vector3& from, const Vector3& direction) {
  double nearest = 1e9;
  const auto meet = [&](double at, double along, double wall) {
    if (along * (wall - at) > 0) nearest = std::min(nearest, (wall - at) / along);
  };
  for (const double sign : {-1.0, 1.0}) {
    meet(from.x, direction.x, 2 * sign);
    meet(from.y, direction.y, 1.5 * sign);
  }
  meet(from.z, direction.z, 0);
  meet(from.z, direction.z, 2.5);
  return nearest;
}

void put(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

}  // namespace

DepthCamera camera() {
  DepthCamera camera;
  camera.pinhole = {80, 80, 79.5, 59.5};
  camera.units_per_metre = 5000;
  camera.size = Size{160, 120};
  return camera;
}

Pose pose(double yaw) {
  const double c = std::cos(yaw), s = std::sin(yaw);
  return {{s, 0, c, -c, 0, s, 0, -1, 0}, {0, 0, height_m}};
}

Image<std::uint16_t> depth(const Pose& world_from_camera) {
  const DepthCamera seen = camera();
  Image<std::uint16_t> picture(*seen.size);
  for (int v = 0; v < picture.height(); ++v) {
    for (int u = 0; u < picture.width(); ++u) {
      const Vector3 ray = world_from_camera.turned(seen.pinhole.ray(u, v));
      const double z = distance_to_box(world_from_camera.translation, ray);
      picture.at(u, v) = static_cast<std::uint16_t>(std::lround(z * seen.units_per_metre));
    }
  }
  return picture;
}

std::string camera_json() {
  return R"({"fx": 80, "fy": 80, "cx": 79.5, "cy": 59.5, "depth_scale": 5000, "width": 160, "height": 120})";
}

std::string pose_line(int i, double shift_x) {
  // The camera's axes by a quarter and a third of a turn, then the yaw about z.
  const double c = std::cos(i * yaw_step / 2), s = std::sin(i * yaw_step / 2);
  std::string line = io::to_text(i) + " " + io::to_text(shift_x) + " 0 " + io::to_text(height_m);
  for (const double q : {-0.5 * (c + s), 0.5 * (c - s), -0.5 * (c - s), 0.5 * (c + s)})
    line.append(" ").append(io::to_text(q));
  return line + "\n";
}

void write_sequence(const std::filesystem::path& folder, int first, int last, double shift_x) {
  std::filesystem::create_directories(folder / "depth");
  std::string list = "# time file\n", poses = "# time x y z quaternion\n";
  for (int i = first; i <= last; ++i) {
    const std::string name = "depth/" + std::to_string(i) + ".png";
    REQUIRE(write_png16(folder / name, depth(pose(i * yaw_step))));
    list += std::to_string(i) + " " + name + "\n";
    poses += pose_line(i, shift_x);
  }
  put(folder / "depth.txt", list);
  put(folder / "groundtruth.txt", poses);
  put(folder / "camera.json", camera_json());
}

std::string ply_of(const std::vector<Vector3>& points) {
  std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(points.size()) +
                     "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
  for (const Vector3& p : points)
    text += io::to_text(p.x) + " " + io::to_text(p.y) + " " + io::to_text(p.z) + "\n";
  return text;
}

std::string corner_ply(int side) {
  std::vector<Vector3> points;
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) points.push_back({-1 + 1.9 * i / side, -1 + 2.0 * j / side, 2});
  }
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) points.push_back({1, -1 + 2.0 * j / side, 0.5 + 1.4 * i / side});
  }
  return ply_of(points);
}

}  // namespace planes_room
