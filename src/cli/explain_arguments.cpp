// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/explain_arguments.hpp"

#include "cli/number_option.hpp"

namespace straightedge::cli {
namespace {

std::vector<CLI::Option*> options_since(CLI::App& command, std::size_t before) {
  const auto all = command.get_options();
  return {all.begin() + static_cast<std::ptrdiff_t>(before), all.end()};
}

Result<Done> refuse(const std::vector<CLI::Option*>& options, const std::string& input, const char* why) {
  for (const CLI::Option* option : options) {
    if (option->count() > 0) return Failure{Problem::bad_option, input + ": " + option->get_name() + why};
  }
  return Done{};
}

constexpr const char* not_for_depth = " is for pictures, and this is a depth frame of 16 bits; leave it out";
constexpr const char* not_for_pictures =
    " is for depth frames of 16 bits, and this is a picture; leave it out";

}  // namespace

void ExplainArguments::add_to(CLI::App& command) {
  command
      .add_option("IMAGE|MAP.yaml|DEPTH", input,
                  "a picture, the YAML file of a ROS map, or a 16-bit gray depth PNG or PGM; - is standard "
                  "input (a picture or a depth frame)")
      ->required();
  command
      .add_option("-o,--output", folder,
                  "where the pictures and index.html go; the folder is made when there is none")
      ->type_name("DIR")
      ->required();
  add_choice<Method>(command, "--method", method_,
                     {{"auto", Method::automatic},
                      {"standard", Method::standard},
                      {"progressive", Method::progressive},
                      {"randomized", Method::randomized},
                      {"ransac", Method::ransac},
                      {"hough", Method::hough}},
                     "of a picture as for lines, of a depth frame as for planes; auto: progressive, ransac");
  std::size_t before = command.get_options().size();
  command
      .add_option("--camera", camera,
                  "of a depth frame: its intrinsics; without it camera.json in its folder or above it")
      ->type_name("CAMERA.json");
  depth_scale_option_ = add_real(command, "--depth-scale", depth_scale_, {0, 1e9, false}, "UNITS",
                                 "of a depth frame: units a metre, in place of the camera's");
  depth_scale_option_->default_str("the camera's");
  for_depth_ = options_since(command, before);
  before = command.get_options().size();
  detection_.add_without_method(command);
  for_pictures_ = options_since(command, before);
  picture_option_ = command.get_option("--picture");
}

Result<LineMapOptions> ExplainArguments::line_options() const {
  if (auto fine = refuse(for_depth_, input, not_for_pictures); !fine) return fine.failure();
  DetectionArguments detection = detection_;
  switch (method_) {
    case Method::standard:
      detection.set_method(HoughMethod::standard);
      break;
    case Method::automatic:  // votes are what there is to see
    case Method::progressive:
      detection.set_method(HoughMethod::progressive);
      break;
    case Method::randomized:
      detection.set_method(HoughMethod::randomized);
      break;
    case Method::ransac:
    case Method::hough:
      return Failure{
          Problem::bad_option,
          input + ": --method ransac and hough are for depth frames of 16 bits, and this is a picture"};
  }
  return detection.options(common.seed);
}

Result<PlaneDetectorOptions> ExplainArguments::plane_options() const {
  if (auto fine = refuse(for_pictures_, input, not_for_depth); !fine) return fine.failure();
  const bool for_lines =
      method_ == Method::standard || method_ == Method::progressive || method_ == Method::randomized;
  if (for_lines) return Failure{Problem::bad_option, input + ": a depth frame's --method is ransac or hough"};
  PlaneDetectorOptions options;
  options.method = method_ == Method::hough ? PlaneMethod::hough : PlaneMethod::ransac;
  options.ransac.seed = common.seed;
  return options;
}

std::optional<double> ExplainArguments::units_per_metre() const {
  if (depth_scale_option_->count() == 0) return {};
  return depth_scale_;
}

bool ExplainArguments::wants_picture() const {
  return picture_option_->count() > 0;
}

}  // namespace straightedge::cli
