// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/localize_outputs.hpp"

#include <system_error>

#include "cli/localize_explain.hpp"
#include "cli/localize_pictures.hpp"
#include "cli/program.hpp"
#include "straightedge/host/floor_svg.hpp"

namespace straightedge::cli {
namespace {

namespace fs = std::filesystem;

}  // namespace

LocalizeOutputs::LocalizeOutputs(const LocalizeArguments& arguments) : arguments_(arguments) {
  const auto add = [&](const std::string& option, const std::string& path, const std::string& extension) {
    if (!path.empty() || option == "--output") outputs_.push_back({option, path, extension, {}});
  };
  add("--output", arguments.trajectory, "");
  add("--covariance", arguments.covariance, "");
  add("--svg", arguments.svg, ".svg");
}

Result<Done> LocalizeOutputs::check() const {
  std::vector<fs::path> inputs = {input_path(arguments_.map), input_path(arguments_.scans)};
  if (!arguments_.truth.empty()) inputs.emplace_back(arguments_.truth);
  if (auto fine = check_outputs(outputs_, inputs, arguments_.common.json); !fine) return fine;
  std::error_code error;
  if (arguments_.explain.empty() || !fs::exists(arguments_.explain, error) ||
      fs::is_directory(arguments_.explain, error))
    return Done{};
  return Failure{Problem::cannot_write, arguments_.explain + ": is no folder that pictures could go to"};
}

Result<Done> LocalizeOutputs::fill(const LocalizeStory& story) {
  const std::string made = version_text() + " localize\n" + story.arguments.words();
  for (Output& output : outputs_) {
    if (output.option == "--output") {
      output.bytes = planar_trajectory_to_text(story.run.poses, made);
    } else if (output.option == "--covariance") {
      output.bytes = covariances_to_text(story.run.poses, made);
    } else {
      output.bytes = floor_to_svg(story.map, run_drawing(story));
    }
  }
  if (!arguments_.explain.empty()) pictures_ = explain_scan(story);
  return Done{};
}

Result<Done> LocalizeOutputs::write() const {
  if (auto written = write_outputs(outputs_); !written) return written;
  if (pictures_.empty()) return Done{};
  auto written = write_folder(pictures_, arguments_.explain);
  if (written) return written;
  return Failure{written.failure().problem,
                 written.failure().sentence + "; written before: " + names_of(outputs_)};
}

std::string LocalizeOutputs::names() const {
  const std::string page =
      pictures_.empty() ? "" : ", " + (fs::path(arguments_.explain) / page_name).string();
  return names_of(outputs_) + page;
}

}  // namespace straightedge::cli
