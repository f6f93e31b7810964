// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <tinyxml2.h>

#include <filesystem>
#include <new>
#include <string>
#include <vector>

#include "io/read_bytes.hpp"
#include "io/xml_document.hpp"
#include "io/xml_element.hpp"
#include "io/xml_writer.hpp"
#include "straightedge/host/map_file.hpp"
#include "straightedge/host/plane_map_file.hpp"

/// What the files of line maps and of plane maps have in common.
namespace straightedge::io {

/// The kind that a root element states. Throws XmlBreach for other documents, versions and kinds.
MapKind read_root(const XmlElement& root);
void require_kind(const XmlElement& root, MapKind wanted);

MapMeta read_meta(const XmlElement& element);

/// The declaration, the root's start and `meta`; the caller closes the root.
void open_map(XmlWriter& writer, MapKind kind, const MapMeta& meta);

/// "m.xml:12: line 3: ..."
std::string sentence_at(const std::string& name, int line, const std::string& sentence);

/// Writes a map's text, or says for which file there is none.
Result<Done> write_map_text(const std::filesystem::path& file, const Result<std::string>& xml);

/// A `Reading` is a map and where its elements stand in the text: `map`, `read(root)`, which throws
/// XmlBreach, `check()`, the breaches of the map's rules, and `line_of(breach)`.
template <class Reading>
Result<Reading> read_map_text(const std::string& xml, const std::string& name) try {
  if (xml.size() > max_map_file_bytes) return Failure{Problem::bad_content, name + ": is longer than 256 MB"};
  tinyxml2::XMLDocument document;
  Reading reading;
  reading.read(parse_document(document, xml));
  return reading;
} catch (const XmlBreach& breach) {
  return Failure{Problem::bad_content, sentence_at(name, breach.line, breach.sentence)};
} catch (const std::bad_alloc&) {
  return Failure{Problem::cannot_read, name + ": does not fit into memory"};
}

template <class Reading>
auto map_from_xml(const std::string& xml, const std::string& name) -> Result<decltype(Reading::map)> {
  auto reading = read_map_text<Reading>(xml, name);
  if (!reading) return reading.failure();
  if (const auto breaches = reading->check(); !breaches.empty()) {
    const auto& first = breaches.front();
    return Failure{Problem::bad_content, sentence_at(name, reading->line_of(first), first.sentence)};
  }
  return std::move(reading->map);
}

template <class Reading>
auto read_map_file(const std::filesystem::path& file) -> Result<decltype(Reading::map)> {
  const auto xml = read_bytes(file, max_map_file_bytes);
  if (!xml) return xml.failure();
  return map_from_xml<Reading>(*xml, file.string());
}

template <class Reading>
Result<std::vector<std::string>> validate_map_file(const std::filesystem::path& file) {
  const auto xml = read_bytes(file, max_map_file_bytes);
  if (!xml) return xml.failure();
  const auto reading = read_map_text<Reading>(*xml, file.string());
  if (!reading) return reading.failure();
  std::vector<std::string> sentences;
  for (const auto& breach : reading->check()) {
    sentences.push_back(sentence_at(file.string(), reading->line_of(breach), breach.sentence));
  }
  return sentences;
}

}  // namespace straightedge::io
