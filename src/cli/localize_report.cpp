// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/localize_report.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/outputs.hpp"
#include "cli/program.hpp"
#include "io/number_text.hpp"
#include "straightedge/trigonometry.hpp"

namespace straightedge::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_events = 6;  // that are told

struct NamedCount {
  const char* words;
  const char* name;
  std::uint32_t MatchCounts::*count;
};
constexpr NamedCount refusals[] = {{"no wall", "no_wall", &MatchCounts::no_wall},
                                   {"wrong side", "wrong_side", &MatchCounts::wrong_side},
                                   {"no overlap", "no_overlap", &MatchCounts::no_overlap},
                                   {"gate", "gate", &MatchCounts::gate},
                                   {"not joint", "not_joint", &MatchCounts::not_joint},
                                   {"ambiguous", "ambiguous", &MatchCounts::ambiguous}};

std::string count(std::uint64_t number, const std::string& what) {
  return io::to_text(number) + " " + what + (number == 1 ? "" : "s");
}

double share(double part, std::size_t whole) {
  return whole == 0 ? 0 : part / static_cast<double>(whole);
}

std::size_t segments_of(const LineMap& map) {
  std::size_t segments = 0;
  for (const MapLine& line : map.lines) segments += line.segments.size();
  return segments;
}

double seconds_between(const LaserLog& log, std::size_t from, std::size_t to) {
  return log.scans[to].scan.time_s - log.scans[from].scan.time_s;
}

std::string log_words(const LocalizeStory& story) {
  const LaserLog& log = story.log;
  const std::size_t scans = log.scans.size();
  std::string words =
      count(scans, "scan") + " of " + io::to_text(share(static_cast<double>(story.run.beams), scans), 0) +
      " beams, " + io::to_text(seconds_between(log, 0, scans - 1), 1) + " s, " +
      (story.run.with_odometry == 0 ? "no" : io::to_text(story.run.with_odometry)) + " with odometry";
  if (log.late_scans > 0)
    words += "; left out: " + count(log.late_scans, "scan") + " older than the one before";
  if (story.run.without_reading > 0)
    words += "; " + count(story.run.without_reading, "scan") + " without a reading";
  return words;
}

std::string line_words(const LocalizeStory& story) {
  const LocalizeRun& run = story.run;
  return io::to_text(share(static_cast<double>(run.lines), story.log.scans.size()), 1) +
         " a scan; matched with a pose: " + io::to_text(share(run.matches.matched, run.poses.size()), 1);
}

std::string refusal_words(const LocalizeRun& run) {
  std::string words;
  for (const NamedCount& refusal : refusals) {
    if (run.matches.*refusal.count == 0) continue;
    if (!words.empty()) words += ", ";
    words += io::to_text(share(run.matches.*refusal.count, run.poses.size()), 2) + " " + refusal.words;
  }
  return words.empty() ? "none" : words + " a scan";
}

std::string event_words(const LocalizeStory& story) {
  const std::vector<LocalizeEvent>& events = story.run.events;
  if (events.empty()) return "never: no place in the map stood out; the trajectory is empty";
  std::string words;
  for (std::size_t i = 0; i < std::min(events.size(), most_events); ++i) {
    words += i == 0 ? "" : events[i].found ? ", found again" : ", lost";
    words += (i == 0 ? "at scan " : " at scan ") + io::to_text(events[i].scan + 1);
    if (i == 0 && events[0].scan == 0 && story.arguments.options().start) words += ", as given";
    if (i == 0 && events[0].scan > 0)
      words += ", after " + io::to_text(seconds_between(story.log, 0, events[0].scan), 1) + " s";
  }
  if (events.size() > most_events) words += " ... lost " + count(story.run.lost_times, "time") + " in all";
  return story.run.lost_times == 0 ? words + ", never lost" : words;
}

