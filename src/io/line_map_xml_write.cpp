// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <new>
#include <string>

#include "io/map_xml.hpp"
#include "io/ros_mode_text.hpp"
#include "io/side_text.hpp"

namespace straightedge {
namespace {

using io::XmlWriter;

void write_frame(XmlWriter& writer, MapUnit unit) {
  writer.open("frame");
  writer.attribute("origin", unit == MapUnit::pixel ? "image-centre" : "world");
  writer.attribute("x", "right");
  writer.attribute("y", "up");
  writer.attribute("unit", unit == MapUnit::pixel ? "pixel" : "metre");
  writer.attribute("angle", "radian");
  writer.close();
}

void write_image(XmlWriter& writer, const MapImage& image) {
  writer.open("image");
  writer.attribute("file", image.file);
  writer.attribute("width", image.size.width);
  writer.attribute("height", image.size.height);
  if (image.placement) {
    writer.attribute("resolution", image.placement->resolution);
    writer.attribute("origin-x", image.placement->origin_x);
    writer.attribute("origin-y", image.placement->origin_y);
    writer.attribute("origin-yaw", image.placement->origin_yaw);
  }
  if (image.meaning) {
    writer.attribute("negate", image.meaning->negate ? 1 : 0);
    writer.attribute("occupied-thresh", image.meaning->occupied_thresh);
    writer.attribute("free-thresh", image.meaning->free_thresh);
    writer.attribute("mode", io::to_text(image.meaning->mode));
  }
  writer.close();
}

void write_covariance(XmlWriter& writer, const LineCovariance& covariance) {
  writer.open("covariance");
  writer.attribute("at-x", covariance.at_x);
  writer.attribute("at-y", covariance.at_y);
  writer.attribute("var-theta", covariance.var_theta);
  writer.attribute("var-offset", covariance.var_offset);
  writer.close();
}

void write_segment(XmlWriter& writer, const MapSegment& segment) {
  writer.open("segment");
  writer.attribute("id", segment.id);
  writer.attribute("x0", segment.x0);
  writer.attribute("y0", segment.y0);
  writer.attribute("x1", segment.x1);
  writer.attribute("y1", segment.y1);
  writer.attribute("pixels", segment.pixels);
  writer.close();
}

void write_line(XmlWriter& writer, const MapLine& line) {
  writer.open("line");
  writer.attribute("id", line.id);
  writer.attribute("rho", line.rho);
  writer.attribute("theta", line.theta);
  writer.attribute("votes", line.votes);
  writer.attribute("width", line.width);
  writer.attribute("count", line.count);
  writer.attribute("source", line.source);
  writer.attribute_unless_empty("free", io::to_text(line.free));
  if (line.covariance) write_covariance(writer, *line.covariance);
  for (const MapSegment& segment : line.segments) write_segment(writer, segment);
  writer.close();
}

}  // namespace

Result<std::string> line_map_to_xml(const LineMap& map) try {
  if (const auto breaches = check_line_map(map); !breaches.empty()) {
    return Failure{Problem::bad_option, "the map breaks a rule of its format: " + breaches.front().sentence};
  }
  XmlWriter writer;
  io::open_map(writer, MapKind::lines, map.meta);
  write_frame(writer, map.unit);
  if (map.image) write_image(writer, *map.image);
  for (const MapLine& line : map.lines) write_line(writer, line);
  writer.close();
  return writer.text();
} catch (const std::bad_alloc&) {
  return Failure{Problem::cannot_write, "the map's text does not fit into memory"};
}

Result<Done> write_line_map(const std::filesystem::path& file, const LineMap& map) {
  return io::write_map_text(file, line_map_to_xml(map));
}

}  // namespace straightedge
