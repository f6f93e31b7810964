// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/localize_pictures.hpp"

#include "cli/outputs.hpp"
#include "cli/program.hpp"
#include "io/number_text.hpp"

namespace straightedge::cli {
namespace {

Point2 place_of(const TimedPose2& timed) {
  return {timed.pose.x_m, timed.pose.y_m};
}

Point2 moved(const Pose2& world_from_robot, double x_m, double y_m) {
  const Pose2 at = compose(world_from_robot, {x_m, y_m, 0});
  return {at.x_m, at.y_m};
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

FloorDrawing scan_drawing(const LocalizeStory& story, const ExplainedScan& scan, const std::string& title,
                          const Pose2& from) {
  FloorDrawing drawing;
  drawing.title = "Scan " + io::to_text(scan.scan + 1) + ": " + title;
  drawing.description = version_text() + " localize: " + story.arguments.words();
  drawing.readings = points_of(story.log.scans[scan.scan].scan, from);
  drawing.view.push_back({from.x_m, from.y_m});
  for (const ScanLine& line : scan.result.lines) {
    drawing.view.push_back(moved(from, line.x0_m, line.y0_m));
    drawing.view.push_back(moved(from, line.x1_m, line.y1_m));
  }
  return drawing;
}

void add_line(FloorDrawing& drawing, const ScanLine& line, const Pose2& from, FloorLine kind,
              std::string label) {
  drawing.segments.push_back(
      {kind, moved(from, line.x1_m, line.y1_m), moved(from, line.x0_m, line.y0_m), std::move(label)});
}

void add_matches(FloorDrawing& drawing, const LocalizeResult& result, const Pose2& from) {
  for (std::size_t i = 0; i < result.lines.size(); ++i) {
    const bool matched = result.matches[i].verdict == LineVerdict::matched;
    add_line(drawing, result.lines[i], from, matched ? FloorLine::matched : FloorLine::refused,
             io::to_text(i + 1));
    if (matched) drawing.bold_walls.push_back(result.matches[i].segment_id);
  }
}

}  // namespace

FloorDrawing run_drawing(const LocalizeStory& story) {
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

FloorDrawing readings_drawing(const LocalizeStory& story, const ExplainedScan& scan) {
  FloorDrawing drawing = scan_drawing(story, scan, "the readings, in the robot's frame", {});
  drawing.marks.push_back({FloorRobot::robot, {}, {}});
  return drawing;
}

FloorDrawing lines_drawing(const LocalizeStory& story, const ExplainedScan& scan) {
  FloorDrawing drawing = scan_drawing(story, scan, "its lines, in the robot's frame", {});
  for (std::size_t i = 0; i < scan.result.lines.size(); ++i)
    add_line(drawing, scan.result.lines[i], {}, FloorLine::seen, io::to_text(i + 1));
  drawing.marks.push_back({FloorRobot::robot, {}, {}});
  return drawing;
}

FloorDrawing matches_drawing(const LocalizeStory& story, const ExplainedScan& scan) {
  const Pose2 from = scan.expected.value_or(scan.result.pose);
  const char* const title =
      scan.expected ? "from where the robot is expected" : "from where the search has found the robot";
  FloorDrawing drawing = scan_drawing(story, scan, title, from);
  add_matches(drawing, scan.result, from);
  drawing.marks.push_back({scan.expected ? FloorRobot::expected : FloorRobot::pose, from, {}});
  return drawing;
}

FloorDrawing pose_drawing(const LocalizeStory& story, const ExplainedScan& scan) {
  FloorDrawing drawing = scan_drawing(story, scan, "from the corrected pose", scan.result.pose);
  add_matches(drawing, scan.result, scan.result.pose);
  if (scan.expected) drawing.marks.push_back({FloorRobot::expected, *scan.expected, {}});
  drawing.marks.push_back({FloorRobot::pose, scan.result.pose, scan.result.covariance});
  return drawing;
}

FloorDrawing search_drawing(const LocalizeStory& story, const ExplainedScan& scan) {
  const bool found = scan.result.has_pose;
  FloorDrawing drawing =
      scan_drawing(story, scan, found ? "a pose stands" : "the likeliest place so far", scan.result.pose);
  drawing.view.clear();
  drawing.marks.push_back({found ? FloorRobot::pose : FloorRobot::candidate, scan.result.pose, {}});
  return drawing;
}

}  // namespace straightedge::cli
