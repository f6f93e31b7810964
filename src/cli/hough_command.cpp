// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "cli/command.hpp"
#include "cli/hough_arguments.hpp"
#include "cli/outputs.hpp"
#include "cli/picture_input.hpp"
#include "cli/program.hpp"
#include "cli/progress.hpp"
#include "cli/raw_lines.hpp"
#include "cli/streams.hpp"
#include "io/number_text.hpp"
#include "straightedge/host/kernels.hpp"

namespace straightedge::cli {
namespace {

struct RawHoughArguments {
  CommonArguments common;
  HoughArguments hough;
  std::string input;
  std::string csv;
};

std::size_t count_of(const RawLines& found) {
  return found.peaks.size() + found.segments.size();
}

std::string json_of(const std::filesystem::path& file, Size size, const RawLines& found,
                    const HoughOptions& options) {
  const bool standard = options.method == HoughMethod::standard;
  const nlohmann::ordered_json numbers = {{"program", version_text()},
                                          {"command", "hough"},
                                          {"input", base_name(file)},
                                          {"width", size.width},
                                          {"height", size.height},
                                          {"options", words_of(options)},
                                          {"method", name_of(options.method)},
                                          {"seed", options.seed},
                                          {"edge_pixels", found.result.edge_pixels},
                                          {"draws", found.result.draws},
                                          {"confident", found.result.confident},
                                          {standard ? "lines" : "segments", count_of(found)}};
  return numbers.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string summary(const std::filesystem::path& file, const RawLines& found, const HoughOptions& options) {
  const bool standard = options.method == HoughMethod::standard;
  std::string words = file.string() + ": " + io::to_text(found.result.edge_pixels) + " edge pixels, " +
                      io::to_text(count_of(found)) + (standard ? " lines" : " segments") + " by the " +
                      name_of(options.method) + " method";
  if (!found.result.confident) words += "; --max-draws ended the search before its --confidence";
  return words;
}

Result<Done> run(const RawHoughArguments& arguments) {
  if (auto fine = arguments.hough.check(); !fine) return fine;
  HoughOptions options = arguments.hough.options;
  options.seed = arguments.common.seed;
  const auto kernels = kernels_from_environment();
  if (!kernels) return kernels.failure();
  options.kernels = kernels->hough;
  const std::filesystem::path file = input_path(arguments.input);
  std::vector<Output> outputs;
  if (!arguments.csv.empty()) outputs.push_back({"--csv", arguments.csv, ".csv", {}});
  if (auto fine = check_outputs(outputs, {file}, arguments.common.json); !fine) return fine;
  if (outputs.empty() && !arguments.common.json) outputs.push_back({"--csv", "-", ".csv", {}});
  const auto edges = read_picture(file);
  if (!edges) return edges.failure();
  const auto found = [&] {
    const Progress progress(file.string() + ": finding lines", arguments.common.quiet);
    return find_raw_lines(file, *edges, options);
  }();
  if (!found) return found.failure();
  if (!outputs.empty()) outputs[0].bytes = csv_of(*found, options.method);
  if (auto written = write_outputs(outputs); !written) return written;
  if (!arguments.common.quiet) {
    print_words(summary(file, *found, options) + (outputs.empty() ? "" : "; written: " + names_of(outputs)));
  }
  return arguments.common.json ? write_stdout(json_of(file, edges->size(), *found, options)) : Done{};
}

}  // namespace

Command add_hough_command(CLI::App& program) {
  const auto arguments = std::make_shared<RawHoughArguments>();
  CLI::App& command = *program.add_subcommand(
      "hough",
      "The raw Hough transform of a binary image, in OpenCV's pixel frame and units (theta in radians):\n"
      "origin at the centre of the first pixel, y down");
  command.add_option("IMAGE", arguments->input, "every pixel that is not 0 is an edge; - is standard input")
      ->required();
  command
      .add_option(
          "--csv", arguments->csv,
          "where the lines go: x0,y0,x1,y1,votes in the order of discovery, standard: rho,theta,votes; "
          "- is standard output, which is also where they go without this option (with --json: nowhere)")
      ->type_name("LINES.csv")
      ->default_str("-");
  arguments->hough.add_to(command);
  add_common_options(command, arguments->common,
                     "size, edge pixels, draws, whether the search is confident, lines or segments found");
  return {&command, [arguments] { return run(*arguments); }};
}

}  // namespace straightedge::cli
