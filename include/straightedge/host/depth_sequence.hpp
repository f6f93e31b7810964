// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "straightedge/host/camera_file.hpp"
#include "straightedge/host/pose.hpp"
#include "straightedge/host/result.hpp"

namespace straightedge {

/// A frame of a sequence, not read yet.
struct SequenceFrame {
  std::filesystem::path file;
  std::string name;  ///< of the file alone, as label images are named
  std::optional<double> time;
  std::optional<Pose> pose;  ///< none: `problem` says why
  std::string problem;       ///< a sentence with the file's name; empty for a good frame
};

struct DepthSequence {
  DepthCamera camera;
  std::vector<SequenceFrame> frames;  ///< in order of time, or of names
};

struct SequenceOptions {
  std::optional<std::filesystem::path> camera;      ///< instead of the folder's camera.json
  std::optional<std::filesystem::path> trajectory;  ///< instead of the folder's own
  std::optional<double> units_per_metre;            ///< instead of the camera's depth_scale
  double max_time_difference = 0.02;                ///< seconds between a frame and its pose
};

/// A folder of depth frames with known poses:
///  - TUM RGB-D layout: `depth.txt` (`time file` a line, unsorted lines allowed), `groundtruth.txt`; every
///    frame takes the pose of the nearest time;
///  - frames (PNG, PGM; also in a subfolder `depth/`) with one matrix file each (`frame-000015.depth.png`,
///    `frame-000015.pose.txt`) or with one trajectory file of as many poses (4x4, Redwood `.log`): n-th pose
///    to n-th frame in sorted order, counts equal.
/// The camera is `camera.json`, or `intrinsics.K.txt`-like 3x3 matrices, or the option. Colour pictures
/// beside the depth are passed over. A frame without a pose or file stays in the list with its problem; a
/// folder without frames, camera or any pose is a failure.
Result<DepthSequence> open_depth_sequence(const std::filesystem::path& folder,
                                          const SequenceOptions& options);

}  // namespace straightedge
