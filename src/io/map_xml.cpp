// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "io/map_xml.hpp"

#include "straightedge/host/atomic_file.hpp"

namespace straightedge::io {
namespace {

constexpr const char* to_text(MapKind kind) noexcept {
  return kind == MapKind::lines ? "lines" : "planes";
}

}  // namespace

MapKind read_root(const XmlElement& root) {
  if (root.name() != "map" || root.text("format").value_or("") != "straightedge-map") {
    throw XmlBreach{root.line(), "is not a straightedge-map"};
  }
  const int version = root.required_number<int>("version");
  if (version > map_format_version) {
    throw XmlBreach{root.line(), "was written by a newer version (format version " + std::to_string(version) +
                                     ", and up to " + std::to_string(map_format_version) + " is read here)"};
  }
  if (version < 1) root.refuse("the format's version is below 1");
  const std::string kind = root.required_text("kind");
  for (const MapKind known : {MapKind::lines, MapKind::planes}) {
    if (kind == to_text(known)) return known;
  }
  root.refuse("`kind` is neither \"lines\" nor \"planes\"");
}

void require_kind(const XmlElement& root, MapKind wanted) {
  const MapKind kind = read_root(root);
  if (kind == wanted) return;
  throw XmlBreach{root.line(), std::string("is a map of ") + to_text(kind) + " where a map of " +
                                   to_text(wanted) + " is wanted"};
}

MapMeta read_meta(const XmlElement& element) {
  MapMeta meta;
  meta.name = element.text("name").value_or("");
  meta.created = element.text("created").value_or("");
  meta.tool = element.text("tool").value_or("");
  meta.options = element.text("options").value_or("");
  meta.description = element.text("description").value_or("");
  return meta;
}

void open_map(XmlWriter& writer, MapKind kind, const MapMeta& meta) {
  writer.declaration();
  writer.open("map");
  writer.attribute("format", "straightedge-map");
  writer.attribute("version", map_format_version);
  writer.attribute("kind", to_text(kind));
  if (meta == MapMeta{}) return;
  writer.open("meta");
  writer.attribute_unless_empty("name", meta.name);
  writer.attribute_unless_empty("created", meta.created);
  writer.attribute_unless_empty("tool", meta.tool);
  writer.attribute_unless_empty("options", meta.options);
  writer.attribute_unless_empty("description", meta.description);
  writer.close();
}

std::string sentence_at(const std::string& name, int line, const std::string& sentence) {
  return name + ":" + std::to_string(line) + ": " + sentence;
}

Result<Done> write_map_text(const std::filesystem::path& file, const Result<std::string>& xml) {
  if (!xml) return Failure{xml.failure().problem, file.string() + ": " + xml.failure().sentence};
  return write_file_atomically(file, *xml);
}

}  // namespace straightedge::io
