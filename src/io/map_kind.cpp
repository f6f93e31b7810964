// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <new>

#include "io/map_xml.hpp"

namespace straightedge {

Result<MapKind> map_kind_from_xml(const std::string& xml, const std::string& name) try {
  tinyxml2::XMLDocument document;
  return io::read_root(io::XmlElement(io::parse_root_tag(document, xml)));
} catch (const io::XmlBreach& breach) {
  return Failure{Problem::bad_content, io::sentence_at(name, breach.line, breach.sentence)};
} catch (const std::bad_alloc&) {
  return Failure{Problem::cannot_read, name + ": does not fit into memory"};
}

Result<MapKind> map_kind(const std::filesystem::path& file) {
  const auto xml = io::read_bytes(file, max_map_file_bytes);
  return xml ? map_kind_from_xml(*xml, file.string()) : xml.failure();
}

}  // namespace straightedge
