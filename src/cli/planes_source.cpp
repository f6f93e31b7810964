// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/planes_source.hpp"

#include <filesystem>
#include <system_error>

#include "cli/depth_camera.hpp"
#include "cli/outputs.hpp"

namespace straightedge::cli {
namespace {

namespace fs = std::filesystem;

Result<DepthSequence> open_picture(const PlanesArguments& arguments) {
  const fs::path picture = input_path(arguments.input);
  std::error_code error;
  if (!fs::exists(picture, error)) {
    const auto reason = error ? error : std::make_error_code(std::errc::no_such_file_or_directory);
    return Failure{Problem::cannot_read, picture.string() + ": cannot be opened (" + reason.message() + ")"};
  }
  const auto camera = find_depth_camera(picture, arguments.camera, arguments.units_per_metre());
  if (!camera) return camera.failure();
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
