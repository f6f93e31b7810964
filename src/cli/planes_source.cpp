// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/planes_source.hpp"

#include <filesystem>
#include <system_error>

#include "cli/outputs.hpp"

namespace straightedge::cli {
namespace {

namespace fs = std::filesystem;

Result<fs::path> camera_of_picture(const PlanesArguments& arguments, const fs::path& picture) {
  if (!arguments.camera.empty()) return fs::path(arguments.camera);
  const fs::path folder = fs::absolute(picture).parent_path();
  std::error_code error;
  for (const fs::path& place : {folder, folder.parent_path()}) {
    if (fs::exists(place / "camera.json", error)) return place / "camera.json";
  }
  return Failure{Problem::bad_option, picture.string() +
                                          ": its camera is not known; give --camera, or put a camera.json "
                                          "beside the picture or into the folder above"};
}

Result<DepthSequence> open_picture(const PlanesArguments& arguments) {
  const fs::path picture = input_path(arguments.input);
  std::error_code error;
  if (!fs::exists(picture, error)) {
    const auto reason = error ? error : std::make_error_code(std::errc::no_such_file_or_directory);
    return Failure{Problem::cannot_read, picture.string() + ": cannot be opened (" + reason.message() + ")"};
  }
  const auto file = camera_of_picture(arguments, picture);
  if (!file) return file.failure();
  auto camera = read_camera(*file);
  if (!camera) return camera.failure();
  if (const auto units = arguments.units_per_metre()) camera->units_per_metre = *units;
  SequenceFrame frame;
  frame.file = picture;
  frame.name = picture.filename().string();
  frame.pose = Pose{};
  return DepthSequence{*camera, {frame}};
}

}  // namespace

Result<DepthSequence> open_depth_source(const PlanesArguments& arguments) {
  std::error_code error;
  const bool folder = fs::is_directory(arguments.input, error);
  return folder ? open_depth_sequence(arguments.input, arguments.sequence_options())
                : open_picture(arguments);
}

}  // namespace straightedge::cli
