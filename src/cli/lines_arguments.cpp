// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/lines_arguments.hpp"

#include "cli/map_source.hpp"
#include "cli/number_option.hpp"
#include "straightedge/trigonometry.hpp"

namespace straightedge::cli {
namespace {

constexpr double max_yaw_degrees = 360;

}  // namespace

void LinesArguments::add_to(CLI::App& command) {
  command
      .add_option("IMAGE|MAP.yaml", input,
                  "a picture, or the YAML file of a ROS map, whose thresholds then decide what is wall; "
                  "- is standard input (a picture)")
      ->required();
  add_outputs(command);
  add_map(command);
  detection.add_to(command);
}

void LinesArguments::add_outputs(CLI::App& command) {
  command.add_option("-o,--output", xml, "where the line map goes; - is standard output")
      ->type_name("MAP.xml")
      ->required();
  command.add_option("--svg", svg, "a drawing of the map over the picture")->type_name("OVERLAY.svg");
  command.add_option("--png", png, "the same in pixels")->type_name("OVERLAY.png");
  command.add_option("--csv", csv, "the segments as a table, in the frame of the map")
      ->type_name("SEGMENTS.csv");
}

void LinesArguments::add_map(CLI::App& command) {
  resolution =
      add_real(command, "--resolution", placement.resolution, {0, 1e6, false}, "METRES",
               "metres a pixel, when the input is a picture; without it the map has no place in the world");
  resolution->default_str("none");
  const auto read_origin = [this](const std::string& text) {
    double yaw = 0;
    const bool read = read_numbers(text, {&placement.origin_x, &placement.origin_y, &yaw});
    if (!read || !(yaw >= -max_yaw_degrees && yaw <= max_yaw_degrees)) {
      throw CLI::ValidationError(
          "--origin",
          "\"" + text + "\" is not X,Y,YAW: two numbers in metres and one from -360 to 360 in degrees");
    }
    placement.origin_yaw = yaw * (pi / 180);
  };
  origin = command
               .add_option_function<std::string>("--origin", read_origin,
                                                 "pose of the picture's lower left corner in the world: "
                                                 "metres, metres, degrees; needs --resolution")
               ->type_name("X,Y,YAW")
               ->default_str("0,0,0");
  command.add_flag(
      "--metres", metres,
      "write the map in metres of the world, not in pixels of the picture; needs a place in the world");
  command.add_flag(
      "--fast", fast,
      "the edges of the picture followed from end to end, those of thin walls joined, and no more: about "
      "twice as fast, ends two pixels off; not with a Hough transform");
  command.add_flag("--negate", negate, "walls are light on dark ground, when the input is a picture");
  command
      .add_option("--name", name, "of the map, in the file; without it the input's name without its ending")
      ->type_name("TEXT");
  command.add_option("--description", description, "of the map, in the file")->type_name("TEXT");
  command.add_option("--created", created, "time in the file; NOW is the present, without it there is none")
      ->type_name("TEXT");
}

std::vector<Output> LinesArguments::outputs() const {
  std::vector<Output> outputs = {{"--output", xml, ".xml", {}}};
  if (!svg.empty()) outputs.push_back({"--svg", svg, ".svg", {}});
  if (!png.empty()) outputs.push_back({"--png", png, ".png", {}});
  if (!csv.empty()) outputs.push_back({"--csv", csv, ".csv", {}});
  return outputs;
}

Result<Done> LinesArguments::check() const {
  const auto refuse = [this](const std::string& sentence) {
    return Failure{Problem::bad_option, input + ": " + sentence};
  };
  if (is_ros_map(input)) {
    if (has_placement() || origin->count() > 0)
      return refuse("the map's YAML says resolution and origin; leave --resolution and --origin out");
    if (negate) return refuse("the map's YAML says negate; leave --negate out");
    if (detection.picture() == PictureKind::photo)
      return refuse("a ROS map is no photo; leave --picture out");
    return Done{};
  }
  if (origin->count() > 0 && !has_placement()) return refuse("--origin needs --resolution");
  if (metres && !has_placement()) return refuse("--metres needs --resolution, or the YAML file of a ROS map");
  return Done{};
}

Result<LineMapOptions> LinesArguments::options() const {
  if (auto fine = check(); !fine) return fine.failure();
  if (fast && detection.votes()) return Failure{Problem::bad_option, "--fast is for --method follow alone"};
  auto options = detection.options(common.seed);
  if (options) options->refine = !fast;
  return options;
}

}  // namespace straightedge::cli