std::string error_words(const PoseErrors& errors, bool all) {
  std::string words = "position rms " + io::to_text(errors.rms_m, 3) + " m";
  if (all) words += ", median " + io::to_text(errors.median_m, 3);
  words += ", worst " + io::to_text(errors.worst_m, 3) + "; heading rms " +
           io::to_text(errors.rms_rad / degree, 2) + " degrees";
  if (all) words += ", worst " + io::to_text(errors.worst_rad / degree, 2);
  if (all && errors.nees) words += "; NEES " + io::to_text(*errors.nees, 2) + " (3 is ideal)";
  if (errors.without_truth > 0) words += "; " + count(errors.without_truth, "pose") + " without a truth";
  return words;
}

std::string time_words(const LocalizeRun& run) {
  std::vector<double> sorted = run.milliseconds;
  std::sort(sorted.begin(), sorted.end());
  return io::to_text(sorted[sorted.size() / 2], 3) + " ms a scan (median), at most " +
         io::to_text(sorted.back(), 3) + " ms";
}

Json json_of(const PoseErrors& errors) {
  return {{"compared", errors.compared},
          {"without_truth", errors.without_truth},
          {"position_rms", errors.rms_m},
          {"position_median", errors.median_m},
          {"position_worst", errors.worst_m},
          {"heading_rms", errors.rms_rad},
          {"heading_median", errors.median_rad},
          {"heading_worst", errors.worst_rad},
          {"nees", errors.nees ? Json(*errors.nees) : Json()}};
}

Json json_of(const MatchCounts& matches) {
  Json refused = Json::object();
  for (const NamedCount& refusal : refusals) refused[refusal.name] = matches.*refusal.count;
  return {{"lines", matches.lines}, {"matched", matches.matched}, {"refused", std::move(refused)}};
}

}  // namespace

std::string words_of(const LocalizeStory& story, const std::string& written) {
  std::string words = story.arguments.scans + " in " + story.arguments.map;
  const auto line = [&](const char* what, const std::string& text) {
    words.append("\n  ").append(what).append(text);
  };
  line("map       ", count(story.map.lines.size(), "line") + ", " + count(segments_of(story.map), "segment"));
  line("log       ", log_words(story));
  line("lines     ", line_words(story));
  line("refused   ", refusal_words(story.run));
  line("found     ", event_words(story));
  line("poses     ", io::to_text(story.run.poses.size()) + " of " + count(story.log.scans.size(), "scan"));
  if (story.errors) line("errors    ", error_words(*story.errors, true));
  if (story.odometry_errors) line("odometry  ", "alone: " + error_words(*story.odometry_errors, false));
  line("time      ", time_words(story.run));
  line("written   ", written);
  return words;
}

std::string json_of(const LocalizeStory& story) {
  const LocalizeRun& run = story.run;
  Json events = Json::array();
  for (const LocalizeEvent& event : run.events)
    events.push_back({{"state", event.found ? "found" : "lost"},
                      {"scan", event.scan + 1},
                      {"time", story.log.scans[event.scan].scan.time_s}});
  Json numbers = {{"program", version_text()},
                  {"command", "localize"},
                  {"map", base_name(story.arguments.map)},
                  {"input", base_name(story.arguments.scans)},
                  {"options", story.arguments.words()},
                  {"seed", story.arguments.common.seed},
                  {"map_lines", story.map.lines.size()},
                  {"map_segments", segments_of(story.map)},
                  {"scans", story.log.scans.size()},
                  {"late_scans", story.log.late_scans},
                  {"with_odometry", run.with_odometry},
                  {"without_reading", run.without_reading},
                  {"scan_lines", run.lines},
                  {"poses", run.poses.size()},
                  {"lost_times", run.lost_times},
                  {"events", std::move(events)},
                  {"matching", json_of(run.matches)}};
  if (story.errors) numbers["errors"] = json_of(*story.errors);
  if (story.odometry_errors) numbers["odometry_errors"] = json_of(*story.odometry_errors);
  return numbers.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace straightedge::cli
