// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <memory>

#include "cli/localize_explain.hpp"
#include "cli/localize_outputs.hpp"
#include "cli/outputs.hpp"
#include "cli/streams.hpp"
#include "straightedge/host/map_file.hpp"

namespace straightedge::cli {
namespace {

namespace fs = std::filesystem;

Failure about(const std::string& name, const Failure& failure) {
  return {failure.problem, name + ": " + failure.sentence};
}

/// The map in metres, with walls to localize by.
Result<LineMap> read_metre_map(const LocalizeArguments& arguments) {
  const auto map = read_line_map(input_path(arguments.map));
  if (!map) return map.failure();
  const auto metres = to_metres(*map);
  if (!metres) return about(arguments.map, metres.failure());
  for (const MapLine& line : metres->lines) {
    if (!line.segments.empty()) return metres;
  }
  return Failure{Problem::bad_content, arguments.map + ": holds no line to localize by"};
}

Result<LaserLog> read_log(const LocalizeArguments& arguments) {
  auto log = read_laser_log(input_path(arguments.scans));
  if (!log) return log;
  if (auto applied = arguments.apply_to(*log); !applied) return applied.failure();
  if (arguments.explain_scan > log->scans.size())
    return Failure{Problem::bad_option, "--explain-scan: " + arguments.scans + " has no scan of that number"};
  return log;
}

Result<std::vector<TimedPose2>> read_truth(const LocalizeArguments& arguments) {
  if (arguments.truth.empty()) return std::vector<TimedPose2>{};
  return read_planar_trajectory(arguments.truth);
}

LocalizeStory tell(const LocalizeArguments& arguments, const LineMap& map, const LaserLog& log,
                   const LocalizeRun& run, std::vector<TimedPose2> truth) {
  LocalizeStory story{arguments, map, log, run, std::move(truth), odometry_alone(run, log), {}, {}};
  if (arguments.truth.empty()) return story;
  story.errors = compare_poses(run.poses, story.truth, true);
  if (!story.odometry.empty()) story.odometry_errors = compare_poses(story.odometry, story.truth, false);
  return story;
}

Result<Done> run(const LocalizeArguments& arguments) {
  if (auto fine = arguments.check(); !fine) return fine;
  LocalizeOutputs outputs(arguments);
  if (auto fine = outputs.check(); !fine) return fine;
  const auto map = read_metre_map(arguments);
  if (!map) return map.failure();
  const auto log = read_log(arguments);
  if (!log) return log.failure();
  auto truth = read_truth(arguments);
  if (!truth) return truth.failure();
  LocalizeRunOptions options{arguments.options(), !arguments.svg.empty(), {}};
  if (!arguments.explain.empty()) options.explain_scan = arguments.explain_scan;
  const auto made = [&] {
    Progress progress(arguments.scans, arguments.common.quiet);
    return run_localize(*map, *log, options, progress);
  }();
  if (!made) return about(arguments.map, made.failure());
  const LocalizeStory story = tell(arguments, *map, *log, *made, std::move(*truth));
  if (auto filled = outputs.fill(story); !filled) return filled;
  if (auto written = outputs.write(); !written) return written;
  if (!arguments.common.quiet) print_words(words_of(story, outputs.names()));
  return arguments.common.json ? write_stdout(json_of(story)) : Done{};
}

}  // namespace

Command add_localize_command(CLI::App& program) {
  const auto arguments = std::make_shared<LocalizeArguments>();
  CLI::App& command = *program.add_subcommand(
      "localize", "Where a robot is in a line map, by the lines that its laser scanner sees");
  arguments->add_to(command);
  add_common_options(
      command, arguments->common,
      "poses, where it was found and lost, matched and refused lines, and with --truth the errors");
  return {&command, [arguments] { return run(*arguments); }};
}

}  // namespace straightedge::cli
