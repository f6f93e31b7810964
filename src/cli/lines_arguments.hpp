// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "cli/canny_arguments.hpp"
#include "cli/command.hpp"
#include "cli/outputs.hpp"
#include "straightedge/host/line_map_builder.hpp"

namespace straightedge::cli {

/// What `lines` is told. The object must stay where it is until the arguments are parsed.
struct LinesArguments {
  CommonArguments common;
  std::string input;
  LineMapOptions map;  ///< all but what `canny` and `common` know
  CannyArguments canny{LineMapOptions{}.canny};
  bool negate = false;
  bool metres = false;
  MapPlacement placement;
  std::string name, description, created;

  void add_to(CLI::App& command);

  /// The input is the YAML file of a ROS map.
  bool is_ros_map() const;
  /// --resolution was given.
  bool has_placement() const { return resolution->count() > 0; }
  /// All files that were asked for: the map, then --svg, --png, --csv.
  std::vector<Output> outputs() const;
  /// Fails with `bad_option` where options contradict each other or the kind of input.
  Result<LineMapOptions> options() const;

 private:
  void add_outputs(CLI::App& command);
  void add_map(CLI::App& command);
  void add_detection(CLI::App& command);
  Result<Done> check() const;

  std::string xml, svg, png, csv;
  CLI::Option* resolution = nullptr;
  CLI::Option* origin = nullptr;
};

/// The effective options in words, seed included.
std::string words_of(const LineMapOptions& options);

}  // namespace straightedge::cli
