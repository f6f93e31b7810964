// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/detection_arguments.hpp"
#include "cli/outputs.hpp"

namespace straightedge::cli {

/// What `lines` is told. The object must stay where it is until the arguments are parsed.
struct LinesArguments {
  CommonArguments common;
  std::string input;
  DetectionArguments detection;
  bool negate = false;
  bool fast = false;
  bool metres = false;
  MapPlacement placement;
  std::string name, description, created;

  void add_to(CLI::App& command);

  /// --resolution was given.
  bool has_placement() const { return resolution->count() > 0; }
  /// All files that were asked for: the map, then --svg, --png, --csv.
  std::vector<Output> outputs() const;
  /// Fails with `bad_option` where options contradict each other or the kind of input.
  Result<LineMapOptions> options() const;

 private:
  void add_outputs(CLI::App& command);
  void add_map(CLI::App& command);
  Result<Done> check() const;

  std::string xml, svg, png, csv;
  CLI::Option* resolution = nullptr;
  CLI::Option* origin = nullptr;
};

}  // namespace straightedge::cli
