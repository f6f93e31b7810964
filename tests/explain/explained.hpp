// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <tinyxml2.h>

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "cli/explain_image.hpp"
#include "io/temporary_folder.hpp"
#include "straightedge/host/image_file.hpp"
#include "support/catch.hpp"

namespace explained {

inline straightedge::Image<std::uint8_t> fixture(const std::string& name) {
  auto image = straightedge::read_gray_image(std::filesystem::path(STRAIGHTEDGE_FIXTURES) / name);
  REQUIRE(image);
  return std::move(*image);
}

/// What a program can read off the page.
struct Page {
  std::map<std::string, std::string> facts;  ///< text of every element with an id
  std::set<std::string> pictures;            ///< sources of the images
  std::set<std::string> links;               ///< targets of the links
  std::map<std::string, int> elements;       ///< how many there are of a name
  std::string text;                          ///< all of it
  int tables_rows = 0;
};

inline std::string text_of(const tinyxml2::XMLNode& node) {
  std::string text;
  if (node.ToText() != nullptr) text += node.Value();
  for (const auto* child = node.FirstChild(); child != nullptr; child = child->NextSibling())
    text += text_of(*child);
  return text;
}

inline void collect(const tinyxml2::XMLElement& element, Page& page) {
  ++page.elements[element.Name()];
  if (const char* id = element.Attribute("id")) {
    CHECK(page.facts.emplace(id, text_of(element)).second);  // an id must be the only one of its kind
  }
  if (const char* source = element.Attribute("src")) page.pictures.insert(source);
  if (const char* target = element.Attribute("href")) page.links.insert(target);
  for (const auto* child = element.FirstChildElement(); child != nullptr; child = child->NextSiblingElement())
    collect(*child, page);
}

/// Reads the page as XML; fails the test when it is not well-formed.
inline Page read_page(const std::filesystem::path& file) {
  const std::string bytes = bytes_of(file);
  tinyxml2::XMLDocument document;
  REQUIRE(document.Parse(bytes.data(), bytes.size()) == tinyxml2::XML_SUCCESS);
  REQUIRE(document.RootElement() != nullptr);
  Page page;
  collect(*document.RootElement(), page);
  page.text = bytes;
  return page;
}

/// The number without the narrow blanks between its thousands.
inline std::string digits(std::string text) {
  for (std::size_t at; (at = text.find("\u202f")) != std::string::npos;) text.erase(at, 3);
  return text;
}

inline const std::set<std::string> photo_pictures = {
    "gray.png",        "blurred.png",         "gradient-x.png", "gradient-y.png",  "magnitude.png",
    "direction.png",   "direction-wheel.png", "suppressed.png", "strong-weak.png", "edges.png",
    "accumulator.png", "peaks.png",           "segments.png",   "lines.png"};
inline const std::set<std::string> progress_pictures = {"progress-1.png", "progress-2.png", "progress-3.png",
                                                        "progress-4.png"};

}  // namespace explained
