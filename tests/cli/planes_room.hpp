// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "run_program.hpp"
#include "straightedge/host/camera_file.hpp"
#include "straightedge/host/image.hpp"
#include "straightedge/host/pose.hpp"

/// A box of a room, 4 x 3 x 2.5 m, z up, the origin in the middle of the floor. Its six faces are
/// |x| = 2, |y| = 1.5, z = 0 and z = 2.5.
namespace planes_room {

using straightedge::DepthCamera;
using straightedge::Image;
using straightedge::Pose;

/// 160 x 120 pixels, 5000 units a metre.
DepthCamera camera();
/// In the middle of the room, 1.2 m high, looking along (cos yaw, sin yaw, 0).
Pose pose(double yaw);
/// What the camera sees; no noise but that of whole units.
Image<std::uint16_t> depth(const Pose& world_from_camera);

inline constexpr int frames = 5;

std::string camera_json();
/// The line of `groundtruth.txt` for frame i, whose time is i seconds, moved along x.
std::string pose_line(int i, double shift_x = 0);

/// Frames `first` to `last` of a look around in TUM layout: depth.txt, depth/0.png ..., groundtruth.txt and
/// camera.json. Makes the folder.
void write_sequence(const std::filesystem::path& folder, int first = 0, int last = frames - 1,
                    double shift_x = 0);

/// Points on the planes z = 2 and x = 1, `side` x `side` on each, as an ascii PLY.
std::string corner_ply(int side);
std::string ply_of(const std::vector<straightedge::Vector3>& points);

}  // namespace planes_room
