// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <string>

#include "straightedge/host/result.hpp"

namespace straightedge::cli {

/// What every sub-command takes.
struct CommonArguments {
  std::uint64_t seed = 1;
  bool quiet = false;
  bool json = false;
};

/// A sub-command: its options, and what it does once they are read.
struct Command {
  CLI::App* app = nullptr;
  std::function<Result<Done>()> run;
};

Command add_edges_command(CLI::App& program);
Command add_explain_command(CLI::App& program);
Command add_hough_command(CLI::App& program);
Command add_lines_command(CLI::App& program);
Command add_localize_command(CLI::App& program);
Command add_merge_command(CLI::App& program);
Command add_planes_command(CLI::App& program);
Command add_show_command(CLI::App& program);
Command add_validate_command(CLI::App& program);

/// --seed, --quiet, --json, --version, and the exit codes below the help. `json_help` says what the numbers
/// of --json are.
void add_common_options(CLI::App& command, CommonArguments& common, const std::string& json_help);

}  // namespace straightedge::cli
