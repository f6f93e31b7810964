// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "straightedge/image.hpp"

namespace straightedge::io {

/// A picture of the page, a file beside it.
struct HtmlFigure {
  std::string file;
  std::string alt;      ///< what it shows, for those who cannot see it
  std::string caption;  ///< below it
  Size size;
};

/// A number of the run, with an id of its own by which programs find it.
struct HtmlFact {
  std::string id;
  std::string label;
  std::string value;
};

struct HtmlTable {
  std::string caption;
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
};

struct HtmlSection {
  std::string id;
  std::string title;
  std::vector<std::string> paragraphs = {};
  std::vector<HtmlFigure> figures = {};
  std::vector<HtmlFact> facts = {};
  std::vector<HtmlTable> tables = {};
  std::vector<std::string> sources = {};  ///< files of the project where one reads on
};

struct HtmlPage {
  std::string title;
  std::vector<std::string> introduction = {};
  std::vector<HtmlFact> facts = {};  ///< of the whole run, below the introduction
  std::vector<HtmlSection> sections = {};
  std::string footer;
};

/// The page as a text that is HTML 5 and well-formed XML at once; every text is escaped. Styles and the few
/// lines of script are in it: it needs no network. Without script a click opens the picture's file, with it a
/// view in which pixels can be enlarged. Bytes that are not UTF-8 become U+FFFD (xml_text.hpp).
std::string html_from_page(const HtmlPage& page);

}  // namespace straightedge::io
