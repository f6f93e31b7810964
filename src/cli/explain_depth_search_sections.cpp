// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <string>

#include "cli/explain_depth_sections.hpp"
#include "cli/explain_sections.hpp"

namespace straightedge::cli {
namespace {

using io::HtmlSection;

constexpr std::size_t rows_of_tables = 12;

std::string area_of(const WatchedWindow& w) {
  return std::to_string(w.side_u) + " x " + std::to_string(w.side_v) + " pixels from column " +
         std::to_string(w.x) + ", row " + std::to_string(w.y);
}

void add_triple(DepthStory& story, const RansacEvent& event, const std::string& file, const std::string& name,
                HtmlSection& section) {
  const TriplePicture shown = show_triple(story.run, event);
  section.figures.push_back(
      add_figure(story, file, shown.picture, "Three readings of the window and those near their plane",
                 name + " (no. " + std::to_string(event.iteration + 1) +
                     "): the plane through the three red readings has " +
                     in_words(std::int64_t{shown.inliers}) + " of " + in_words(std::int64_t{shown.readings}) +
                     " readings within the gate (green, pale at its border); cost " +
                     in_words(static_cast<double>(event.cost), 1) + "."));
}

void add_refitted(DepthStory& story, HtmlSection& section) {
  const TriplePicture shown = show_refitted(story.run);
  section.figures.push_back(add_figure(
      story, "refitted.png", shown.picture, "The window's readings near the refitted plane",
      "The plane in the end, refitted to all readings near it, has " + in_words(std::int64_t{shown.inliers}) +
          " of " + in_words(std::int64_t{shown.readings}) + "."));
}

HtmlSection hypotheses_section(DepthStory& story) {
  HtmlSection section{
      .id = "hypotheses",
      .title = "RANSAC in one window: guess, count, keep the best",
      .paragraphs =
          {"Three readings make a plane. RANSAC draws three by chance, counts how well the others agree "
           "with their plane, and does so again; the best guess stays. If a share w of the readings "
           "lies on one plane, a draw hits it with all three with chance w x w x w. In a whole frame "
           "w is small for all but the largest plane; in a small window it is large for whatever is "
           "there. So the search goes from window to window."},
      .sources = {"include/straightedge/ransac_planes.hpp", "include/straightedge/ransac_stop.hpp"}};
  if (!story.run.ransac.window) {
    section.paragraphs.emplace_back("No window of this frame has enough readings to be watched.");
    return section;
  }
  const WatchedWindow& window = *story.run.ransac.window;
  const double w = window.share;
  section.paragraphs.push_back(
      "Watched here is a window in which " + percent(w) +
      " of the readings lie on its largest plane: a draw is good with a chance of " + percent(w * w * w) +
      ". The cost of a guess is small when many readings lie near its plane: each adds between 0 (on the "
      "plane) and 1 (outside of the gate). A guess that beats all before is at once refitted to the readings "
      "near it, and later ones must beat the refitted plane.");
  section.figures.push_back(add_figure(story, "window.png", show_window(story.run), "The window in the frame",
                                       "The window: " + area_of(window) + "."));
  const auto best = best_events(window);
  if (best.size() > 1) add_triple(story, best.front(), "first-triple.png", "The first guess", section);
  add_triple(story, best.back(), "best-triple.png", "The best guess", section);
  add_refitted(story, section);
  section.figures.push_back(
      add_figure(story, "hypotheses.png", show_hypotheses(story.run),
                 "Cost of each hypothesis, and of the plane in the end",
                 "Each dot is a guess: the lower the better, at most " + std::to_string(window.subset) +
                     ", the number of readings that are asked. Red: better than all before, refitted ones "
                     "included. Green "
                     "line: the plane in the end, measured on all readings of the window. The dots end where "
                     "a better guess has become unlikely."));
  section.facts = {{"window-draws", "Guesses", in_words(static_cast<std::int64_t>(window.events.size()))},
                   {"window-best", "Times that a guess was the best so far",
                    in_words(static_cast<std::int64_t>(best.size()))},
                   {"confidence", "Stops at a confidence of", percent(story.run.options.ransac.confidence)}};
  return section;
}

io::HtmlTable ransac_table(const ExplainDepthRun& run) {
  io::HtmlTable table{"The strongest candidates.", {"No.", "Readings", "Score", "Kind"}, {}};
  for (std::size_t k = 0; k < run.ransac.candidates.size() && k < rows_of_tables; ++k) {
    const ProposedPlane& c = run.ransac.candidates[k];
    table.rows.push_back({std::to_string(k + 1), in_words(std::int64_t{c.readings}), in_words(c.score, 1),
                          c.rough ? "rough" : "smooth"});
  }
  return table;
}

HtmlSection windows_section(DepthStory& story) {
  const RansacStage& stage = story.run.ransac;
  HtmlSection section{
      .id = "windows",
      .title = "The search: windows over the whole frame",
      .paragraphs =
          {"Readings are means of cells: of four times " + std::to_string(story.run.options.ransac.cell) +
               " pixels a side first, then of twice that, then of " +
               std::to_string(story.run.options.ransac.cell) +
               ". Cells that are not flat are none. Windows of 13 x 13 cells go over them. What RANSAC finds "
               "in a window grows: the plane is fitted to the cells near it in a box four times as large, "
               "again and again, at last in the whole frame. Then its cells leave, and the search goes on "
               "with the others.",
           "First only smooth planes count, whose cells stay well within the gate; what is left may then "
           "give rough ones."},
      .figures = {add_figure(
          story, "boxes.png", show_boxes(story.run), "Numbered boxes over the frame",
          "The boxes around the readings of the " + std::to_string(shown_boxes) +
              " strongest candidates, over the pixels that are nearest to them. Thin boxes: rough planes.")},
      .facts = {{"searched", "Windows searched", in_words(std::int64_t{stage.result.windows})},
                {"draws", "Triples drawn", in_words(std::int64_t{stage.result.draws})},
                {"noise", "Gate widened for this frame's noise by", in_words(stage.result.noise, 2)},
                {"explained", "Readings that a candidate has",
                 in_words(std::int64_t{stage.result.explained}) + " of " +
                     in_words(std::int64_t{stage.result.readings})},
                {"seed", "Seed", std::to_string(stage.result.seed)}},
      .sources = {"include/straightedge/ransac_search.hpp", "src/ransac/search.cpp"}};
  if (!stage.candidates.empty()) section.tables.push_back(ransac_table(story.run));
  return section;
}

HtmlSection patch_section(DepthStory& story) {
  const HoughStage& stage = story.run.hough;
  std::int64_t unsure = 0, taken = 0;
  for (const HoughPatch& patch : stage.search.patches()) {
    unsure += patch.votes ? 0 : 1;
    taken += patch.candidate != 0 ? 1 : 0;
  }
  return {
      .id = "patches",
      .title = "Patches: a few hundred voters",
      .paragraphs =
          {"Not every pixel votes here. The frame is cut into squares, the largest first; a square whose "
           "readings do not lie on one plane is cut into four. What is flat is a patch: it knows the plane "
           "through it, and how well it knows it.",
           "Look how large patches fill walls and floors, and small ones crowd along edges. A small or "
           "far patch knows its normal so badly that its vote would be spread over half the sphere; those "
           "are crossed out and do not vote, but a plane may still take them later."},
      .figures = {add_figure(story, "patches.png", show_patches(story.run), "Squares in colours of planes",
                             "Patches, in the colour of the candidate that took them in the end. Light gray: "
                             "taken by none. Dark gray: not flat. White: by a plane that others explain as "
                             "well. Crossed out: too unsure to vote.")},
      .facts = {{"patches-count", "Patches", in_words(std::int64_t{stage.result.patches})},
                {"unsure", "Too unsure to vote", in_words(unsure)},
                {"votes", "That voted", in_words(std::int64_t{stage.result.votes})},
                {"taken", "Taken by a plane", in_words(taken)}},
      .sources = {"include/straightedge/hough_plane_patches.hpp", "src/hough/planes/patch_tree.cpp"}};
}

io::HtmlTable hough_table(const ExplainDepthRun& run) {
  io::HtmlTable table{
      "The candidates with most readings.", {"No.", "Readings", "Patches", "Votes of the peak"}, {}};
  for (std::size_t k = 0; k < run.hough.candidates.size() && k < rows_of_tables; ++k) {
    const ProposedPlane& c = run.hough.candidates[k];
    table.rows.push_back({std::to_string(k + 1), in_words(std::int64_t{c.readings}),
                          in_words(std::int64_t{c.patches}), in_words(static_cast<std::int64_t>(c.score))});
  }
  return table;
}

HtmlSection accumulator_section(DepthStory& story) {
  const HoughStage& stage = story.run.hough;
  const HoughAccumulator& accumulator = stage.search.accumulator();
  const SpherePicture sphere = show_sphere(story.run);
  return {
      .id = "accumulator",
      .title = "The accumulator: votes on the sphere of directions",
      .paragraphs =
          {"A plane is a direction, that of its normal, and a distance from the camera. The accumulator "
           "has a cell for each pair: the sphere of directions is cut into cells of equal area (the ball), "
           "and each direction has cells for the distances. A patch votes for the directions around its "
           "normal, "
           "the more sharply the better it knows it.",
           "Patches of one plane vote for one cell, wherever in the frame they lie. Parallel planes, such as "
           "two "
           "opposite walls or table and floor, share or oppose a direction; the distance tells them apart."},
      .figures =
          {add_figure(
               story, "accumulator.png", sphere.picture,
               "Heat map of votes on a disc of directions, with numbered rings",
               "The sphere of normals, seen from its middle: planes ahead are in the middle, the floor "
               "below. Brightness: cube root of the most votes of any distance. Circles: 30, 60 and "
               "90 degrees from the camera's axis. Rings: the peaks of the candidates."),
           add_figure(story, "distances.png", show_distances(story.run),
                      "Votes over distance, one row for each candidate",
                      "The votes in the direction of each ring, over the distance. Two bright spots in one "
                      "row are two parallel planes.")},
      .facts = {{"cells-of-sphere", "Cells",
                 in_words(std::int64_t{accumulator.directions().size()}) + " directions x " +
                     in_words(std::int64_t{accumulator.distances()}) + " distances of " +
                     in_words(1000 * accumulator.step_m(), 0) + " mm"},
                {"most-votes", "White stands for", in_words(std::int64_t{sphere.most_votes}) + " votes"},
                {"votes-of-reading", "Votes for each reading of a patch",
                 in_words(std::int64_t{hough_patch_vote})}},
      .sources = {"include/straightedge/hough_accumulator.hpp", "include/straightedge/hough_ball.hpp"}};
}

HtmlSection peak_section(DepthStory& story) {
  const HoughStage& stage = story.run.hough;
  HtmlSection section{
      .id = "peaks",
      .title = "Peaks grow into planes",
      .paragraphs =
          {"Peaks are looked at in turn, most votes first. The largest free patch near a peak is the seed. "
           "Its "
           "plane takes in the patches that agree with it, by a chi-square test that counts both "
           "uncertainties; it is fitted again, and takes in more, until nothing changes. Peaks that lie "
           "beside "
           "one that was used find no free patch, and end there.",
           "The detector then lets the patches that nobody took vote once more: what was hidden beside a "
           "high peak stands alone now. These pictures show the first voting."},
      .facts = {{"peaks-count", "Peaks looked at", in_words(std::int64_t{stage.peaks})},
                {"grown", "Grew into a plane", in_words(static_cast<std::int64_t>(stage.planes.size()))},
                {"kept", "Kept as candidates", in_words(static_cast<std::int64_t>(stage.candidates.size()))}},
      .sources = {"src/hough/planes/patch_growth.cpp", "src/hough/planes/patch_rivals.cpp"}};
  if (!stage.candidates.empty()) section.tables.push_back(hough_table(story.run));
  return section;
}

}  // namespace

std::vector<HtmlSection> ransac_sections(DepthStory& story) {
  return {hypotheses_section(story), windows_section(story)};
}

std::vector<HtmlSection> hough_sections(DepthStory& story) {
  return {patch_section(story), accumulator_section(story), peak_section(story)};
}

}  // namespace straightedge::cli
