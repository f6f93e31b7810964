// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/map_input.hpp"

#include "io/number_text.hpp"
#include "io/read_bytes.hpp"
#include "straightedge/host/map_file.hpp"
#include "straightedge/host/plane_map_file.hpp"

namespace straightedge::cli {
namespace {

struct Counts {
  const char* what;
  std::size_t features;
  const char* part;
  std::size_t parts;
};

Counts count(const AnyMap& map) {
  std::size_t parts = 0;
  if (const auto* lines = std::get_if<LineMap>(&map)) {
    for (const MapLine& line : lines->lines) parts += line.segments.size();
    return {"lines", lines->lines.size(), "segments", parts};
  }
  const auto& planes = std::get<PlaneMap>(map).planes;
  for (const MapPlane& plane : planes) parts += plane.polygons.size();
  return {"planes", planes.size(), "polygons", parts};
}

template <class Map>
Result<AnyMap> any(Result<Map> map) {
  if (!map) return map.failure();
  return AnyMap(std::move(*map));
}

}  // namespace

Result<AnyMap> read_any_map(const std::filesystem::path& file) {
  const auto xml = io::read_bytes(file, max_map_file_bytes);
  if (!xml) return xml.failure();
  const auto kind = map_kind_from_xml(*xml, file.string());
  if (!kind) return kind.failure();
  return *kind == MapKind::lines ? any(line_map_from_xml(*xml, file.string()))
                                 : any(plane_map_from_xml(*xml, file.string()));
}

std::string words_of(const AnyMap& map) {
  const Counts counts = count(map);
  return io::to_text(counts.features) + " " + counts.what + ", " + io::to_text(counts.parts) + " " +
         counts.part;
}

void add_counts(nlohmann::ordered_json& numbers, const AnyMap& map) {
  const Counts counts = count(map);
  numbers[counts.what] = counts.features;
  numbers[counts.part] = counts.parts;
}

}  // namespace straightedge::cli
