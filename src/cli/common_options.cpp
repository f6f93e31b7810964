// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/command.hpp"
#include "cli/number_option.hpp"
#include "cli/program.hpp"

namespace straightedge::cli {

void add_common_options(CLI::App& command, CommonArguments& common, const std::string& json_help) {
  command.footer(exit_codes_text);
  add_whole(command, "--seed", common.seed, {0, max_seed}, "N",
            "where chance starts; the same seed gives the same result");
  command.add_flag("--quiet", common.quiet, "no words on stderr but those of a failure");
  command.add_flag("--json", common.json, "one JSON object on stdout: " + json_help);
  command.set_version_flag("--version", version_text(), "print the version and leave");
}

}  // namespace straightedge::cli
