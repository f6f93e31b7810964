// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <new>

#include "io/map_xml.hpp"

namespace straightedge {

Result<MapKind> map_kind(const std::filesystem::path& file) try {
  const auto xml = io::read_bytes(file, max_map_file_bytes);
  if (!xml) return xml.failure();
  tinyxml2::XMLDocument document;
  return io::read_root(io::XmlElement(io::parse_root_tag(document, *xml)));
} catch (const io::XmlBreach& breach) {
  return Failure{Problem::bad_content, io::sentence_at(file.string(), breach.line, breach.sentence)};
} catch (const std::bad_alloc&) {
  return Failure{Problem::cannot_read, file.string() + ": does not fit into memory"};
}

}  // namespace straightedge
