// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/localize_outputs.hpp"

#include "cli/localize_explain.hpp"
#include "cli/program.hpp"
#include "straightedge/host/floor_svg.hpp"

namespace straightedge::cli {
namespace {

namespace fs = std::filesystem;

Point2 place_of(const TimedPose2& timed) {
  return {timed.pose.x_m, timed.pose.y_m};
}

/// One way for each time that the robot was found.
void add_robot_ways(FloorDrawing& drawing, const LocalizeRun& run) {
  for (std::size_t i = 0; i < run.poses.size(); ++i) {
    if (i == 0 || run.scan_of[i] != run.scan_of[i - 1] + 1) drawing.ways.push_back({FloorPath::robot, {}});
    drawing.ways.back().points.push_back(place_of(run.poses[i]));
    const bool lost_next = i + 1 < run.poses.size() && run.scan_of[i + 1] != run.scan_of[i] + 1;
    if (lost_next) drawing.marks.push_back({FloorRobot::lost, run.poses[i].pose, {}});
  }
  if (run.poses.empty()) return;
  const bool lost_at_end = !run.events.back().found;
  drawing.marks.push_back({lost_at_end ? FloorRobot::lost : FloorRobot::end, run.poses.back().pose, {}});
  drawing.marks.push_back({FloorRobot::start, run.poses.front().pose, {}});
}

FloorDrawing drawing_of(const LocalizeStory& story) {
  FloorDrawing drawing;
  drawing.title = base_name(story.arguments.scans) + " in " + base_name(story.arguments.map);
  drawing.description = version_text() + " localize: " + story.arguments.words();
  drawing.readings = story.run.readings;
  const auto add = [&](FloorPath kind, const std::vector<TimedPose2>& poses) {
    FloorWay way{kind, {}};
    for (const TimedPose2& timed : poses) way.points.push_back(place_of(timed));
    drawing.ways.push_back(std::move(way));
  };
  add(FloorPath::odometry, story.odometry);
  add(FloorPath::truth, story.truth);
  add_robot_ways(drawing, story.run);
  return drawing;
}

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
  return check_outputs(outputs_, inputs, arguments_.common.json);
}

Result<Done> LocalizeOutputs::fill(const LocalizeStory& story) {
  const std::string made = version_text() + " localize\n" + story.arguments.words();
  for (Output& output : outputs_) {
    if (output.option == "--output") {
      output.bytes = planar_trajectory_to_text(story.run.poses, made);
    } else if (output.option == "--covariance") {
      output.bytes = covariances_to_text(story.run.poses, made);
    } else {
      output.bytes = floor_to_svg(story.map, drawing_of(story));
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
  return Failure{written.failure().problem, written.failure().sentence + "; written before: " + names_of(outputs_)};
}

std::string LocalizeOutputs::names() const {
  const std::string page = pictures_.empty() ? "" : ", " + (fs::path(arguments_.explain) / page_name).string();
  return names_of(outputs_) + page;
}

}  // namespace straightedge::cli
