// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <string>

#include "cli/explain_sections.hpp"
#include "straightedge/trigonometry.hpp"

namespace straightedge::cli {
namespace {

using io::HtmlSection;

std::string name_of(HoughMethod method) {
  switch (method) {
    case HoughMethod::standard:
      return "standard";
    case HoughMethod::progressive:
      return "progressive";
    case HoughMethod::randomized:
      return "randomized";
  }
  return "";
}

io::HtmlTable peak_table(const ExplainRun& run) {
  io::HtmlTable table{"The highest peaks that are lines of their own.", {"No.", "theta", "rho", "Votes"}, {}};
  for (std::size_t i = 0; i < run.peaks.size(); ++i) {
    const HoughPeak& peak = run.peaks[i];
    table.rows.push_back({std::to_string(i + 1),
                          in_words(static_cast<double>(peak.theta) / degree, 1) + "\u00b0",
                          in_words(static_cast<double>(peak.rho), 1), in_words(std::int64_t{peak.votes})});
  }
  return table;
}

HtmlSection accumulator_section(const ExplainStory& story) {
  const HoughGrid& grid = story.run.votes.grid();
  return {
      .id = "accumulator",
      .title = "The accumulator: every pixel votes",
      .paragraphs =
          {"A line is two numbers: theta, the direction of its normal, and rho, its distance from the "
           "centre of the first pixel. Through an edge pixel goes one line for each theta; the pixel "
           "votes for all of them and draws a wave into the table of votes.",
           "The waves of pixels that lie on one line meet in one point. So a bright point here is "
           "a line there."},
      .figures = {{.file = "accumulator.png",
                   .alt =
                       "Heat map of votes, theta to the right, rho upwards, with numbered rings at the peaks",
                   .caption = "Votes; brightness is their square root. Rings: the highest peaks.",
                   .size = story.accumulator}},
      .facts = {{"cells", "Cells",
                 in_words(std::int64_t{grid.angles}) + " angles x " + in_words(std::int64_t{grid.distances}) +
                     " distances"},
                {"most-votes", "White stands for", in_words(std::int64_t{story.most_votes}) + " votes"}},
      .sources = {"include/straightedge/hough_standard.hpp", "src/hough/standard.cpp"}};
}

HtmlSection peak_section(const ExplainStory& story) {
  HtmlSection section{
      .id = "peaks",
      .title = "Peaks are lines",
      .paragraphs =
          {"Each peak, drawn back into the picture. A line of the table has no ends: whether its votes come "
           "from one long wall or from crumbs all over the picture is not known yet.",
           "Peaks close to a higher one are left out here, for clearness; most of them are copies of it."},
      .figures = {stage_figure(story, "peaks.png", "Numbered lines through the whole picture",
                               "The lines of the highest peaks.")},
      .tables = {peak_table(story.run)},
      .sources = {"src/hough/standard.cpp"}};
  if (story.run.peaks.empty()) {
    section.tables.clear();
    section.paragraphs = {"No cell has more votes than the threshold: there is no line in this picture."};
  }
  return section;
}

std::vector<std::string> method_story(HoughMethod method) {
  switch (method) {
    case HoughMethod::standard:
      return {
          "The standard method takes peak after peak, the highest first, and reads from the edge picture "
          "where "
          "the line really is: a hole longer than the largest gap ends a segment, short pieces are dropped. "
          "The pixels of a segment are taken out, so that weaker copies of it find nothing."};
    case HoughMethod::progressive:
      return {
          "The progressive method lets pixels vote one after another, in random order. As soon as a cell has "
          "enough votes it walks along that line, takes the pixels that it finds there out of the picture, "
          "and "
          "their votes back. What is taken need not vote any more, which saves most of the work."};
    case HoughMethod::randomized:
      return {
          "The randomized method draws two pixels near one another. Two points make a line, so the pair "
          "casts a "
          "single vote. A cell with a few votes is looked at in the edge picture; if a line is really there, "
          "its pixels are taken out, and the drawing goes on until it is unlikely that a line was missed."};
  }
  return {};
}

io::HtmlTable segment_table(const ExplainRun& run) {
  io::HtmlTable table{"The longest segments, in columns and rows of the picture.",
                      {"From", "To", "Length", "Votes", "Pixels"},
                      {}};
  const auto length = [](const HoughSegment& s) { return std::hypot(s.x1 - s.x0, s.y1 - s.y0); };
  std::vector<HoughSegment> longest = run.segments;
  std::stable_sort(longest.begin(), longest.end(),
                   [&](const HoughSegment& a, const HoughSegment& b) { return length(a) > length(b); });
  longest.resize(std::min(longest.size(), shown_peaks));
  const auto point = [](std::int32_t x, std::int32_t y) {
    return std::to_string(x).append(", ").append(std::to_string(y));
  };
  for (const HoughSegment& s : longest) {
    table.rows.push_back({point(s.x0, s.y0), point(s.x1, s.y1), in_words(length(s), 1),
                          in_words(std::int64_t{s.votes}), in_words(std::int64_t{s.pixels})});
  }
  return table;
}

HtmlSection segment_section(const ExplainStory& story) {
  const HoughOptions options = first_round(story.options.lines);
  const HoughResult& hough = story.run.hough;
  const std::string method = name_of(options.method);
  const std::string threshold = options.method == HoughMethod::randomized
                                    ? in_words(std::int64_t{options.pair_threshold}) + " pairs"
                                    : in_words(std::int64_t{options.threshold}) + " votes";
  HtmlSection section{
      .id = "segments",
      .title = "Segments, as the Hough transform gives them",
      .paragraphs = method_story(options.method),
      .figures = {stage_figure(story, "segments.png", "Coloured segments over the pale picture",
                               "Raw segments. Colours only tell neighbours apart.")},
      .facts = {{"method", "Method", method},
                {"threshold", "Threshold", threshold},
                {"segments-count", "Segments", in_words(std::int64_t{hough.segments})},
                {"seed", "Seed", std::to_string(hough.seed)}},
      .sources = {std::string("include/straightedge/hough_").append(method).append(".hpp"),
                  std::string("src/hough/").append(method).append(".cpp")}};
  section.paragraphs.emplace_back(
      "The ends lie on whole pixels, a wall gives two lines or more, and some lines come in pieces. The last "
      "stage "
      "puts that in order.");
  if (options.method != HoughMethod::standard)
    section.facts.push_back({"draws", "Draws", in_words(static_cast<std::int64_t>(hough.draws))});
  if (options.gradient_window > 0)
    section.facts.push_back(
        {"window", "Gradient window", in_words(options.gradient_window / degree, 1) + "\u00b0"});
  if (!story.run.segments.empty()) section.tables.push_back(segment_table(story.run));
  return section;
}

HtmlSection progress_section(const ExplainStory& story) {
  const bool pairs = story.options.lines.hough->method == HoughMethod::randomized;
  HtmlSection section{
      .id = "progress",
      .title = "The same run, step by step",
      .paragraphs = {"Gray pixels wait, yellow ones have voted, red ones were taken out by a line."}};
  section.paragraphs.emplace_back(
      pairs ? "See how few pairs the long lines need. What is not red in the end lies on no "
              "line that is long enough."
            : "See how few votes the long lines need: their other pixels are taken before "
              "their turn comes. What is still yellow in the end lies on no line that "
              "stands out.");
  for (std::size_t i = 0; i < story.progress.size(); ++i) {
    const ProgressPicture& moment = story.progress[i];
    std::string caption = i + 1 == story.progress.size() ? "At the end: " : "After ";
    caption += in_words(std::int64_t{moment.lines}) + (moment.lines == 1 ? " line, " : " lines, ");
    caption +=
        in_words(static_cast<std::int64_t>(moment.votes)) + (pairs ? " pairs" : " pixels") + " have voted, ";
    caption += in_words(std::int64_t{moment.left}) + " pixels are left.";
    section.figures.push_back(stage_figure(
        story, progress_file(i).c_str(), "Edge pixels: waiting, voted, and taken by lines", caption.c_str()));
  }
  return section;
}

HtmlSection map_section(const ExplainStory& story) {
  const LineMapReport& report = story.run.lines.report;
  const bool map = report.picture == PictureKind::map;
  HtmlSection section{
      .id = "lines",
      .title = "The line map",
      .paragraphs =
          {"Each segment is fitted anew to where its edge runs between the pixels, found by a parabola over "
           "the magnitude. Pieces of one line are joined if a statistical test says that they may be one.",
           "The straight edges of this map are those of the Hough transform, in some rounds. The command "
           "lines "
           "follows each edge from pixel to pixel instead, unless --method says otherwise: that takes half "
           "the "
           "time and gives the same walls, but for small differences.",
           map ? "The two edges of a thin wall become its axis (blue, with the width of the wall); the faces "
                 "of thick walls stay (red). Small things that stand alone are dropped."
               : "In a photo every edge is a line of its own (red)."},
      .figures = {stage_figure(story, "lines.png", "The line map over the pale picture", "The line map.")},
      .facts = {{"candidates", "Raw segments, all rounds", in_words(std::int64_t{report.candidates})},
                {"straight", "Straight edges after the fit", in_words(std::int64_t{report.edges})},
                {"merged", "Joined with others", in_words(std::int64_t{report.merged})}},
      .sources = {"include/straightedge/host/line_map_builder.hpp", "src/map/line_map_builder.cpp"}};
  if (map) {
    section.facts.push_back({"walls", "Thin walls made of two edges", in_words(std::int64_t{report.walls})});
    section.facts.push_back({"no-wall", "Dropped: no wall", in_words(std::int64_t{report.no_wall})});
    section.facts.push_back({"furniture", "Dropped: small things", in_words(std::int64_t{report.furniture})});
  }
  section.facts.push_back({"too-short", "Dropped: too short", in_words(std::int64_t{report.too_short})});
  section.facts.push_back({"map-segments", "Segments in the map", in_words(std::int64_t{report.segments})});
  section.facts.push_back({"map-lines", "Lines in the map", in_words(std::int64_t{report.lines})});
  return section;
}

}  // namespace

std::vector<HtmlSection> line_sections(const ExplainStory& story) {
  std::vector<HtmlSection> sections = {accumulator_section(story), peak_section(story),
                                       segment_section(story)};
  if (!story.progress.empty()) sections.push_back(progress_section(story));
  sections.push_back(map_section(story));
  return sections;
}

}  // namespace straightedge::cli
