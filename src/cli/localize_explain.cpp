// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/localize_explain.hpp"

#include <algorithm>
#include <cmath>

#include "cli/localize_pictures.hpp"
#include "cli/outputs.hpp"
#include "cli/program.hpp"
#include "io/html_page.hpp"
#include "io/number_text.hpp"
#include "io/svg_size.hpp"
#include "straightedge/trigonometry.hpp"

namespace straightedge::cli {
namespace {

/// Gathers the pictures while the page is told.
class ScanPage {
 public:
  explicit ScanPage(const LocalizeStory& story) : story_(story), scan_(story.run.explained.back()) {}

  std::vector<NamedFile> run() {
    page_.title = "Scan " + io::to_text(scan_.scan + 1) + " of " + base_name(story_.arguments.scans);
    page_.introduction = {
        "How the lines of one laser scan tell a robot where it is in a line map. Each step is a picture; the "
        "numbers are "
        "those of this scan."};
    page_.facts = {{"map", "map", base_name(story_.arguments.map)},
                   {"state", "state after this scan", to_string(scan_.result.state)},
                   {"time", "time in the log", io::to_text(scan_.result.time_s) + " s"}};
    tell_search();
    tell_readings();
    tell_lines();
    if (scan_.result.has_pose && scan_.result.match_counts.matched > 0) {
      tell_matches();
      tell_pose();
    }
    page_.footer = version_text() + " localize, " + story_.arguments.words();
    files_.push_back({page_name, io::html_from_page(page_)});
    return std::move(files_);
  }

 private:
  void tell_search() {
    const auto& all = story_.run.explained;
    const std::size_t scans = all.size() - (all.back().expected ? 1 : 0);
    if (scans == 0) return;
    io::HtmlSection section{"search", "Search without a start", {}, {}, {}, {}, {}};
    section.paragraphs = {
        "Nothing is known but the map. Two lines of the scan that are not parallel, laid on two walls that "
        "meet at the "
        "same angle, leave one place for the robot. Every such place is a candidate; it is scored by how "
        "well all readings "
        "lie on the walls. The best are followed from scan to scan, each with a filter of its own, until one "
        "stands out. "
        "The pictures show the likeliest place after each scan."};
    io::HtmlTable table{"The search, scan by scan",
                        {"scan", "lines", "pairs", "candidates", "followed", "on walls", "state"},
                        {}};
    for (std::size_t i = 0; i < scans; ++i) {
      const LocalizeResult& result = all[i].result;
      add_figure(section, "search-" + io::to_text(i + 1) + ".svg", search_drawing(story_, all[i]),
                 &story_.map, "The map and the readings of a scan laid on it",
                 "Scan " + io::to_text(all[i].scan + 1) + ".");
      table.rows.push_back({io::to_text(all[i].scan + 1), io::to_text(result.lines.size()),
                            io::to_text(result.search_counts.pairs),
                            io::to_text(result.search_counts.candidates),
                            io::to_text(result.search_counts.hypotheses), percent(result.fit.on_walls),
                            to_string(result.state)});
    }
    section.tables.push_back(std::move(table));
    section.sources = {"src/localize/pose_search.cpp", "src/localize/pose_candidates.cpp"};
    page_.sections.push_back(std::move(section));
  }

  void tell_readings() {
    const ScanLineCounts& counts = scan_.result.line_counts;
    io::HtmlSection section{"readings", "The scan", {}, {}, {}, {}, {}};
    section.paragraphs = {
        "Each beam that came back is a point. Here they are as the robot has them: it stands in the "
        "middle of its own frame and looks along its x axis, to the right."};
    add_figure(section, "readings.svg", readings_drawing(story_, scan_), nullptr, "Points round a robot",
               "The readings.");
    section.facts = {{"beams", "beams", io::to_text(counts.beams)},
                     {"no-reading", "without a reading", io::to_text(counts.no_reading)},
                     {"beyond-range", "beyond the range", io::to_text(counts.beyond_range)}};
    section.sources = {"include/straightedge/host/laser_scan.hpp"};
    page_.sections.push_back(std::move(section));
  }

