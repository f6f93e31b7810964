// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/depth_camera.hpp"

#include <system_error>

namespace straightedge::cli {
namespace {

namespace fs = std::filesystem;

Result<fs::path> camera_file(const fs::path& picture, const std::string& given) {
  if (!given.empty()) return fs::path(given);
  const fs::path folder = fs::absolute(picture).parent_path();
  std::error_code error;
  for (const fs::path& place : {folder, folder.parent_path()}) {
    if (fs::exists(place / "camera.json", error)) return place / "camera.json";
  }
  return Failure{Problem::bad_option, picture.string() +
                                          ": its camera is not known; give --camera, or put a camera.json "
                                          "beside the picture or into the folder above"};
}

}  // namespace

Result<DepthCamera> find_depth_camera(const fs::path& picture, const std::string& given,
                                      std::optional<double> units_per_metre) {
  const auto file = camera_file(picture, given);
  if (!file) return file.failure();
  auto camera = read_camera(*file);
  if (camera && units_per_metre) camera->units_per_metre = *units_per_metre;
  return camera;
}

}  // namespace straightedge::cli
