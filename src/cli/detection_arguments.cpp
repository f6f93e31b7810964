// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/detection_arguments.hpp"

#include "cli/hough_arguments.hpp"
#include "cli/number_option.hpp"
#include "io/number_text.hpp"
#include "straightedge/trigonometry.hpp"

namespace straightedge::cli {
namespace {

const char* name_of(PictureKind kind) {
  if (kind == PictureKind::automatic) return "auto";
  return kind == PictureKind::map ? "map" : "photo";
}

}  // namespace

void DetectionArguments::add_to(CLI::App& command) {
  add_picture(command);
  add_choice<std::optional<HoughMethod>>(
      command, "--method", method,
      {{"follow", std::nullopt},
       {"standard", HoughMethod::standard},
       {"progressive", HoughMethod::progressive},
       {"randomized", HoughMethod::randomized}},
      "how straight edges are found: each followed from pixel to pixel; or by a Hough transform, where every "
      "pixel votes, random pixels vote until a line stands out, or random pairs vote");
  add_the_rest(command);
}

void DetectionArguments::add_without_method(CLI::App& command) {
  add_picture(command);
  add_the_rest(command);
}

void DetectionArguments::add_picture(CLI::App& command) {
  add_choice<PictureKind>(
      command, "--picture", given.picture,
      {{"auto", PictureKind::automatic}, {"map", PictureKind::map}, {"photo", PictureKind::photo}},
      "in a map what is dark is wall, in a photo every edge is a line");
}

void DetectionArguments::add_the_rest(CLI::App& command) {
  LineMapOptions& o = given;
  add_real(command, "--min-length", o.min_length, {3, 1e6}, "PX", "shorter segments are dropped");
  add_real(command, "--max-gap", o.max_gap, {0, 1e6}, "PX", "a hole in a wall up to this long is bridged");
  add_real(command, "--max-wall-width", o.max_wall_width, {0, 50}, "PX",
           "thinner walls become one axis, thicker ones keep both faces");
  add_real(command, "--furniture-size", o.furniture_size, {0, 1e6}, "PX",
           "things that stand alone and are no larger are dropped");
  for_votes = {
      add_degrees(command, "--window", hough.gradient_window, {0, 180},
                  "Hough: a pixel votes for lines within this angle of its own direction, 0 = for all"),
      add_whole(command, "--threshold", hough.threshold, {1, 2147483647}, "VOTES",
                "Hough: of edge pixels that make a line")};
  canny.add_to(command);
}

Result<LineMapOptions> DetectionArguments::options(std::uint64_t seed) const {
  const auto edges = canny.options();
  if (!edges) return edges.failure();
  LineMapOptions options = given;
  options.canny = *edges;
  if (method) {
    options.hough = hough;
    options.hough->method = *method;
    options.hough->seed = seed;
    return options;
  }
  for (const CLI::Option* option : for_votes) {
    if (option->count() == 0) continue;
    return Failure{Problem::bad_option,
                   option->get_name() +
                       " is not for --method follow, but for a Hough transform such as --method progressive"};
  }
  return options;
}

std::string method_of(const LineMapOptions& options) {
  return options.hough ? name_of(options.hough->method) : "follow";
}

std::string words_of(const LineMapOptions& o) {
  const auto number = [](const char* name, auto value) {
    return std::string(", ") + name + " " + io::to_text(value);
  };
  std::string words = "method " + method_of(o);
  if (o.hough) {
    words += number("seed", o.hough->seed) + number("window", o.hough->gradient_window * (180 / pi)) +
             " degrees" + number("threshold", o.hough->threshold);
  }
  return words + ", picture " + name_of(o.picture) + number("min-length", o.min_length) +
         number("max-gap", o.max_gap) + number("max-wall-width", o.max_wall_width) +
         number("furniture-size", o.furniture_size) + ", " + words_of(o.canny);
}

}  // namespace straightedge::cli
