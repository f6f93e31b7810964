// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <tinyxml2.h>

#include <new>
#include <string>

#include "io/free_side_text.hpp"
#include "io/number_text.hpp"
#include "io/ros_mode_text.hpp"
#include "io/xml_text.hpp"
#include "straightedge/host/atomic_file.hpp"
#include "straightedge/host/map_file.hpp"

namespace straightedge {
namespace {

/// One element after the other; numbers as this library spells them, texts as the XML library escapes them.
class Writer {
 public:
  void open(const char* element) { printer_.OpenElement(element); }
  void close() { printer_.CloseElement(); }

  void attribute(const char* name, const std::string& text) {
    printer_.PushAttribute(name, io::text_for_xml(text).c_str());
  }
  void attribute(const char* name, double value) { printer_.PushAttribute(name, io::to_text(value).c_str()); }
  void attribute(const char* name, std::integral auto value) {
    printer_.PushAttribute(name, io::to_text(value).c_str());
  }
  template <class Value>
  void attribute(const char* name, const std::optional<Value>& value) {
    if (value) attribute(name, *value);
  }
  void attribute_unless_empty(const char* name, const std::string& text) {
    if (!text.empty()) attribute(name, text);
  }

  void declaration() { printer_.PushDeclaration("xml version=\"1.0\" encoding=\"UTF-8\""); }
  std::string text() const { return {printer_.CStr(), static_cast<std::size_t>(printer_.CStrSize() - 1)}; }

 private:
  tinyxml2::XMLPrinter printer_;
};

void write_meta(Writer& writer, const MapMeta& meta) {
  if (meta == MapMeta{}) return;
  writer.open("meta");
  writer.attribute_unless_empty("name", meta.name);
  writer.attribute_unless_empty("created", meta.created);
  writer.attribute_unless_empty("tool", meta.tool);
  writer.attribute_unless_empty("options", meta.options);
  writer.attribute_unless_empty("description", meta.description);
  writer.close();
}

void write_frame(Writer& writer, MapUnit unit) {
  writer.open("frame");
  writer.attribute("origin", std::string(unit == MapUnit::pixel ? "image-centre" : "world"));
  writer.attribute("x", std::string("right"));
  writer.attribute("y", std::string("up"));
  writer.attribute("unit", std::string(unit == MapUnit::pixel ? "pixel" : "metre"));
  writer.attribute("angle", std::string("radian"));
  writer.close();
}

void write_image(Writer& writer, const MapImage& image) {
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
    writer.attribute("mode", std::string(io::to_text(image.meaning->mode)));
  }
  writer.close();
}

void write_covariance(Writer& writer, const LineCovariance& covariance) {
  writer.open("covariance");
  writer.attribute("at-x", covariance.at_x);
  writer.attribute("at-y", covariance.at_y);
  writer.attribute("var-theta", covariance.var_theta);
  writer.attribute("var-offset", covariance.var_offset);
  writer.close();
}

void write_segment(Writer& writer, const MapSegment& segment) {
  writer.open("segment");
  writer.attribute("id", segment.id);
  writer.attribute("x0", segment.x0);
  writer.attribute("y0", segment.y0);
  writer.attribute("x1", segment.x1);
  writer.attribute("y1", segment.y1);
  writer.attribute("pixels", segment.pixels);
  writer.close();
}

void write_line(Writer& writer, const MapLine& line) {
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
  Writer writer;
  writer.declaration();
  writer.open("map");
  writer.attribute("format", std::string("straightedge-map"));
  writer.attribute("version", map_format_version);
  writer.attribute("kind", std::string("lines"));
  write_meta(writer, map.meta);
  write_frame(writer, map.unit);
  if (map.image) write_image(writer, *map.image);
  for (const MapLine& line : map.lines) write_line(writer, line);
  writer.close();
  return writer.text();
} catch (const std::bad_alloc&) {
  return Failure{Problem::cannot_write, "the map's text does not fit into memory"};
}

Result<Done> write_line_map(const std::filesystem::path& file, const LineMap& map) {
  const auto xml = line_map_to_xml(map);
  if (!xml) return Failure{xml.failure().problem, file.string() + ": " + xml.failure().sentence};
  return write_file_atomically(file, *xml);
}

}  // namespace straightedge
