// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "io/number_text.hpp"
#include "temporary_folder.hpp"

/// A folder of frames that is gone when the test is over. It begins with a camera.json alone.
class SequenceMaker {
 public:
  SequenceMaker() { text("camera.json", R"({"fx": 525, "fy": 525, "cx": 1.5, "cy": 1})"); }

  const std::filesystem::path& path() const { return folder_.path(); }

  std::filesystem::path text(const std::string& name, const std::string& content) const {
    const auto file = folder_ / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << content;
    return file;
  }
  /// Whatever its ending says: opening a sequence reads no frame.
  void frame(const std::string& name) const { text(name, "P2 4 3 1000 0 0 0 0 7 7 7 7 900 900 900 900\n"); }

  /// The pose of a camera at x that is not turned, as a 4x4 matrix.
  static std::string matrix(int x) { return "1 0 0 " + std::to_string(x) + "\n0 1 0 0\n0 0 1 0\n0 0 0 1\n"; }
  /// TUM lines of such poses: time and x.
  static std::string tum(const std::vector<std::pair<double, int>>& poses) {
    std::string lines;
    for (const auto& [time, x] : poses)
      lines += straightedge::io::to_text(time) + " " + std::to_string(x) + " 0 0 0 0 0 1\n";
    return lines;
  }

 private:
  TemporaryFolder folder_;
};
