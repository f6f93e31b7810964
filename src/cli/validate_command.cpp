// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "cli/command.hpp"
#include "cli/map_input.hpp"
#include "cli/outputs.hpp"
#include "cli/program.hpp"
#include "cli/streams.hpp"
#include "straightedge/host/map_file.hpp"
#include "straightedge/host/plane_map_file.hpp"

namespace straightedge::cli {
namespace {

struct ValidateArguments {
  CommonArguments common;
  std::string input;
};

/// All breaches but the last, which is the sentence of the failure.
Failure refuse(const std::vector<std::string>& breaches) {
  for (std::size_t i = 0; i + 1 < breaches.size(); ++i) print_words("straightedge: " + one_line(breaches[i]));
  return {Problem::bad_content, breaches.back()};
}

Result<Done> run(const ValidateArguments& arguments) {
  const std::filesystem::path file = arguments.input;
  const auto kind = map_kind(file);
  if (!kind) return kind.failure();
  const auto breaches = *kind == MapKind::lines ? validate_line_map(file) : validate_plane_map(file);
  if (!breaches) return breaches.failure();
  if (!breaches->empty()) return refuse(*breaches);
  const auto map = read_any_map(file);
  if (!map) return map.failure();
  if (!arguments.common.quiet) print_words(file.string() + ": valid, " + words_of(*map));
  if (!arguments.common.json) return Done{};
  nlohmann::ordered_json numbers = {{"program", version_text()},
                                    {"command", "validate"},
                                    {"input", base_name(file)},
                                    {"seed", arguments.common.seed},
                                    {"valid", true}};
  add_counts(numbers, *map);
  return write_stdout(numbers.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

}  // namespace

Command add_validate_command(CLI::App& program) {
  const auto arguments = std::make_shared<ValidateArguments>();
  CLI::App& command = *program.add_subcommand(
      "validate",
      "Checks a line map or a plane map against every rule of its format; a line on stderr for each breach");
  command.add_option("MAP.xml", arguments->input, "the map")->required();
  add_common_options(command, arguments->common, "lines and segments in the map, or planes and polygons");
  return {&command, [arguments] { return run(*arguments); }};
}

}  // namespace straightedge::cli
