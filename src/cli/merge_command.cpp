// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "cli/command.hpp"
#include "cli/number_option.hpp"
#include "cli/outputs.hpp"
#include "cli/program.hpp"
#include "cli/streams.hpp"
#include "io/number_text.hpp"
#include "straightedge/host/plane_leaves_file.hpp"
#include "straightedge/host/plane_map_builder.hpp"
#include "straightedge/host/plane_map_file.hpp"
#include "straightedge/host/plane_map_merge.hpp"

namespace straightedge::cli {
namespace {

namespace fs = std::filesystem;

struct MergeArguments {
  CommonArguments common;
  std::vector<std::string> maps, leaves;
  std::string output, leaves_output, name, description;
  std::uint64_t min_points = PlaneMapOptions{}.min_points;
  CLI::Option* min_points_option = nullptr;
};

struct Merged {
  PlaneMap map;
  std::string leaves;      ///< bytes; empty when there were none
  std::size_t planes = 0;  ///< of all inputs
};

Result<Done> check(const MergeArguments& arguments) {
  const auto refuse = [](const std::string& sentence) { return Failure{Problem::bad_option, sentence}; };
  if (arguments.maps.size() < 2) return refuse(arguments.maps.front() + ": merging needs two maps or more");
  const bool exact = !arguments.leaves.empty();
  if (exact && arguments.leaves.size() != arguments.maps.size())
    return refuse("--leaves: " + io::to_text(arguments.leaves.size()) + " files for " +
                  io::to_text(arguments.maps.size()) + " maps; every map needs its own");
  if (!exact && !arguments.leaves_output.empty()) return refuse("--leaves-output needs --leaves");
  if (!exact && arguments.min_points_option->count() > 0) return refuse("--min-points needs --leaves");
  return Done{};
}

Result<std::vector<PlaneMap>> read_maps(const std::vector<std::string>& files) {
  std::vector<PlaneMap> maps;
  for (const std::string& file : files) {
    const auto kind = map_kind(file);
    if (!kind) return kind.failure();
    if (*kind == MapKind::lines)
      return Failure{Problem::bad_content, file + ": is a map of lines; only maps of planes can be merged"};
    auto map = read_plane_map(file);
    if (!map) return map.failure();
    maps.push_back(std::move(*map));
  }
  return maps;
}

/// "hough", or "hough+ransac" where the maps' planes came by both.
std::string sources_of(const std::vector<PlaneMap>& maps) {
  std::set<std::string> sources;
  for (const PlaneMap& map : maps) {
    for (const MapPlane& plane : map.planes) {
      if (plane.source) sources.insert(*plane.source);
    }
  }
  std::string text;
  for (const std::string& source : sources) text += (text.empty() ? "" : "+") + source;
  return text;
}

Result<Merged> merge_leaves(const MergeArguments& arguments, const std::vector<PlaneMap>& maps) {
  PlaneMapOptions options;
  options.min_points = arguments.min_points;
  PlaneMapBuilder builder(options);
  for (const std::string& file : arguments.leaves) {
    const auto leaves = read_plane_leaves(file);
    if (!leaves) return leaves.failure();
    if (auto added = builder.merge(*leaves); !added)
      return Failure{added.failure().problem, file + ": " + added.failure().sentence};
  }
  auto reading = builder.build();
  if (!reading) return reading.failure();
  if (const std::string sources = sources_of(maps); !sources.empty()) {
    for (MapPlane& plane : reading->map.planes) plane.source = sources;
  }
  return Merged{std::move(reading->map), plane_leaves_to_bytes(builder.leaves()), 0};
}

Result<Merged> merge_moments(const MergeArguments& arguments, std::vector<PlaneMap>& maps) {
  PlaneMap whole = maps.front();
  for (std::size_t i = 1; i < maps.size(); ++i) {
    auto both = merge_plane_maps(whole, maps[i]);
    if (!both) return Failure{both.failure().problem, arguments.maps[i] + ": " + both.failure().sentence};
    whole = std::move(*both);
  }
  return Merged{std::move(whole), {}, 0};
}

void describe(PlaneMap& map, const MergeArguments& arguments) {
  map.meta = {};
  map.meta.name = arguments.name.empty() ? fs::path(arguments.maps.front()).stem().string() : arguments.name;
  map.meta.description = arguments.description;
  map.meta.tool = version_text();
  map.meta.options = arguments.leaves.empty()
                         ? "merged by moments"
                         : "merged by leaves, min-points " + io::to_text(arguments.min_points);
  for (std::size_t i = 0; i < arguments.maps.size(); ++i)
    map.meta.options += (i == 0 ? "; of " : ", ") + base_name(arguments.maps[i]);
}

Result<Done> report(const MergeArguments& arguments, const Merged& merged,
                    const std::vector<Output>& outputs) {
  const std::string from = io::to_text(merged.planes) + " planes of " + io::to_text(arguments.maps.size()) +
                           " maps became " + io::to_text(merged.map.planes.size());
  if (!arguments.common.quiet) print_words(from + "; written: " + names_of(outputs));
  if (!arguments.common.json) return Done{};
  const nlohmann::ordered_json numbers = {
      {"program", version_text()},         {"command", "merge"},
      {"maps", arguments.maps.size()},     {"exact", !arguments.leaves.empty()},
      {"seed", arguments.common.seed},     {"planes_before", merged.planes},
      {"planes", merged.map.planes.size()}};
  return write_stdout(numbers.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

Result<Done> run(const MergeArguments& arguments) {
  if (auto fine = check(arguments); !fine) return fine;
  std::vector<Output> outputs = {{"--output", arguments.output, ".xml", {}}};
  if (!arguments.leaves_output.empty())
    outputs.push_back({"--leaves-output", arguments.leaves_output, "", {}});
  std::vector<fs::path> inputs(arguments.maps.begin(), arguments.maps.end());
  inputs.insert(inputs.end(), arguments.leaves.begin(), arguments.leaves.end());
  if (auto fine = check_outputs(outputs, inputs, arguments.common.json); !fine) return fine;
  auto maps = read_maps(arguments.maps);
  if (!maps) return maps.failure();
  auto merged = arguments.leaves.empty() ? merge_moments(arguments, *maps) : merge_leaves(arguments, *maps);
  if (!merged) return merged.failure();
  for (const PlaneMap& map : *maps) merged->planes += map.planes.size();
  describe(merged->map, arguments);
  auto xml = plane_map_to_xml(merged->map);
  if (!xml) return Failure{xml.failure().problem, arguments.output + ": " + xml.failure().sentence};
  outputs[0].bytes = std::move(*xml);
  if (outputs.size() > 1) outputs[1].bytes = std::move(merged->leaves);
  if (auto written = write_outputs(outputs); !written) return written;
  return report(arguments, *merged, outputs);
}

}  // namespace

Command add_merge_command(CLI::App& program) {
  const auto arguments = std::make_shared<MergeArguments>();
  CLI::App& command = *program.add_subcommand(
      "merge",
      "One map of several plane maps that share a world frame. With the leaves of each the result is that "
      "of\n"
      "building it from all frames at once; without them planes are joined by their moments");
  command.add_option("MAP.xml", arguments->maps, "the maps, two or more")->required();
  command.add_option("--leaves", arguments->leaves, "what planes --leaves wrote, one file for each map")
      ->type_name("FILE");
  command.add_option("-o,--output", arguments->output, "where the map goes; - is standard output")
      ->type_name("OUT.xml")
      ->required();
  command.add_option("--leaves-output", arguments->leaves_output, "where the leaves of the new map go")
      ->type_name("FILE");
  arguments->min_points_option =
      add_whole(command, "--min-points", arguments->min_points, {0, std::uint64_t{1} << 31U}, "READINGS",
                "with --leaves: planes with fewer are dropped");
  command.add_option("--name", arguments->name, "of the new map; without it the name of the first file")
      ->type_name("TEXT");
  command.add_option("--description", arguments->description, "of the new map, in the file")
      ->type_name("TEXT");
  add_common_options(command, arguments->common, "planes before and after");
  return {&command, [arguments] { return run(*arguments); }};
}

}  // namespace straightedge::cli
