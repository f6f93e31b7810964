// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <tinyxml2.h>

#include <new>
#include <string_view>

#include "io/free_side_text.hpp"
#include "io/read_bytes.hpp"
#include "io/ros_mode_text.hpp"
#include "io/xml_document.hpp"
#include "io/xml_element.hpp"
#include "straightedge/host/map_file.hpp"

namespace straightedge {
namespace {

using io::XmlBreach;
using io::XmlElement;

/// A map and where its elements stand in the text, so that breaches of the rules can name the line.
struct Reading {
  struct LinePlace {
    int line = 0;
    std::vector<int> segments;
  };
  LineMap map;
  int image_line = 1;
  std::vector<LinePlace> lines;

  int line_of(const MapBreach& breach) const {
    if (!breach.line) return image_line;
    const LinePlace& place = lines[*breach.line];
    return breach.segment ? place.segments[*breach.segment] : place.line;
  }
};

void read_root(const XmlElement& root, std::string_view name) {
  if (name != "map" || root.text("format").value_or("") != "straightedge-map") {
    throw XmlBreach{root.line(), "is not a straightedge-map"};
  }
  const int version = root.required_number<int>("version");
  if (version > map_format_version) {
    throw XmlBreach{root.line(), "was written by a newer version (format version " + std::to_string(version) +
                                     ", and up to " + std::to_string(map_format_version) + " is read here)"};
  }
  if (version < 1) root.refuse("the format's version is below 1");
  const std::string kind = root.required_text("kind");
  if (kind == "planes") throw XmlBreach{root.line(), "is a map of planes where a map of lines is wanted"};
  if (kind != "lines") root.refuse("`kind` is neither \"lines\" nor \"planes\"");
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

MapUnit read_frame(const XmlElement& element) {
  element.expect("x", "right");
  element.expect("y", "up");
  element.expect("angle", "radian");
  const std::string unit = element.required_text("unit");
  if (unit != "pixel" && unit != "metre") element.refuse("`unit` is neither \"pixel\" nor \"metre\"");
  element.expect("origin", unit == "pixel" ? "image-centre" : "world");
  return unit == "pixel" ? MapUnit::pixel : MapUnit::metre;
}

std::optional<MapPlacement> read_placement(const XmlElement& element) {
  const auto resolution = element.number<double>("resolution");
  const auto x = element.number<double>("origin-x");
  const auto y = element.number<double>("origin-y");
  const auto yaw = element.number<double>("origin-yaw");
  if (!resolution) {
    if (x || y || yaw) element.refuse("has an origin but no `resolution`");
    return {};
  }
  return MapPlacement{*resolution, x.value_or(0), y.value_or(0), yaw.value_or(0)};
}

std::optional<RosMeaning> read_meaning(const XmlElement& element) {
  const auto negate = element.text("negate");
  const auto occupied = element.number<double>("occupied-thresh");
  const auto free = element.number<double>("free-thresh");
  const auto mode = element.text("mode");
  if (!negate && !occupied && !free && !mode) return {};
  RosMeaning meaning;
  if (negate) {
    if (*negate != "0" && *negate != "1") element.refuse("`negate` is neither 0 nor 1");
    meaning.negate = *negate == "1";
  }
  if (occupied) meaning.occupied_thresh = *occupied;
  if (free) meaning.free_thresh = *free;
  if (mode) {
    const auto known = io::ros_mode_from_text(*mode);
    if (!known) element.refuse("`mode` is none of trinary, scale and raw");
    meaning.mode = *known;
  }
  return meaning;
}

MapImage read_image(const XmlElement& element) {
  MapImage image;
  image.file = element.required_text("file");
  image.size = {element.required_number<std::int32_t>("width"),
                element.required_number<std::int32_t>("height")};
  image.placement = read_placement(element);
  image.meaning = read_meaning(element);
  return image;
}

LineCovariance read_covariance(const XmlElement& element) {
  return {element.required_number<double>("at-x"), element.required_number<double>("at-y"),
          element.required_number<double>("var-theta"), element.required_number<double>("var-offset")};
}

MapSegment read_segment(const XmlElement& element) {
  MapSegment segment;
  segment.id = element.required_number<std::uint32_t>("id");
  segment.x0 = element.required_number<double>("x0");
  segment.y0 = element.required_number<double>("y0");
  segment.x1 = element.required_number<double>("x1");
  segment.y1 = element.required_number<double>("y1");
  segment.pixels = element.number<std::uint32_t>("pixels");
  return segment;
}

void read_line(const tinyxml2::XMLElement& node, Reading& reading) {
  const XmlElement element(node);
  MapLine line;
  line.id = element.required_number<std::uint32_t>("id");
  line.rho = element.required_number<double>("rho");
  line.theta = element.required_number<double>("theta");
  line.votes = element.number<std::uint32_t>("votes");
  line.width = element.number<double>("width");
  line.count = element.number<std::uint32_t>("count");
  line.source = element.text("source");
  if (const auto free = element.text("free")) {
    const auto side = io::free_side_from_text(*free);
    if (!side) element.refuse("`free` is none of +, - and both");
    line.free = *side;
  }
  Reading::LinePlace place{element.line(), {}};
  for (const auto* child = node.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
    const std::string_view name = child->Name();
    if (name == "covariance") {
      if (line.covariance) element.refuse("has two covariances");
      line.covariance = read_covariance(XmlElement(*child));
    } else if (name == "segment") {
      line.segments.push_back(read_segment(XmlElement(*child)));
      place.segments.push_back(child->GetLineNum());
    }
  }
  reading.map.lines.push_back(std::move(line));
  reading.lines.push_back(std::move(place));
}

Reading read_map(const std::string& xml) {
  tinyxml2::XMLDocument document;
  const tinyxml2::XMLElement& root = io::parse_document(document, xml);
  read_root(XmlElement(root), root.Name());
  Reading reading;
  int metas = 0;
  int frames = 0;
  for (const auto* child = root.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
    const XmlElement element(*child);
    const std::string_view name = child->Name();
    if (name == "meta") {
      if (++metas == 2) element.refuse("stands there twice");
      reading.map.meta = read_meta(element);
    } else if (name == "frame") {
      if (++frames == 2) element.refuse("stands there twice");
      reading.map.unit = read_frame(element);
    } else if (name == "image") {
      if (reading.map.image) element.refuse("stands there twice");
      reading.map.image = read_image(element);
      reading.image_line = element.line();
    } else if (name == "line") {
      read_line(*child, reading);
    }
  }
  if (frames == 0) throw XmlBreach{root.GetLineNum(), "has no `frame`, so its unit is unknown"};
  return reading;
}

std::string sentence_of(const std::string& name, int line, const std::string& sentence) {
  return name + ":" + std::to_string(line) + ": " + sentence;
}

Result<Reading> read_text(const std::string& xml, const std::string& name) try {
  if (xml.size() > max_map_file_bytes) return Failure{Problem::bad_content, name + ": is longer than 256 MB"};
  return read_map(xml);
} catch (const XmlBreach& breach) {
  return Failure{Problem::bad_content, sentence_of(name, breach.line, breach.sentence)};
} catch (const std::bad_alloc&) {
  return Failure{Problem::cannot_read, name + ": does not fit into memory"};
}

}  // namespace

Result<LineMap> line_map_from_xml(const std::string& xml, const std::string& name) {
  auto reading = read_text(xml, name);
  if (!reading) return reading.failure();
  if (const auto breaches = check_line_map(reading->map); !breaches.empty()) {
    const MapBreach& first = breaches.front();
    return Failure{Problem::bad_content, sentence_of(name, reading->line_of(first), first.sentence)};
  }
  return std::move(reading->map);
}

Result<LineMap> read_line_map(const std::filesystem::path& file) {
  const auto xml = io::read_bytes(file, max_map_file_bytes);
  if (!xml) return xml.failure();
  return line_map_from_xml(*xml, file.string());
}

Result<std::vector<std::string>> validate_line_map(const std::filesystem::path& file) {
  const auto xml = io::read_bytes(file, max_map_file_bytes);
  if (!xml) return xml.failure();
  const auto reading = read_text(*xml, file.string());
  if (!reading) return reading.failure();
  std::vector<std::string> sentences;
  for (const MapBreach& breach : check_line_map(reading->map)) {
    sentences.push_back(sentence_of(file.string(), reading->line_of(breach), breach.sentence));
  }
  return sentences;
}

}  // namespace straightedge
