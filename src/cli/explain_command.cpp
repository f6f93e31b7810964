// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "cli/detection_arguments.hpp"
#include "cli/explain_image.hpp"
#include "cli/map_source.hpp"
#include "cli/outputs.hpp"
#include "cli/picture_input.hpp"
#include "cli/program.hpp"
#include "cli/progress.hpp"
#include "cli/streams.hpp"

namespace straightedge::cli {
namespace {

namespace fs = std::filesystem;

struct ExplainArguments {
  CommonArguments common;
  DetectionArguments detection;
  std::string input;
  std::string folder;
};

std::string json_of(const ExplainArguments& arguments, const MapSource& source, const LineMapOptions& options,
                    Size size) {
  const nlohmann::ordered_json numbers = {{"program", version_text()},
                                          {"command", "explain"},
                                          {"input", base_name(source.picture)},
                                          {"width", size.width},
                                          {"height", size.height},
                                          {"options", words_of(options)},
                                          {"seed", options.hough.seed},
                                          {"page", (fs::path(arguments.folder) / "index.html").string()}};
  return numbers.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

Result<Done> explain(const ExplainArguments& arguments, const MapSource& source,
                     const LineMapOptions& options, GrayView gray) {
  const std::size_t pixels = static_cast<std::size_t>(gray.width) * static_cast<std::size_t>(gray.height);
  const std::size_t work = Canny::workspace_bytes(gray.size(), options.canny) +
                           HoughLines::workspace_bytes(gray.size(), options.hough);
  if (auto fits = check_memory(source.picture, work + 40 * pixels); !fits) return fits;
  const Progress progress(source.picture.string() + ": explaining", arguments.common.quiet);
  const auto done = explain_image(
      gray, {.lines = options, .input = base_name(source.picture), .version = STRAIGHTEDGE_VERSION},
      arguments.folder);
  // Sentences about outputs name their file themselves.
  if (done || done.failure().problem == Problem::cannot_write) return done;
  return Failure{done.failure().problem, source.picture.string() + ": " + done.failure().sentence};
}

Result<Done> run(const ExplainArguments& arguments) {
  if (arguments.folder.empty())
    return Failure{Problem::bad_option, "--output: the name of the folder is empty"};
  auto options = arguments.detection.options(arguments.common.seed);
  if (!options) return options.failure();
  const auto source = find_map_source(arguments.input);
  if (!source) return source.failure();
  options->meaning = source->meaning;
  const auto gray = read_picture(source->picture);
  if (!gray) return gray.failure();
  if (auto done = explain(arguments, *source, *options, *gray); !done) return done;
  if (!arguments.common.quiet) {
    print_words(source->picture.string() + ": explained; open " +
                (fs::path(arguments.folder) / "index.html").string());
  }
  return arguments.common.json ? write_stdout(json_of(arguments, *source, *options, gray->size())) : Done{};
}

}  // namespace

Command add_explain_command(CLI::App& program) {
  const auto arguments = std::make_shared<ExplainArguments>();
  CLI::App& command = *program.add_subcommand(
      "explain",
      "Every stage from a picture to its line map as a picture, with a page that tells what each shows");
  command
      .add_option("IMAGE|MAP.yaml", arguments->input,
                  "a picture, or the YAML file of a ROS map; - is standard input (a picture)")
      ->required();
  command
      .add_option("-o,--output", arguments->folder,
                  "where the pictures and index.html go; the folder is made when there is none")
      ->type_name("DIR")
      ->required();
  arguments->detection.add_to(command);
  add_common_options(command, arguments->common, "size, options and the name of the page");
  return {&command, [arguments] { return run(*arguments); }};
}

}  // namespace straightedge::cli
