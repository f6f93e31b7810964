// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <string>

#include "cli/explain_sections.hpp"

namespace straightedge::cli {
namespace {

using io::HtmlSection;

std::string size_text(Size size) {
  return in_words(std::int64_t{size.width}) + " x " + in_words(std::int64_t{size.height}) + " pixels";
}

std::string taps_text(const std::vector<std::uint16_t>& taps) {
  std::string text;
  for (const std::uint16_t tap : taps) text.append(text.empty() ? "" : " ").append(std::to_string(tap));
  return text;
}

HtmlSection gray_section(const ExplainStory& story) {
  return {.id = "gray",
          .title = "Gray",
          .paragraphs =
              {"Everything begins with one number for each pixel: 0 is black, 255 is white. A picture in "
               "colour is made gray first, with .299 of its red, .587 of its green and .114 of its blue, "
               "about as bright as the eye sees them."},
          .figures = {stage_figure(story, "gray.png", "The picture in gray", "The picture in gray.")},
          .facts = {{"size", "Size", size_text(story.run.edges.size())}},
          .sources = {"include/straightedge/gray.hpp", "src/canny/gray.cpp"}};
}

HtmlSection ground_section(const ExplainStory& story) {
  return {
      .id = "ground",
      .title = "What counts as ground is white",
      .paragraphs =
          {"This picture was taken for a map: dark walls on lighter ground. All that is at least as light as "
           "the "
           "darkest ground becomes white, and the darkest level becomes black.",
           "So the border between free floor and unknown space is no edge any more, nor is a laser ray that "
           "was drawn into unknown space. What is left to find are walls. The stages below work on this "
           "picture."},
      .figures = {stage_figure(story, "ground.png", "The map with all ground in white and walls in black",
                               "Ground in white, walls dark.")},
      .facts = {{"ground-level", "Darkest level of ground", in_words(story.run.picture.ground, 0)}},
      .sources = {"src/map/picture.hpp", "src/map/picture.cpp"}};
}

HtmlSection blur_section(const ExplainStory& story) {
  const CannyOptions& options = story.options.lines.canny;
  HtmlSection section{
      .id = "blur",
      .title = "Blur",
      .paragraphs =
          {"Noise changes from pixel to pixel, an edge goes on for many. A blur evens out the first and "
           "leaves most of the second. Each pixel becomes the mean of those around it, weighted by a "
           "Gaussian bell of width sigma.",
           "The weights are whole numbers that add up to 256. They are applied down the columns, then "
           "along the rows; together that is the round bell, for far less work."},
      .figures = {stage_figure(story, "blurred.png", "The picture after the blur", "After the blur.")},
      .facts = {{"sigma", "sigma", in_words(options.sigma, 2) + " pixels"},
                {"taps", "Weights, in 1/256", taps_text(story.run.taps)}},
      .sources = {"include/straightedge/gaussian.hpp", "src/canny/gaussian.cpp"}};
  if (story.run.taps.size() == 1)
    section.paragraphs.emplace_back("In this run sigma is 0: nothing was blurred.");
  return section;
}

HtmlSection gradient_section(const ExplainStory& story) {
  return {.id = "gradient",
          .title = "Gradient",
          .paragraphs =
              {"How fast does the gray value change, to the right and downwards? Sobel's operator answers "
               "with two numbers for each pixel: dx is right minus left, dy is below minus above. Both "
               "look at a few pixels across, too, so that noise counts less.",
               "Middle gray is no change. Lighter means that the picture gets lighter in that direction, "
               "darker that it gets darker."},
          .figures = {stage_figure(story, "gradient-x.png", "Change of the gray value to the right",
                                   "dx: change to the right. Upright edges show."),
                      stage_figure(story, "gradient-y.png", "Change of the gray value downwards",
                                   "dy: change downwards. Level edges show.")},
          .facts = {{"aperture", "Side of the operator",
                     in_words(std::int64_t{story.options.lines.canny.aperture})},
                    {"gradient-scale", "Black and white stand for",
                     in_words(-story.scale.full_length, 0) + " and " + in_words(story.scale.full_length, 0)}},
          .sources = {"include/straightedge/sobel.hpp", "src/canny/sobel.cpp"}};
}

HtmlSection magnitude_section(const ExplainStory& story) {
  const bool l1 = story.options.lines.canny.norm == GradientNorm::l1;
  return {
      .id = "magnitude",
      .title = "Magnitude",
      .paragraphs =
          {"dx and dy together are an arrow that points to where it gets lighter. Its length is the "
           "magnitude: large on an edge, near 0 where nothing happens.",
           "Each edge makes a ridge a few pixels wide. The line that we look for is the crest of "
           "that ridge."},
      .figures = {stage_figure(
          story, "magnitude.png", "Length of the gradient, bright along edges",
          "Length of the gradient. One pixel in a hundred is longer than what is white.")},
      .facts = {{"norm", "Length is", l1 ? "|dx| + |dy|" : "the root of dx\u00b2 + dy\u00b2"},
                {"magnitude-scale", "White stands for", in_words(story.scale.full_length, 0) + " or more"}},
      .sources = {"include/straightedge/magnitude.hpp", "src/canny/magnitude.cpp"}};
}

HtmlSection direction_section(const ExplainStory& story) {
  return {
      .id = "direction",
      .title = "Direction",
      .paragraphs =
          {"The same arrow has a direction. Here it is a colour, and the magnitude is its brightness. "
           "A straight edge has one colour all along, which is what tells it from a curve. The two "
           "sides of a wall have opposite colours on the wheel.",
           "The next stage asks only which of four directions is nearest: level, upright, or one of "
           "the diagonals."},
      .figures = {stage_figure(story, "direction.png", "Edges in the colours of their direction",
                               "Direction as colour, magnitude as brightness."),
                  {.file = "direction-wheel.png",
                   .alt = "Wheel of colours: red points right, blue-green left, yellow-green down, violet up",
                   .caption = "The way to the lighter side.",
                   .size = direction_wheel().size()}},
      .sources = {"include/straightedge/suppress.hpp"}};
}

HtmlSection suppression_section(const ExplainStory& story) {
  return {.id = "suppression",
          .title = "Suppression: only the crest is kept",
          .paragraphs =
              {"A pixel stays only if its magnitude is larger than that of its two neighbours across the "
               "edge, those that the arrow points at and away from. Ridges become lines one pixel wide.",
               "The picture shows all crests, before any threshold. The faint ones are noise and "
               "texture."},
          .figures = {stage_figure(story, "suppressed.png", "Thin crests of the magnitude",
                                   "Crests, as bright as their magnitude.")},
          .facts = {{"crests", "Crest pixels", in_words(std::int64_t{story.run.crest_count})}},
          .sources = {"include/straightedge/suppress.hpp", "src/canny/suppress.cpp"}};
}

HtmlSection threshold_section(const ExplainStory& story) {
  const bool automatic = story.options.lines.canny.thresholds == CannyThresholds::automatic;
  const char* origin = automatic ? "from the noise in the picture" : "as given";
  return {.id = "thresholds",
          .title = "Two thresholds",
          .paragraphs =
              {"One threshold is always wrong: set low it lets noise in, set high it breaks edges to "
               "pieces. So there are two. Crest pixels above the high one are strong, those between the "
               "two are weak, the rest are gone."},
          .figures = {stage_figure(story, "strong-weak.png", "Strong pixels in yellow, weak pixels in blue",
                                   "Yellow: strong. Blue: weak.")},
          .facts = {{"thresholds-from", "Thresholds", origin},
                    {"low", "low", in_words(story.run.canny_result.low, 2)},
                    {"high", "high", in_words(story.run.canny_result.high, 2)},
                    {"strong", "Strong pixels", in_words(std::int64_t{story.run.canny_result.strong})},
                    {"weak", "Weak pixels", in_words(std::int64_t{story.run.weak_count})}},
          .sources = {"include/straightedge/thresholds.hpp", "src/canny/suppress.cpp"}};
}

HtmlSection hysteresis_section(const ExplainStory& story) {
  const CannyResult& result = story.run.canny_result;
  const std::int64_t kept = std::int64_t{result.edges} - result.strong;
  return {
      .id = "edges",
      .title = "Edges",
      .paragraphs =
          {"Weak pixels count where they hang together with strong ones. From each strong pixel a flood "
           "fill walks over its eight neighbours, on from those, and so forth; what it reaches is an "
           "edge.",
           "This is the end of Canny's edge detector. From here on a picture is a set of pixels, and "
           "the question is which of them lie on lines."},
      .figures = {stage_figure(story, "edges.png", "Edges, white on black", "Edge pixels.")},
      .facts = {{"edges-count", "Edge pixels", in_words(std::int64_t{result.edges})},
                {"weak-kept", "Weak pixels that stayed",
                 in_words(kept) + " of " + in_words(std::int64_t{story.run.weak_count})}},
      .sources = {"include/straightedge/hysteresis.hpp", "src/canny/hysteresis.cpp", "src/canny/canny.cpp"}};
}

}  // namespace

std::vector<HtmlSection> edge_sections(const ExplainStory& story) {
  std::vector<HtmlSection> sections = {gray_section(story)};
  if (story.run.picture.kind == PictureKind::map) sections.push_back(ground_section(story));
  for (const auto make : {blur_section, gradient_section, magnitude_section, direction_section,
                          suppression_section, threshold_section, hysteresis_section}) {
    sections.push_back(make(story));
  }
  return sections;
}

}  // namespace straightedge::cli
