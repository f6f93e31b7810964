// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "cli/command.hpp"
#include "cli/map_input.hpp"
#include "cli/number_option.hpp"
#include "cli/outputs.hpp"
#include "cli/program.hpp"
#include "cli/streams.hpp"
#include "straightedge/host/plane_view.hpp"
#include "straightedge/host/ply.hpp"
#include "straightedge/host/svg.hpp"

namespace straightedge::cli {
namespace {

namespace fs = std::filesystem;

struct ShowArguments {
  CommonArguments common;
  std::string input;
  std::string output;
  UpAxis up = UpAxis::automatic;
  CLI::Option* up_option = nullptr;
};

/// Standard output gets an SVG.
std::string ending_of(const std::string& output) {
  const std::string ending = lower_case(fs::path(output).extension().string());
  return ending == ".html" || ending == ".ply" ? ending : ".svg";
}

Result<Done> report(const ShowArguments& arguments, const fs::path& file, const AnyMap& map,
                    const std::vector<Output>& outputs) {
  if (!arguments.common.quiet)
    print_words(file.string() + ": " + words_of(map) + "; written: " + names_of(outputs));
  if (!arguments.common.json) return Done{};
  nlohmann::ordered_json numbers = {{"program", version_text()},
                                    {"command", "show"},
                                    {"input", base_name(file)},
                                    {"seed", arguments.common.seed}};
  add_counts(numbers, map);
  return write_stdout(numbers.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

Result<Done> draw(const LineMap& map, const ShowArguments& arguments, Output& output) {
  if (output.extension != ".svg")
    return Failure{Problem::bad_option, "a map of lines is drawn as .svg, not as " + output.extension};
  if (arguments.up_option->count() > 0)
    return Failure{Problem::bad_option, "a map of lines is flat; leave --up out"};
  auto svg = line_map_to_svg(map);
  if (!svg) return svg.failure();
  output.bytes = std::move(*svg);
  return Done{};
}

Result<Done> draw(const PlaneMap& map, const ShowArguments& arguments, Output& output) {
  if (output.extension == ".ply") {
    output.write = [&map](const fs::path& file) { return write_polygons_ply(file, map); };
  } else if (output.extension == ".html") {
    output.bytes = plane_map_html(map, {.title = {}, .up = arguments.up, .camera_path = {}, .points = {}});
  } else {
    output.bytes = plane_map_svg(map, {.title = {}, .up = arguments.up, .camera_path = {}});
  }
  return Done{};
}

Result<Done> run(const ShowArguments& arguments) {
  const fs::path file = input_path(arguments.input);
  std::vector<Output> outputs = {{"--output", arguments.output, ending_of(arguments.output), {}}};
  if (auto fine = check_outputs(outputs, {file}, arguments.common.json); !fine) return fine;
  const auto map = read_any_map(file);
  if (!map) return map.failure();
  const auto drawn = std::visit([&](const auto& any) { return draw(any, arguments, outputs[0]); }, *map);
  if (!drawn) return Failure{drawn.failure().problem, file.string() + ": " + drawn.failure().sentence};
  if (auto written = write_outputs(outputs); !written) return written;
  return report(arguments, file, *map, outputs);
}

}  // namespace

Command add_show_command(CLI::App& program) {
  const auto arguments = std::make_shared<ShowArguments>();
  CLI::App& command = *program.add_subcommand("show", "A drawing of a line map or a plane map");
  command.add_option("MAP.xml", arguments->input, "the map; - is standard input")->required();
  command
      .add_option(
          "-o,--output", arguments->output,
          "where the drawing goes: an SVG, or of a plane map also a page on which it can be turned or "
          "the planes' extents as triangles; - is standard output (an SVG)")
      ->type_name("OUT.svg|OUT.html|OUT.ply")
      ->required();
  arguments->up_option = add_choice(
      command, "--up", arguments->up,
      {{"auto", UpAxis::automatic}, {"z", UpAxis::z}, {"y", UpAxis::y}, {"-y", UpAxis::minus_y}},
      "which axis of a plane map points up; auto: -y for what one camera at the origin sees, else z");
  add_common_options(command, arguments->common, "lines and segments in the map, or planes and polygons");
  return {&command, [arguments] { return run(*arguments); }};
}

}  // namespace straightedge::cli
