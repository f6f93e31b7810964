// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <memory>

#include "cli/created_time.hpp"
#include "cli/planes_arguments.hpp"
#include "cli/planes_cloud.hpp"
#include "cli/planes_outputs.hpp"
#include "cli/planes_report.hpp"
#include "cli/planes_run.hpp"
#include "cli/planes_source.hpp"
#include "cli/program.hpp"
#include "cli/streams.hpp"

namespace straightedge::cli {
namespace {

namespace fs = std::filesystem;

void describe(PlanesRun& run, const PlanesArguments& arguments) {
  for (MethodRun& method : run.methods) {
    MapMeta& meta = method.reading.map.meta;
    meta.name = arguments.name.empty() ? fs::path(arguments.input_name()).stem().string() : arguments.name;
    meta.description = arguments.description;
    meta.created = created_time(arguments.created);
    meta.tool = version_text();
    meta.options = arguments.words(method.method, run.scale);
  }
}

std::vector<fs::path> inputs_of(const PlanesArguments& arguments, const DepthSequence& sequence) {
  std::vector<fs::path> inputs = {arguments.input};
  for (const std::string& given : {arguments.camera, arguments.trajectory}) {
    if (!given.empty()) inputs.emplace_back(given);
  }
  for (const SequenceFrame& frame : sequence.frames) inputs.push_back(frame.file);
  return inputs;
}

/// A cloud is a sequence of one frame to all but the search itself.
Result<DepthSequence> open_source(const PlanesArguments& arguments) {
  if (!arguments.is_cloud()) return open_depth_source(arguments);
  return DepthSequence{};
}

Result<Done> run(const PlanesArguments& arguments) {
  if (auto fine = arguments.check(); !fine) return fine;
  const auto sequence = open_source(arguments);
  if (!sequence) return sequence.failure();
  PlanesOutputs outputs(arguments);
  if (auto fine = outputs.check(inputs_of(arguments, *sequence), sequence->frames); !fine) return fine;
  auto made = [&] {
    Progress progress(arguments.input, arguments.common.quiet);
    return arguments.is_cloud() ? run_cloud(arguments, arguments.input)
                                : run_planes(arguments, *sequence, progress);
  }();
  if (!made) return made.failure();
  describe(*made, arguments);
  if (auto filled = outputs.fill(*made); !filled) return filled;
  if (auto written = outputs.write(); !written) return written;
  if (!arguments.common.quiet) print_words(words_of(*made, arguments, outputs.names()));
  return arguments.common.json ? write_stdout(json_of(*made, arguments)) : Done{};
}

}  // namespace

Command add_planes_command(CLI::App& program) {
  const auto arguments = std::make_shared<PlanesArguments>();
  CLI::App& command = *program.add_subcommand(
      "planes",
      "From depth frames with poses to one map of planes: planes of each frame, by RANSAC or by a Hough\n"
      "transform, registered into one world");
  arguments->add_to(command);
  add_common_options(command, arguments->common, "counts, options, the planes of every frame and of the map");
  return {&command, [arguments] { return run(*arguments); }};
}

}  // namespace straightedge::cli
