// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "cli/canny_arguments.hpp"
#include "cli/command.hpp"
#include "cli/outputs.hpp"
#include "cli/picture_input.hpp"
#include "cli/png_text.hpp"
#include "cli/program.hpp"
#include "cli/progress.hpp"
#include "cli/streams.hpp"
#include "cli/threads_option.hpp"
#include "io/number_text.hpp"
#include "straightedge/host/canny.hpp"
#include "straightedge/host/image_file.hpp"
#include "straightedge/host/kernels.hpp"

namespace straightedge::cli {
namespace {

struct EdgesArguments {
  CommonArguments common;
  CannyArguments canny{CannyOptions{}};
  std::int32_t threads = 1;
  std::string input;
  std::string output;
};

Result<CannyEdges> find_edges(const std::filesystem::path& file, GrayView gray,
                              const EdgesArguments& arguments, const CannyOptions& options) {
  const auto kernels = kernels_from_environment();
  if (!kernels) return kernels.failure();
  const std::size_t pixels = static_cast<std::size_t>(gray.width) * static_cast<std::size_t>(gray.height);
  const auto fits = check_memory(file, Canny::workspace_bytes(gray.size(), options) + 3 * pixels);
  if (!fits) return fits.failure();
  const Progress progress(file.string() + ": finding edges", arguments.common.quiet);
  CannyEdges found = canny(gray, options, *kernels, static_cast<unsigned>(arguments.threads));
  if (found.result.status == Status::ok) return found;
  return Failure{Problem::internal, file.string() + ": " + to_string(found.result.status)};
}

std::string json_of(const std::filesystem::path& file, const CannyEdges& found, const CannyOptions& options,
                    std::uint64_t seed) {
  const nlohmann::ordered_json numbers = {{"program", version_text()},
                                          {"command", "edges"},
                                          {"input", base_name(file)},
                                          {"width", found.edges.width()},
                                          {"height", found.edges.height()},
                                          {"options", words_of(options)},
                                          {"seed", seed},
                                          {"low", found.result.low},
                                          {"high", found.result.high},
                                          {"strong", found.result.strong},
                                          {"edges", found.result.edges}};
  return numbers.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string summary(const std::filesystem::path& file, const CannyEdges& found, const std::string& where) {
  return file.string() + ": " + io::to_text(found.edges.width()) + " x " + io::to_text(found.edges.height()) +
         " pixels, " + io::to_text(found.result.edges) + " of them edges (low " +
         io::to_text(found.result.low) + ", high " + io::to_text(found.result.high) + "; kernels " +
         std::string(found.kernels) + "); written: " + where;
}

Result<Done> run(const EdgesArguments& arguments) {
  const auto options = arguments.canny.options();
  if (!options) return options.failure();
  const std::filesystem::path file = input_path(arguments.input);
  std::vector<Output> outputs = {{"--output", arguments.output, ".png", {}}};
  if (auto fine = check_outputs(outputs, {file}, arguments.common.json); !fine) return fine;
  const auto gray = read_picture(file);
  if (!gray) return gray.failure();
  const auto found = find_edges(file, *gray, arguments, *options);
  if (!found) return found.failure();
  const auto png = encode_png(found->edges);
  if (!png) return png.failure();
  outputs[0].bytes =
      with_png_text(*png, version_text() + " edges; " + words_of(*options) + "; of " + base_name(file));
  if (auto written = write_outputs(outputs); !written) return written;
  if (!arguments.common.quiet) print_words(summary(file, *found, names_of(outputs)));
  if (!arguments.common.json) return Done{};
  return write_stdout(json_of(file, *found, *options, arguments.common.seed));
}

}  // namespace

Command add_edges_command(CLI::App& program) {
  const auto arguments = std::make_shared<EdgesArguments>();
  CLI::App& command = *program.add_subcommand("edges", "Canny's edge detector: a picture in, its edges out");
  command.add_option("IMAGE", arguments->input, "PNG, JPEG, BMP, TGA, PGM or PPM; - is standard input")
      ->required();
  command
      .add_option("-o,--output", arguments->output,
                  "where the edges go: a PNG, 255 on edges, 0 elsewhere; - is standard output")
      ->type_name("EDGES.png")
      ->required();
  arguments->canny.add_to(command);
  add_threads(command, arguments->threads);
  add_common_options(command, arguments->common,
                     "size, thresholds used, pixels that are strong, pixels that are edges");
  return {&command, [arguments] { return run(*arguments); }};
}

}  // namespace straightedge::cli
