// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/explain_depth_sections.hpp"

#include <cmath>
#include <iterator>
#include <utility>

#include "cli/explain_sections.hpp"
#include "io/number_text.hpp"

namespace straightedge::cli {
namespace {

using io::HtmlSection;

HtmlSection depth_section(DepthStory& story) {
  const auto& run = story.run;
  const auto pixels = static_cast<double>(run.depth.raw.width) * run.depth.raw.height;
  const double share = run.found.found.readings / pixels;
  return {
      .id = "depth",
      .title = "The depth frame",
      .paragraphs =
          {"Each pixel holds a distance, not a brightness: how far away, along the camera's axis, the first "
           "surface is that the pixel sees. Black pixels have no reading; the sensor saw nothing there, or "
           "was not sure.",
           "Look for surfaces of one smooth run of colours: these are candidates for planes. A jump of the "
           "colour is an edge of something that stands in front of something else."},
      .figures = {add_figure(
          story, "depth.png", show_depth(run, story.range), "Depth in colours, with a scale in metres",
          "Depth in metres, yellow near, violet far. The scale leaves out the nearest and the farthest "
          "hundredth.")},
      .facts = {{"size", "Pixels",
                 std::to_string(run.depth.raw.width) + " x " + std::to_string(run.depth.raw.height)},
                {"readings", "With a reading",
                 in_words(std::int64_t{run.found.found.readings}) + " (" + percent(share) + ")"},
                {"range", "Depths",
                 in_words(story.range.nearest, 2) + " to " + in_words(story.range.farthest, 2) + " m"},
                {"camera", "Camera",
                 "fx " + in_words(run.depth.camera.fx, 1) + ", fy " + in_words(run.depth.camera.fy, 1) +
                     ", cx " + in_words(run.depth.camera.cx, 1) + ", cy " + in_words(run.depth.camera.cy, 1) +
                     " pixels"}},
      .sources = {"include/straightedge/depth_view.hpp"}};
}

HtmlSection inverse_section(DepthStory& story) {
  const PlaneGate& gate = story.run.options.frame.gate;
  const auto millimetres = [&](double z) {
    return in_words(1000 * gate.inverse_noise(1 / z) * z * z, 1) + " mm at " + in_words(z, 0) + " m";
  };
  return {
      .id = "inverse-depth",
      .title = "Inverse depth: planes become straight",
      .paragraphs =
          {"All further work is done with 1/z, one over the depth. Two things get simple. Seen by "
           "a camera, a plane is 1/z = a u + b v + c, with u and v the column and row of the pixel: three "
           "numbers, and every step to the right adds the same amount. Depth itself bends.",
           "And the noise becomes the same everywhere. Such sensors measure a shift between two views, and "
           "the shift goes with 1/z. So one number says how far a reading may be off: sigma = " +
               io::to_short_text(gate.inverse_sigma) +
               " per metre. In metres that grows with the square of the depth: " + millimetres(1) + ", " +
               millimetres(2) + ", " + millimetres(4) + "."},
      .figures = {add_figure(story, "inverse-depth.png", show_inverse_depth(story.run, story.range),
                             "Inverse depth in colours, with a scale",
                             "1/z. Over a flat wall or floor the colours change in even steps; compare a "
                             "slanting one with the picture above.")},
      .sources = {"include/straightedge/inverse_depth.hpp", "include/straightedge/plane_gate.hpp"}};
}

HtmlSection cell_section(DepthStory& story) {
  HtmlSection section{
      .id = "cells",
      .title = "Cells: where is the frame flat?",
      .paragraphs =
          {"The frame is cut into squares of 32, 16, 8 and 4 pixels. For each, ten sums over its readings "
           "(1, u, v, uu, uv, vv, q, uq, vq and qq, with q = 1/z) are kept. From these follow the cell's "
           "best plane and the error of any plane, without another look at the pixels; and four small cells "
           "just add up to a large one.",
           "Here each cell is compared with its own best plane. Green cells are flat: their readings stray "
           "from it by less than 1.4 sigma. Yellow and red cells hold an edge, a "
           "corner, or something round. Large cells average much noise away but find fewer flat places; "
           "so the large ones have the first word later, and small ones settle the borders."},
      .sources = {"include/straightedge/depth_cells.hpp", "src/fit/depth_cells.cpp"}};
  for (int level = DepthCells::levels - 1; level >= 0; --level) {
    const std::string side = std::to_string(DepthCells::side << level);
    const FlatCells cells = show_flat_cells(story.run, level);
    const double share = cells.cells > 0 ? static_cast<double>(cells.flat) / cells.cells : 0;
    section.figures.push_back(add_figure(
        story, "cells-" + side + ".png", cells.picture, "Cells of " + side + " pixels, flat ones green",
        "Cells of " + side + " pixels: " + in_words(std::int64_t{cells.flat}) + " of " +
            in_words(std::int64_t{cells.cells}) + " are flat (" + percent(share) +
            "). Scale: error of the cell's own plane in sigma."));
  }
  return section;
}

void append(std::vector<HtmlSection>& sections, std::vector<HtmlSection> more) {
  sections.insert(sections.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace

io::HtmlFigure add_figure(DepthStory& story, const std::string& file, const Image<Rgb>& picture,
                          const std::string& alt, const std::string& caption) {
  story.files.add(file, picture);
  return {file, alt, caption, picture.size()};
}

std::string counted(std::int64_t count, const std::string& what) {
  return in_words(count) + " " + what + (count == 1 ? "" : "s");
}

std::string percent(double share) {
  return in_words(100 * share, 1) + " %";
}

std::string side_of(const Vector3& n) {
  const double x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
  if (z >= x && z >= y) return "ahead";
  if (y >= x) return n.y > 0 ? "below" : "above";
  return n.x > 0 ? "right" : "left";
}

std::string in_words(const Vector3& v) {
  constexpr const char* comma = ",\u00a0";  // a table's cell is not to break in it
  return in_words(v.x, 3) + comma + in_words(v.y, 3) + comma + in_words(v.z, 3);
}

std::vector<HtmlSection> input_sections(DepthStory& story) {
  return {depth_section(story), inverse_section(story), cell_section(story)};
}

io::HtmlPage page_of(DepthStory& story) {
  const auto& found = story.run.found.found;
  const bool ransac = story.run.options.method == PlaneMethod::ransac;
  const double share = found.readings > 0 ? static_cast<double>(found.labelled) / found.readings : 0;
  io::HtmlPage page;
  page.title = "From depth frame to planes: " + story.options.input;
  page.introduction = {
      "This page follows one depth frame through every stage of finding its planes. Each stage shows what it "
      "left behind, says in a few sentences what it does, and gives the numbers of this frame. Click a "
      "picture to see its pixels."};
  page.facts = {
      {"input", "Frame", story.options.input},
      {"method", "Method", ransac ? "ransac" : "hough"},
      {"result", "Result", counted(found.planes, "plane") + " on " + percent(share) + " of the readings"}};
  page.sections = input_sections(story);
  append(page.sections, ransac ? ransac_sections(story) : hough_sections(story));
  append(page.sections, labelling_sections(story));
  append(page.sections, result_sections(story));
  append(page.sections, octree_sections(story));
  page.footer = "Made by straightedge " + story.options.version + ".";
  return page;
}

}  // namespace straightedge::cli
