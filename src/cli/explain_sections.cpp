// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/explain_sections.hpp"

#include <cmath>
#include <iterator>

#include "io/number_text.hpp"

namespace straightedge::cli {

std::string in_words(double value, int decimals) {
  if (std::isnan(value)) return "not used";
  if (std::isinf(value)) return value > 0 ? "infinite" : "-infinite";
  std::string text = io::to_text(value, decimals);
  while (text.find('.') != std::string::npos && (text.back() == '0' || text.back() == '.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string in_words(std::int64_t value) {
  // Narrow blanks between thousands: a comma or a dot means different things in different countries.
  std::string text = std::to_string(value);
  if (text.size() < 5) return text;
  for (std::size_t at = text.size(); at > 3;) text.insert(at -= 3, "\u202f");
  return text;
}

std::string progress_file(std::size_t n) {
  return std::string("progress-").append(std::to_string(n + 1)).append(".png");
}

io::HtmlFigure stage_figure(const ExplainStory& story, const char* file, const char* alt,
                            const char* caption) {
  const Size size = story.run.edges.size();
  return {file, alt, caption, {size.width * story.scale.zoom, size.height * story.scale.zoom}};
}

io::HtmlPage page_of(const ExplainStory& story) {
  const bool map = story.run.picture.kind == PictureKind::map;
  io::HtmlPage page;
  page.title = "From picture to line map: " + story.options.input;
  page.introduction = {
      "This page follows one picture through every stage of Straightedge. Each stage shows what it left "
      "behind, "
      "says in a few sentences what it does, and gives the numbers of this run. Click a picture to see its "
      "pixels."};
  page.facts = {{"input", "Picture", story.options.input},
                {"kind", "Taken for", map ? "a map" : "a photo"},
                {"result", "Result",
                 in_words(std::int64_t{story.run.lines.report.lines}) + " lines with " +
                     in_words(std::int64_t{story.run.lines.report.segments}) + " segments"}};
  if (story.scale.zoom > 1) {
    page.facts.push_back(
        {"zoom", "Pictures are", in_words(std::int64_t{story.scale.zoom}) + " times enlarged"});
  }
  page.sections = edge_sections(story);
  auto rest = line_sections(story);
  page.sections.insert(page.sections.end(), std::make_move_iterator(rest.begin()),
                       std::make_move_iterator(rest.end()));
  page.footer = "Made by straightedge " + story.options.version + ".";
  return page;
}

}  // namespace straightedge::cli
