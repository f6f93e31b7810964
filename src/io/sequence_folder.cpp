// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "io/sequence_folder.hpp"

#include <algorithm>
#include <string>
#include <system_error>

#include "io/natural_order.hpp"

namespace straightedge::io {
namespace {

namespace fs = std::filesystem;

std::string in_small_letters(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

bool contains(const std::string& text, const char* part) {
  return text.find(part) != std::string::npos;
}

/// The names of the files in natural order, hidden ones left out.
Result<std::vector<std::string>> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (!name.starts_with('.') && is_file(entry->path())) names.push_back(name);
  }
  if (error)
    return Failure{Problem::cannot_read, folder.string() + ": cannot be opened (" + error.message() + ")"};
  std::sort(names.begin(), names.end(), natural_less);
  return names;
}

bool is_picture(const std::string& name) {
  const std::string small = in_small_letters(name);
  return small.ends_with(".png") || small.ends_with(".pgm");
}

bool says_depth(const std::string& name) {
  return contains(in_small_letters(name), "depth");
}

bool says_no_depth(const std::string& name) {
  const std::string small = in_small_letters(name);
  return contains(small, "color") || contains(small, "colour") || contains(small, "rgb") ||
         contains(small, "label");
}

bool is_camera(const std::string& name) {
  const std::string small = in_small_letters(name);
  return (small.starts_with("camera") && small.ends_with(".json")) ||
         (small.starts_with("intrinsics") && small.ends_with(".txt")) || small.ends_with(".k.txt") ||
         small.ends_with(".k");
}

/// `frame-000015.depth` and `depth_000015` belong to `frame-000015` and `000015`.
std::string without_depth(const std::string& stem) {
  const std::size_t at = in_small_letters(stem).find("depth");
  if (at == std::string::npos) return stem;
  const auto separator = [&](std::size_t i) {
    return i < stem.size() && (stem[i] == '.' || stem[i] == '_' || stem[i] == '-');
  };
  const std::size_t end = at + 5;
  if (at > 0 && separator(at - 1)) return stem.substr(0, at - 1) + stem.substr(end);
  return stem.substr(0, at) + stem.substr(separator(end) ? end + 1 : end);
}

}  // namespace

bool is_file(const fs::path& file) noexcept {
  std::error_code ignored;
  return fs::is_regular_file(file, ignored);
}

Result<std::vector<fs::path>> depth_files(const fs::path& folder) {
  std::error_code ignored;
  std::vector<fs::path> files;
  for (const fs::path& place : {folder / "depth", folder}) {
    if (place != folder && !fs::is_directory(place, ignored)) continue;
    auto names = names_in(place);
    if (!names) return names.failure();
    std::erase_if(*names, [](const std::string& name) { return !is_picture(name); });
    const bool told = std::any_of(names->begin(), names->end(), says_depth);
    std::erase_if(*names, [&](const std::string& name) {
      return told ? !says_depth(name) : place == folder && says_no_depth(name);
    });
    for (const std::string& name : *names) files.push_back(place / name);
    if (!files.empty()) break;
  }
  return files;
}

Result<fs::path> camera_file(const fs::path& folder) {
  if (is_file(folder / "camera.json")) return folder / "camera.json";
  auto names = names_in(folder);
  if (!names) return names.failure();
  std::erase_if(*names, [](const std::string& name) { return !is_camera(name); });
  if (names->empty()) {
    return Failure{Problem::cannot_read, folder.string() +
                                             ": has no camera: neither a camera.json nor a 3x3 matrix named "
                                             "like intrinsics.K.txt"};
  }
  if (names->size() > 1) {
    return Failure{Problem::bad_content, folder.string() + ": has more than one camera (" + (*names)[0] +
                                             ", " + (*names)[1] + "): say which one counts"};
  }
  return folder / names->front();
}

std::optional<fs::path> pose_file(const fs::path& folder, const fs::path& frame) {
  const std::string name = without_depth(frame.stem().string());
  for (const fs::path& file :
       {frame.parent_path() / (name + ".pose.txt"), folder / (name + ".pose.txt"),
        folder / "pose" / (name + ".txt"), folder / "poses" / (name + ".txt"),
        folder / "pose" / (name + ".pose.txt"), folder / "poses" / (name + ".pose.txt")}) {
    if (is_file(file)) return file;
  }
  return {};
}

Result<fs::path> trajectory_file(const fs::path& folder) {
  for (const char* name : {"trajectory.log", "trajectory.txt", "poses.txt", "pose.txt", "groundtruth.txt"}) {
    if (is_file(folder / name)) return folder / name;
  }
  return Failure{Problem::cannot_read, folder.string() +
                                           ": has no poses: neither a trajectory (groundtruth.txt, "
                                           "trajectory.log, trajectory.txt, poses.txt, pose.txt) nor a file "
                                           "for each frame"};
}

}  // namespace straightedge::io
