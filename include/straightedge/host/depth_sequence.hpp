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
  std::optional<Pose> pose;
  std::string problem;  ///< why the frame cannot be used, with the file's name; empty for a good frame
};

struct DepthSequence {
  DepthCamera camera;
  std::vector<SequenceFrame> frames;  ///< in order of time, or of names
};

struct SequenceOptions {
  std::optional<std::filesystem::path> camera;      ///< instead of the folder's camera.json
  std::optional<std::filesystem::path> trajectory;  ///< instead of the folder's own
  std::optional<double> units_per_metre;            ///< instead of the camera's depth_scale; above 0
  double max_time_difference = 0.02;                ///< seconds between a frame and its pose; 0 or above
};

/// A folder of depth frames with known poses, camera to world.
///
/// Frames: those of `depth.txt` (`time file` a line, as in TUM RGB-D sets; lines in any order), else the PNG
/// and PGM files in the subfolder `depth/`, else those in the folder. Where names of pictures contain
/// "depth", only these are frames; names with "color", "colour", "rgb" or "label" are none, hidden files
/// neither. Without times the order is that of names, in which numbers count as numbers: frame-2 before
/// frame-10.
///
/// Poses, the first of these that there is:
///  1. the trajectory of the options;
///  2. for frames with times, `groundtruth.txt`;
///  3. one file a frame: `frame-000015.pose.txt` for `frame-000015.depth.png`, beside it or in the folder, or
///     `pose/000015.txt` or `poses/000015.txt` for `depth/000015.png`;
///  4. `trajectory.log`, `trajectory.txt`, `poses.txt`, `pose.txt`, `groundtruth.txt`.
/// A trajectory with times gives every frame that has one the pose of the nearest time; otherwise the n-th
/// pose belongs to the n-th frame, and the counts must be equal.
///
/// Camera: that of the options, else `camera.json`, else the one file named `camera*.json`,
/// `intrinsics*.txt`,
/// `*.K.txt` or `*.K`.
///
/// A frame whose file is missing, whose name came before, that has no pose or an unreadable pose file stays
/// in the list with its problem. bad_option: options out of range. cannot_read: no such folder, no camera, no
/// poses, `depth.txt` missing beside a `groundtruth.txt`. bad_content: a folder without frames, a broken
/// list, camera or trajectory, unequal counts, no pose near the time of any frame.
Result<DepthSequence> open_depth_sequence(const std::filesystem::path& folder,
                                          const SequenceOptions& options);

}  // namespace straightedge