  void tell_lines() {
    const ScanLineCounts& counts = scan_.result.line_counts;
    io::HtmlSection section{"lines", "Its lines", {}, {}, {}, {}, {}};
    section.paragraphs = {
        "Neighbours on one wall are cut out of the scan and fitted, each point with the weight of its "
        "own noise. A line knows how sure its angle and its offset are."};
    add_figure(section, "scan-lines.svg", lines_drawing(story_, scan_), nullptr, "Points and numbered lines",
               "The lines, with their numbers.");
    section.facts = {{"lines-found", "lines", io::to_text(counts.lines)},
                     {"too-few", "pieces of too few points", io::to_text(counts.too_few)},
                     {"too-short", "pieces too short", io::to_text(counts.too_short)}};
    io::HtmlTable table{
        "The lines",
        {"line", "points", "length, m", "distance, m", "sigma of angle, degrees", "sigma of offset, mm"},
        {}};
    for (std::size_t i = 0; i < scan_.result.lines.size(); ++i) {
      const ScanLine& line = scan_.result.lines[i];
      const double dx = line.x1_m - line.x0_m, dy = line.y1_m - line.y0_m;
      const double distance = std::abs(line.normal_x * line.centroid_x_m + line.normal_y * line.centroid_y_m);
      table.rows.push_back({io::to_text(i + 1), io::to_text(line.points),
                            io::to_text(std::sqrt(dx * dx + dy * dy), 2), io::to_text(distance, 2),
                            io::to_text(std::sqrt(line.var_theta) / degree, 2),
                            io::to_text(1000 * std::sqrt(line.var_offset), 1)});
    }
    section.tables.push_back(std::move(table));
    section.sources = {"include/straightedge/host/scan_lines.hpp", "src/localize/scan_lines.cpp"};
    page_.sections.push_back(std::move(section));
  }

  void tell_matches() {
    io::HtmlSection section{"matches", "Which walls they are", {}, {}, {}, {}, {}};
    section.paragraphs = {
        "The odometry says where to expect the robot; from there the scan is laid on the map. A line is "
        "matched with a wall when they are near in angle and distance, overlap, have their open floor on "
        "the same side, pass the chi-square test, and agree with the other pairs. Whatever fails one of "
        "these is not used, and the table says why."};
    add_figure(section, "matches.svg", matches_drawing(story_, scan_), &story_.map,
               "Lines of the scan beside walls of the map", "From the expected pose.");
    io::HtmlTable table{"Lines and walls", {"line", "what became of it", "wall", "chi-square"}, {}};
    for (std::size_t i = 0; i < scan_.result.matches.size(); ++i) {
      const LineMatch& match = scan_.result.matches[i];
      table.rows.push_back({io::to_text(i + 1), to_string(match.verdict),
                            match.has_wall ? io::to_text(match.segment_id) : "",
                            match.verdict == LineVerdict::matched ? io::to_text(match.chi_square, 2) : ""});
    }
    section.tables.push_back(std::move(table));
    section.sources = {"src/localize/match.cpp", "src/localize/joint_hypotheses.cpp"};
    page_.sections.push_back(std::move(section));
  }

  void tell_pose() {
    const LocalizeResult& result = scan_.result;
    io::HtmlSection section{"pose", "The corrected pose", {}, {}, {}, {}, {}};
    section.paragraphs = {
        "The extended Kalman filter moves the pose so that lines and walls agree, each pair as far as it "
        "is to be trusted. Now the readings lie on the walls."};
    add_figure(section, "pose.svg", pose_drawing(story_, scan_), &story_.map, "The readings lie on the walls",
               "From the corrected pose.");
    section.facts = {
        {"x", "x", io::to_text(result.pose.x_m, 3) + " m"},
        {"y", "y", io::to_text(result.pose.y_m, 3) + " m"},
        {"heading", "heading", io::to_text(result.pose.heading_rad / degree, 2) + " degrees"},
        {"sigma-x", "sigma of x", io::to_text(1000 * std::sqrt(result.covariance[0]), 0) + " mm"},
        {"sigma-y", "sigma of y", io::to_text(1000 * std::sqrt(result.covariance[4]), 0) + " mm"},
        {"sigma-heading", "sigma of the heading",
         io::to_text(std::sqrt(result.covariance[8]) / degree, 2) + " degrees"},
        {"on-walls", "readings on walls", percent(result.fit.on_walls)}};
    section.sources = {"include/straightedge/host/localizer.hpp", "src/localize/localizer.cpp"};
    page_.sections.push_back(std::move(section));
  }

  void add_figure(io::HtmlSection& section, const std::string& file, const FloorDrawing& drawing,
                  const LineMap* map, const char* alt, const std::string& caption) {
    std::string svg = floor_to_svg(map == nullptr ? LineMap{} : *map, drawing);
    section.figures.push_back({file, alt, caption, io::svg_size(svg)});
    files_.push_back({file, std::move(svg)});
  }

  static std::string percent(double share) { return io::to_text(100 * share, 0) + " %"; }

  const LocalizeStory& story_;
  const ExplainedScan& scan_;
  io::HtmlPage page_;
  std::vector<NamedFile> files_;
};

}  // namespace

std::vector<NamedFile> explain_scan(const LocalizeStory& story) {
  if (story.run.explained.empty()) return {};
  return ScanPage(story).run();
}

}  // namespace straightedge::cli
