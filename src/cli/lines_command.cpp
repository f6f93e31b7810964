// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "cli/created_time.hpp"
#include "cli/lines_arguments.hpp"
#include "cli/lines_report.hpp"
#include "cli/map_source.hpp"
#include "cli/picture_input.hpp"
#include "cli/png_text.hpp"
#include "cli/program.hpp"
#include "cli/progress.hpp"
#include "cli/streams.hpp"
#include "straightedge/host/csv.hpp"
#include "straightedge/host/draw.hpp"
#include "straightedge/host/image_file.hpp"
#include "straightedge/host/kernels.hpp"
#include "straightedge/host/map_file.hpp"
#include "straightedge/host/svg.hpp"

namespace straightedge::cli {
namespace {

namespace fs = std::filesystem;

Image<std::uint8_t> negative(GrayView gray) {
  Image<std::uint8_t> turned(gray.size());
  for (std::int32_t y = 0; y < gray.height; ++y) {
    for (std::int32_t x = 0; x < gray.width; ++x)
      turned.at(x, y) = static_cast<std::uint8_t>(255 - gray.at(x, y));
  }
  return turned;
}

Result<LineMapResult> build(const fs::path& file, GrayView gray, const LineMapOptions& options, bool negate,
                            bool quiet) {
  const std::size_t pixels = static_cast<std::size_t>(gray.width) * static_cast<std::size_t>(gray.height);
  const std::size_t edges = Canny::workspace_bytes(gray.size(), options.canny);
  const std::size_t hough = options.hough ? HoughLines::workspace_bytes(gray.size(), *options.hough) : 0;
  if (auto fits = check_memory(file, edges + hough + 8 * pixels); !fits) return fits.failure();
  const Progress progress(file.string() + ": making the line map", quiet);
  const auto kernels = kernels_from_environment();
  if (!kernels) return kernels.failure();
  auto built =
      negate ? build_line_map(negative(gray), options, *kernels) : build_line_map(gray, options, *kernels);
  if (built) return built;
  return Failure{built.failure().problem, file.string() + ": " + built.failure().sentence};
}

void describe(LineMap& map, const LinesArguments& arguments, const MapSource& source,
              const LineMapOptions& options) {
  map.meta.name = arguments.name.empty() ? input_path(arguments.input).stem().string() : arguments.name;
  map.meta.description = arguments.description;
  map.meta.created = created_time(arguments.created);
  map.meta.tool = version_text();
  map.meta.options =
      words_of(options) + (arguments.negate ? ", negate" : "") + (arguments.fast ? ", fast" : "");
  if (!map.image) return;
  map.image->file = base_name(source.picture);
  map.image->placement = source.placement;
}

Result<std::string> overlay_png(GrayView gray, const LineMap& map, const fs::path& file) {
  const auto drawn = draw_line_map(gray, map);
  if (!drawn) return drawn.failure();
  auto png = encode_png(*drawn);
  if (!png) return png;
  return with_png_text(*png, map.meta.tool + " lines; " + map.meta.options + "; of " + base_name(file));
}

Result<Done> fill(std::vector<Output>& outputs, GrayView gray, const LineMap& map, const fs::path& file) {
  for (Output& output : outputs) {
    const auto bytes = [&]() -> Result<std::string> {
      if (output.extension == ".xml") return line_map_to_xml(map);
      if (output.extension == ".svg") return line_map_to_svg(map, {.picture = gray});
      if (output.extension == ".png") return overlay_png(gray, map, file);
      return line_map_to_csv(map);
    }();
    if (!bytes) return Failure{bytes.failure().problem, file.string() + ": " + bytes.failure().sentence};
    output.bytes = *bytes;
  }
  return Done{};
}

std::string json_of(const LineMapResult& built, const LinesArguments& arguments,
                    const LineMapOptions& options) {
  const LineMapReport& report = built.report;
  const Size size = built.map.image ? built.map.image->size : Size{};
  const nlohmann::ordered_json numbers = {{"program", version_text()},
                                          {"command", "lines"},
                                          {"input", base_name(input_path(arguments.input))},
                                          {"width", size.width},
                                          {"height", size.height},
                                          {"options", built.map.meta.options},
                                          {"method", method_of(options)},
                                          {"seed", arguments.common.seed},
                                          {"picture", kind_of(report)},
                                          {"low", report.canny.low},
                                          {"high", report.canny.high},
                                          {"edge_pixels", report.canny.edges},
                                          {"rounds", report.rounds},
                                          {"candidates", report.candidates},
                                          {"straight_edges", report.edges},
                                          {"thin_walls", report.walls},
                                          {"merged", report.merged},
                                          {"dropped_no_wall", report.no_wall},
                                          {"dropped_furniture", report.furniture},
                                          {"dropped_too_short", report.too_short},
                                          {"lines", report.lines},
                                          {"segments", report.segments}};
  return numbers.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

Result<LineMap> in_asked_unit(const LineMap& map, const fs::path& file, bool metres) {
  if (!metres) return map;
  auto turned = to_metres(map);
  if (turned) return turned;
  return Failure{turned.failure().problem, file.string() + ": " + turned.failure().sentence};
}

Result<Done> run(const LinesArguments& arguments) {
  auto options = arguments.options();
  if (!options) return options.failure();
  auto source = find_map_source(arguments.input);
  if (!source) return source.failure();
  if (arguments.has_placement()) source->placement = arguments.placement;
  std::vector<Output> outputs = arguments.outputs();
  const fs::path input = input_path(arguments.input);
  if (auto fine = check_outputs(outputs, {input, source->picture}, arguments.common.json); !fine) return fine;
  const auto gray = read_picture(source->picture);
  if (!gray) return gray.failure();
  options->meaning = source->meaning;
  auto built = build(source->picture, *gray, *options, arguments.negate, arguments.common.quiet);
  if (!built) return built.failure();
  describe(built->map, arguments, *source, *options);
  const auto map = in_asked_unit(built->map, source->picture, arguments.metres);
  if (!map) return map.failure();
  if (auto filled = fill(outputs, *gray, *map, source->picture); !filled) return filled;
  if (auto written = write_outputs(outputs); !written) return written;
  if (!arguments.common.quiet) {
    print_words(input.string() + "\n" + words_of(built->report, gray->size()) + "\n  written   " +
                names_of(outputs));
  }
  return arguments.common.json ? write_stdout(json_of(*built, arguments, *options)) : Done{};
}

}  // namespace

Command add_lines_command(CLI::App& program) {
  const auto arguments = std::make_shared<LinesArguments>();
  CLI::App& command = *program.add_subcommand(
      "lines",
      "The whole way from a picture to its line map: edges, straight edges, sub-pixel refinement, merging.\n"
      "Angles are degrees here and radians in the files");
  arguments->add_to(command);
  add_common_options(command, arguments->common,
                     "size, what the picture was taken for, and the counts of every stage");
  return {&command, [arguments] { return run(*arguments); }};
}

}  // namespace straightedge::cli
