// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/depth_sequence.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <system_error>

#include "io/number_lines.hpp"
#include "io/number_text.hpp"
#include "io/read_bytes.hpp"
#include "io/sequence_folder.hpp"
#include "straightedge/host/trajectory.hpp"

namespace straightedge {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_list_bytes = std::size_t{1} << 26;

using Frames = std::vector<SequenceFrame>;
using Poses = std::vector<TimedPose>;

Failure bad(const fs::path& file, const std::string& what) {
  return {Problem::bad_content, file.string() + ": " + what};
}

SequenceFrame frame_of(const fs::path& file, std::optional<double> time) {
  return {file, file.filename().string(), time, {}, {}};
}

/// `depth.txt`, in order of time.
Result<Frames> listed_frames(const fs::path& list) {
  const auto text = io::read_bytes(list, max_list_bytes);
  if (!text) return text.failure();
  Frames frames;
  for (const io::WordLine& line : io::word_lines(*text)) {
    if (line.words.size() != 2)
      return bad(list, "line " + std::to_string(line.line) + ": is not a time and a file");
    const auto time = io::finite_number(line.words[0], line.line, list.string());
    if (!time) return time.failure();
    frames.push_back(frame_of(list.parent_path() / line.words[1], *time));
  }
  if (frames.empty()) return bad(list, "names no frame");
  std::stable_sort(frames.begin(), frames.end(),
                   [](const SequenceFrame& a, const SequenceFrame& b) { return *a.time < *b.time; });
  return frames;
}

Result<Frames> found_frames(const fs::path& folder) {
  const auto files = io::depth_files(folder);
  if (!files) return files.failure();
  if (files->empty()) return bad(folder, "holds no depth frames (PNG or PGM, here or in depth/)");
  Frames frames;
  for (const fs::path& file : *files) frames.push_back(frame_of(file, {}));
  return frames;
}

/// The pose of the nearest time, the earlier one of two as near.
void give_pose_by_time(SequenceFrame& frame, const Poses& poses, double max_difference) {
  const auto after = std::lower_bound(poses.begin(), poses.end(), *frame.time,
                                      [](const TimedPose& pose, double time) { return *pose.time < time; });
  auto nearest = after;
  if (after == poses.end() ||
      (after != poses.begin() && *frame.time - *(after - 1)->time <= *after->time - *frame.time))
    --nearest;
  const double difference = std::abs(*nearest->time - *frame.time);
  if (difference <= max_difference) {
    frame.pose = nearest->pose;
  } else {
    frame.problem = frame.file.string() + ": no pose within " + io::to_short_text(max_difference) +
                    " s; the nearest is " + io::to_short_text(difference) + " s away";
  }
}

Result<Done> give_poses_by_time(Frames& frames, const Poses& poses, const fs::path& file,
                                double max_difference) {
  for (SequenceFrame& frame : frames) give_pose_by_time(frame, poses, max_difference);
  const bool any =
      std::any_of(frames.begin(), frames.end(), [](const auto& f) { return f.pose.has_value(); });
  if (!any) return bad(file, "no pose is within " + io::to_short_text(max_difference) + " s of any frame");
  return Done{};
}

Result<Done> give_poses_in_order(Frames& frames, const Poses& poses, const fs::path& file) {
  if (poses.size() != frames.size()) {
    return bad(file, "has " + std::to_string(poses.size()) + " poses for " + std::to_string(frames.size()) +
                         " frames; the n-th belongs to the n-th, so the counts must be equal");
  }
  for (std::size_t i = 0; i < frames.size(); ++i) frames[i].pose = poses[i].pose;
  return Done{};
}

Result<Done> give_poses_of_trajectory(Frames& frames, const fs::path& file, const SequenceOptions& options) {
  const auto poses = read_trajectory(file);
  if (!poses) return poses.failure();
  const bool timed = poses->front().time.has_value();
  if (timed && frames.front().time)
    return give_poses_by_time(frames, *poses, file, options.max_time_difference);
  if (timed && !options.trajectory) {
    return Failure{Problem::cannot_read, (file.parent_path() / "depth.txt").string() +
                                             ": is missing: " + file.filename().string() +
                                             " has times, and nothing says those of the frames"};
  }
  return give_poses_in_order(frames, *poses, file);
}

void give_own_pose(SequenceFrame& frame, const std::optional<fs::path>& file) {
  if (!file) {
    frame.problem = frame.file.string() + ": has no pose file";
    return;
  }
  const auto poses = read_trajectory(*file);
  if (!poses) {
    frame.problem = poses.failure().sentence;
  } else if (poses->size() != 1) {
    frame.problem = file->string() + ": has " + std::to_string(poses->size()) + " poses; one is expected";
  } else {
    frame.pose = poses->front().pose;
  }
}

/// False when no frame has a file of its own.
bool give_own_poses(Frames& frames, const fs::path& folder) {
  std::vector<std::optional<fs::path>> files;
  for (const SequenceFrame& frame : frames) files.push_back(io::pose_file(folder, frame.file));
  if (std::none_of(files.begin(), files.end(), [](const auto& file) { return file.has_value(); }))
    return false;
  for (std::size_t i = 0; i < frames.size(); ++i) give_own_pose(frames[i], files[i]);
  return true;
}

Result<Done> give_poses(Frames& frames, const fs::path& folder, const SequenceOptions& options) {
  if (options.trajectory) return give_poses_of_trajectory(frames, *options.trajectory, options);
  if (frames.front().time && io::is_file(folder / "groundtruth.txt"))
    return give_poses_of_trajectory(frames, folder / "groundtruth.txt", options);
  if (give_own_poses(frames, folder)) return Done{};
  const auto file = io::trajectory_file(folder);
  if (!file) return file.failure();
  return give_poses_of_trajectory(frames, *file, options);
}

/// Frames that cannot be used whatever their pose.
void note_bad_files(Frames& frames) {
  std::set<std::string> names;
  for (SequenceFrame& frame : frames) {
    if (!io::is_file(frame.file)) {
      frame.problem = frame.file.string() + ": is missing";
    } else if (!names.insert(frame.name).second) {
      frame.problem = frame.file.string() + ": a frame named " + frame.name + " came before";
    }
  }
}

Result<DepthCamera> camera_of(const fs::path& folder, const SequenceOptions& options) {
  auto file = options.camera ? Result<fs::path>(*options.camera) : io::camera_file(folder);
  if (!file) return file.failure();
  auto camera = read_camera(*file);
  if (camera && options.units_per_metre) camera->units_per_metre = *options.units_per_metre;
  return camera;
}

std::optional<Failure> refused(const fs::path& folder, const SequenceOptions& options) {
  const auto finite = [](double value) { return value - value == 0; };
  if (!(options.max_time_difference >= 0) || !finite(options.max_time_difference))
    return Failure{Problem::bad_option, "the largest time between a frame and its pose is not 0 or above"};
  if (options.units_per_metre && (!(*options.units_per_metre > 0) || !finite(*options.units_per_metre)))
    return Failure{Problem::bad_option, "the depth scale (units per metre) is not above zero"};
  std::error_code error;
  const auto status = fs::status(folder, error);
  if (fs::is_directory(status)) return {};
  const std::string why = fs::exists(status) ? "is no folder" : "cannot be opened (" + error.message() + ")";
  return Failure{Problem::cannot_read, folder.string() + ": " + why};
}

}  // namespace

Result<DepthSequence> open_depth_sequence(const fs::path& folder, const SequenceOptions& options) {
  if (const auto failure = refused(folder, options)) return *failure;
  auto frames =
      io::is_file(folder / "depth.txt") ? listed_frames(folder / "depth.txt") : found_frames(folder);
  if (!frames) return frames.failure();
  const auto camera = camera_of(folder, options);
  if (!camera) return camera.failure();
  const auto posed = give_poses(*frames, folder, options);
  if (!posed) return posed.failure();
  note_bad_files(*frames);
  return DepthSequence{*camera, std::move(*frames)};
}

}  // namespace straightedge
