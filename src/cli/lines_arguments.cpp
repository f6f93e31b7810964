// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/lines_arguments.hpp"

#include <algorithm>
#include <filesystem>

#include "cli/hough_arguments.hpp"
#include "cli/number_option.hpp"
#include "io/number_text.hpp"
#include "straightedge/host/ros_map.hpp"
#include "straightedge/trigonometry.hpp"

namespace straightedge::cli {
namespace {

constexpr double max_yaw_degrees = 360;

const char* name_of(PictureKind kind) {
  if (kind == PictureKind::automatic) return "auto";
  return kind == PictureKind::map ? "map" : "photo";
}

}  // namespace

void LinesArguments::add_to(CLI::App& command) {
  command
      .add_option("IMAGE|MAP.yaml", input,
                  "a picture, or the YAML file of a ROS map, whose thresholds then decide what is wall; "
                  "- is standard input (a picture)")
      ->required();
  add_outputs(command);
  add_map(command);
  add_detection(command);
  canny.add_to(command);
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
  command.add_flag("--negate", negate, "walls are light on dark ground, when the input is a picture");
  command
      .add_option("--name", name, "of the map, in the file; without it the input's name without its ending")
      ->type_name("TEXT");
  command.add_option("--description", description, "of the map, in the file")->type_name("TEXT");
  command.add_option("--created", created, "time in the file; NOW is the present, without it there is none")
      ->type_name("TEXT");
}

void LinesArguments::add_detection(CLI::App& command) {
  LineMapOptions& o = map;
  add_choice<PictureKind>(
      command, "--picture", o.picture,
      {{"auto", PictureKind::automatic}, {"map", PictureKind::map}, {"photo", PictureKind::photo}},
      "in a map what is dark is wall, in a photo every edge is a line");
  add_method(command, o.hough.method);
  add_real(command, "--min-length", o.min_length, {3, 1e6}, "PX", "shorter segments are dropped");
  add_real(command, "--max-gap", o.max_gap, {0, 1e6}, "PX", "a hole in a wall up to this long is bridged");
  add_real(command, "--max-wall-width", o.max_wall_width, {0, 50}, "PX",
           "thinner walls become one axis, thicker ones keep both faces");
  add_real(command, "--furniture-size", o.furniture_size, {0, 1e6}, "PX",
           "things that stand alone and are no larger are dropped");
  add_degrees(command, "--window", o.hough.gradient_window, {0, 180},
              "a pixel votes for lines within this angle of its own direction, 0 = for all");
  add_whole(command, "--threshold", o.hough.threshold, {1, 2147483647}, "VOTES",
            "of edge pixels that make a line");
}

bool LinesArguments::is_ros_map() const {
  std::string ending = std::filesystem::path(input).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c); });
  return ending == ".yaml" || ending == ".yml";
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
  if (is_ros_map()) {
    if (has_placement() || origin->count() > 0)
      return refuse("the map's YAML says resolution and origin; leave --resolution and --origin out");
    if (negate) return refuse("the map's YAML says negate; leave --negate out");
    if (map.picture == PictureKind::photo) return refuse("a ROS map is no photo; leave --picture out");
    return Done{};
  }
  if (origin->count() > 0 && !has_placement()) return refuse("--origin needs --resolution");
  if (metres && !has_placement()) return refuse("--metres needs --resolution, or the YAML file of a ROS map");
  return Done{};
}

Result<LineMapOptions> LinesArguments::options() const {
  if (auto fine = check(); !fine) return fine.failure();
  const auto edges = canny.options();
  if (!edges) return edges.failure();
  LineMapOptions options = map;
  options.canny = *edges;
  options.hough.seed = common.seed;
  // Shorter segments can only come out when shorter ones are looked for.
  options.hough.min_length = std::min(options.hough.min_length, options.min_length);
  return options;
}

std::string words_of(const LineMapOptions& o) {
  const auto number = [](const char* name, auto value) {
    return std::string(", ") + name + " " + io::to_text(value);
  };
  return "method " + name_of(o.hough.method) + ", seed " + io::to_text(o.hough.seed) + ", picture " +
         name_of(o.picture) + number("min-length", o.min_length) + number("max-gap", o.max_gap) +
         number("max-wall-width", o.max_wall_width) + number("furniture-size", o.furniture_size) +
         number("window", o.hough.gradient_window * (180 / pi)) + " degrees" +
         number("threshold", o.hough.threshold) + ", " + words_of(o.canny);
}

}  // namespace straightedge::cli
