// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/csv.hpp"

#include "io/number_text.hpp"
#include "straightedge/host/atomic_file.hpp"

namespace straightedge {
namespace {

template <class Value>
std::string text_or_nothing(const std::optional<Value>& value) {
  return value ? io::to_text(*value) : std::string();
}

}  // namespace

std::string line_map_to_csv(const LineMap& map) {
  std::string csv = "x0,y0,x1,y1,line,rho,theta,width,votes,pixels\n";
  for (const MapLine& line : map.lines) {
    for (const MapSegment& segment : line.segments) {
      for (const double value : {segment.x0, segment.y0, segment.x1, segment.y1})
        csv += io::to_text(value) + ",";
      csv += io::to_text(line.id) + "," + io::to_text(line.rho) + "," + io::to_text(line.theta) + ",";
      csv += text_or_nothing(line.width) + "," + text_or_nothing(line.votes) + "," +
             text_or_nothing(segment.pixels);
      csv += "\n";
    }
  }
  return csv;
}

Result<Done> write_csv(const std::filesystem::path& file, const LineMap& map) {
  return write_file_atomically(file, line_map_to_csv(map));
}

}  // namespace straightedge
