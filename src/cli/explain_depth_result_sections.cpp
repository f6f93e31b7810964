// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <string>

#include "cli/explain_depth_sections.hpp"
#include "cli/explain_sections.hpp"
#include "straightedge/trigonometry.hpp"

namespace straightedge::cli {
namespace {

using io::HtmlSection;

HtmlSection candidate_section(DepthStory& story) {
  std::int64_t near = 0;
  for (std::int32_t y = 0; y < story.run.nearest.height(); ++y) {
    for (std::int32_t x = 0; x < story.run.nearest.width(); ++x)
      near += story.run.nearest.at(x, y) != 0 ? 1 : 0;
  }
  HtmlSection section{
      .id = "candidates",
      .title = "Candidate planes",
      .paragraphs =
          {"A candidate goes on for ever: it is a plane without borders. Here each pixel has the colour of "
           "the "
           "candidate nearest to it, if one is within the gate of " +
               in_words(story.run.options.frame.gate.sigmas, 1) + " sigma.",
           "Look for stripes and specks of a foreign colour: there a plane cuts through another one, or "
           "through "
           "something that is no plane at all. Giving each pixel its nearest plane is not enough; the "
           "next stage mends it."},
      .figures = {add_figure(
          story, "candidates.png", show_candidates(story.run),
          "Pixels in the colours of their nearest candidates",
          "The nearest candidate of each pixel; the strongest have numbers. Gray: near to none. "
          "Black: no reading.")},
      .facts = {{"candidates-count", "Candidates",
                 in_words(static_cast<std::int64_t>(story.run.candidates.size()))},
                {"near", "Pixels near to one", in_words(near)}},
      .sources = {"include/straightedge/plane_search.hpp"}};
  if (story.run.candidates.empty())
    section.paragraphs = {"The search found no candidate: there is no plane in this frame."};
  return section;
}

HtmlSection cell_label_section(DepthStory& story) {
  HtmlSection section{
      .id = "cell-labels",
      .title = "Cells take planes, coarse to fine",
      .paragraphs =
          {"Cells of 32 pixels choose first: each takes the plane that fits all of its readings, if one "
           "does. A "
           "cell half as large looks at the planes around it, and takes one of them if it fits; only else it "
           "asks "
           "all others. So a plane that cuts through the wall behind it gets no stripe there: the wall's "
           "cells "
           "have their wall already.",
           "Then planes are fitted anew to their cells, those that are one plane are joined, stripes along "
           "creases and strips of round things leave, and the search runs once more on what is left over. "
           "These are the labels after the last such round, in the colours of the final planes."},
      .sources = {"include/straightedge/frame_planes.hpp", "src/fit/cell_labels.cpp"}};
  for (int level = DepthCells::levels - 1; level >= 0; --level) {
    const std::string side = std::to_string(DepthCells::side << level);
    const LabelledCells cells = show_cell_labels(story.run, level);
    const auto all = DepthCells::cell_count(DepthCells::size_of(story.run.depth.raw.size(), level));
    section.figures.push_back(add_figure(story, "cell-labels-" + side + ".png", cells.picture,
                                         "Cells of " + side + " pixels with their planes",
                                         "Cells of " + side +
                                             " pixels: " + in_words(std::int64_t{cells.labelled}) + " of " +
                                             in_words(static_cast<std::int64_t>(all)) +
                                             " have a plane. Gray: none fits. White: its plane left."));
  }
  return section;
}

HtmlSection label_section(DepthStory& story) {
  const PlanesFound& found = story.run.found.found;
  const std::int64_t free = std::int64_t{found.readings} - found.labelled;
  return {
      .id = "labels",
      .title = "Pixels take planes",
      .paragraphs =
          {"Where all cells around agree, a pixel gets their plane if it lies within the gate. At borders it "
           "goes to "
           "the nearest of the planes around, judged by the mean over its 3 x 3 neighbours, so that noise "
           "does not "
           "fray the border. Then each plane is fitted a last time, to exactly the pixels that it has; those "
           "with too few leave."},
      .figures = {add_figure(
          story, "labels.png", show_labels(story.run), "Pixels in the colours of their planes",
          "The result. Numbers are those of the table below; farther pixels are darker. Gray: on "
          "no plane. Black: no reading.")},
      .facts = {{"planes", "Planes", in_words(std::int64_t{found.planes})},
                {"labelled", "Readings on a plane", in_words(std::int64_t{found.labelled})},
                {"free", "Readings on none", in_words(free)}},
      .sources = {"src/fit/pixel_labels.cpp", "src/fit/frame_planes.cpp"}};
}

HtmlSection residual_section(DepthStory& story) {
  const Residuals residuals = show_residuals(story.run);
  return {
      .id = "residuals",
      .title = "What the planes do not explain",
      .paragraphs =
          {"The residual of a reading is how far its 1/z is from that of its plane, in units of sigma. If "
           "the "
           "noise is what we think, two readings of three lie within one sigma, and the picture shows "
           "fine speckle without shape.",
           "Shapes tell more: slow waves are the sensor's own distortion, a plane that is blue at one end "
           "and "
           "red at the other is bent or tilted by something it should not have, and a rim of one colour is "
           "a border drawn too wide."},
      .figures = {add_figure(
          story, "residuals.png", residuals.picture, "Residuals from blue by white to red",
          "Red: nearer to the camera than its plane; blue: farther; white: on it. The scale ends "
          "at three sigma. Gray: on no plane.")},
      .facts = {{"residual-rms", "Root mean square of all", in_words(residuals.rms, 2) + " sigma"},
                {"residual-within", "Within one sigma", percent(residuals.within)}},
      .sources = {"include/straightedge/plane_gate.hpp"}};
}

/// The larger of the two errors of the normal, degrees.
double angle_error(const PlaneFit& fit) {
  const double uu = fit.covariance[0], uv = fit.covariance[1], vv = fit.covariance[3];
  const double spread = std::hypot(uu - vv, 2 * uv);
  return std::sqrt(std::max(0.0, (uu + vv + spread) / 2)) / degree;
}

io::HtmlTable plane_table(const ExplainDepthRun& run) {
  io::HtmlTable table{
      "Planes in the camera's frame: x right, y down, z forward; normals point away from the camera.",
      {"No.", "Lies", "Pixels", "Normal", "Distance (m)", "rms (mm)", "Angle (\u00b0)", "Offset (mm)"},
      {}};
  for (std::size_t k = 0; k < run.found.planes.size(); ++k) {
    const FoundPlane& plane = run.found.planes[k];
    const Vector3& n = plane.fit.plane.normal;
    table.rows.push_back({std::to_string(k + 1), side_of(n), in_words(std::int64_t{plane.inliers}),
                          in_words(n), in_words(plane.fit.plane.distance, 3),
                          in_words(1000 * plane.fit.rms, 1), "\u00b1 " + in_words(angle_error(plane.fit), 2),
                          "\u00b1 " + in_words(1000 * std::sqrt(plane.fit.covariance[5]), 1)});
  }
  return table;
}

HtmlSection table_section(DepthStory& story) {
  HtmlSection section{
      .id = "planes-table",
      .title = "The planes in numbers",
      .paragraphs = {"A plane is n x = d: its normal n and its distance d from the camera. rms says how far "
                     "its readings "
                     "scatter around it, in millimetres; far planes scatter more, because the noise grows "
                     "with the square "
                     "of the depth. Angle and offset are standard errors of the normal and of d: what the "
                     "readings' noise "
                     "alone leaves unknown. Small planes seen at a slant are the least certain."},
      .sources = {"include/straightedge/found_planes.hpp", "include/straightedge/plane_fit.hpp"}};
  if (story.run.found.planes.empty()) {
    section.paragraphs = {"No plane was found, so there are no numbers."};
  } else {
    section.tables.push_back(plane_table(story.run));
  }
  return section;
}

HtmlSection map_section(DepthStory& story) {
  const auto planes = static_cast<std::int64_t>(story.run.map.planes.size());
  return {.id = "map",
          .title = "The planes in space",
          .paragraphs = {"Back from the picture into the room: each plane with its extent, as a plan from "
                         "above and as a view "
                         "from a corner, in the colours and with the numbers of the labels. Planes that are "
                         "one within their "
                         "uncertainty are joined, and have the lowest of their numbers.",
                         "A map of many frames is made the same way, by the command planes. It drops planes "
                         "of which it is not "
                         "sure; here all are shown."},
          .figures = {{.file = "map.svg",
                       .alt = "Plan and oblique view of the planes",
                       .caption =
                           "Left: from above, walls as thick lines. Right: obliquely from above. The camera "
                           "stands at the small mark.",
                       .size = {}}},
          .facts = {{"map-planes", "Planes drawn", in_words(planes)}},
          .sources = {"include/straightedge/host/plane_map_builder.hpp"}};
}

}  // namespace

std::vector<HtmlSection> labelling_sections(DepthStory& story) {
  return {candidate_section(story), cell_label_section(story), label_section(story)};
}

std::vector<HtmlSection> result_sections(DepthStory& story) {
  return {residual_section(story), table_section(story), map_section(story)};
}

}  // namespace straightedge::cli
