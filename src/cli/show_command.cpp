// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "cli/command.hpp"
#include "cli/outputs.hpp"
#include "cli/program.hpp"
#include "cli/streams.hpp"
#include "io/number_text.hpp"
#include "straightedge/host/map_file.hpp"
#include "straightedge/host/svg.hpp"

namespace straightedge::cli {
namespace {

struct ShowArguments {
  CommonArguments common;
  std::string input;
  std::string output;
};

std::size_t count_segments(const LineMap& map) {
  std::size_t segments = 0;
  for (const MapLine& line : map.lines) segments += line.segments.size();
  return segments;
}

Result<Done> report(const ShowArguments& arguments, const std::filesystem::path& file, const LineMap& map,
                    const std::vector<Output>& outputs) {
  const std::size_t segments = count_segments(map);
  if (!arguments.common.quiet) {
    print_words(file.string() + ": " + io::to_text(map.lines.size()) + " lines, " + io::to_text(segments) +
                " segments; written: " + names_of(outputs));
  }
  if (!arguments.common.json) return Done{};
  const nlohmann::ordered_json numbers = {{"program", version_text()}, {"command", "show"},
                                          {"input", base_name(file)},  {"seed", arguments.common.seed},
                                          {"lines", map.lines.size()}, {"segments", segments}};
  return write_stdout(numbers.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

Result<Done> run(const ShowArguments& arguments) {
  const std::filesystem::path file = input_path(arguments.input);
  std::vector<Output> outputs = {{"--output", arguments.output, ".svg", {}}};
  if (auto fine = check_outputs(outputs, {file}, arguments.common.json); !fine) return fine;
  const auto map = read_line_map(file);
  if (!map) return map.failure();
  const auto svg = line_map_to_svg(*map);
  if (!svg) return Failure{svg.failure().problem, file.string() + ": " + svg.failure().sentence};
  outputs[0].bytes = *svg;
  if (auto written = write_outputs(outputs); !written) return written;
  return report(arguments, file, *map, outputs);
}

}  // namespace

Command add_show_command(CLI::App& program) {
  const auto arguments = std::make_shared<ShowArguments>();
  CLI::App& command = *program.add_subcommand("show", "A drawing of a line map");
  command.add_option("MAP.xml", arguments->input, "the line map; - is standard input")->required();
  command.add_option("-o,--output", arguments->output, "where the drawing goes; - is standard output")
      ->type_name("OUT.svg")
      ->required();
  add_common_options(command, arguments->common, "lines and segments in the map");
  return {&command, [arguments] { return run(*arguments); }};
}

}  // namespace straightedge::cli
