// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <tinyxml2.h>

#include <string_view>

#include "io/map_xml.hpp"
#include "io/ros_mode_text.hpp"
#include "io/side_text.hpp"

namespace straightedge {
namespace {

using io::XmlBreach;
using io::XmlElement;

/// A map and where its elements stand in the text, so that breaches of the rules can name the line.
struct LineMapReading {
  struct LinePlace {
    int line = 0;
    std::vector<int> segments;
  };
  LineMap map;
  int image_line = 1;
  std::vector<LinePlace> lines;

  void read(const tinyxml2::XMLElement& root);
  std::vector<MapBreach> check() const { return check_line_map(map); }
  int line_of(const MapBreach& breach) const {
    if (!breach.line) return image_line;
    const LinePlace& place = lines[*breach.line];
    return breach.segment ? place.segments[*breach.segment] : place.line;
  }
};

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

void read_line(const tinyxml2::XMLElement& node, LineMapReading& reading) {
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
    const auto side = io::side_from_text<FreeSide>(*free);
    if (!side) element.refuse("`free` is none of +, - and both");
    line.free = *side;
  }
  LineMapReading::LinePlace place{element.line(), {}};
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

void LineMapReading::read(const tinyxml2::XMLElement& root) {
  io::require_kind(XmlElement(root), MapKind::lines);
  int metas = 0;
  int frames = 0;
  for (const auto* child = root.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
    const XmlElement element(*child);
    const std::string_view name = child->Name();
    if (name == "meta") {
      if (++metas == 2) element.refuse("stands there twice");
      map.meta = io::read_meta(element);
    } else if (name == "frame") {
      if (++frames == 2) element.refuse("stands there twice");
      map.unit = read_frame(element);
    } else if (name == "image") {
      if (map.image) element.refuse("stands there twice");
      map.image = read_image(element);
      image_line = element.line();
    } else if (name == "line") {
      read_line(*child, *this);
    }
  }
  if (frames == 0) throw XmlBreach{root.GetLineNum(), "has no `frame`, so its unit is unknown"};
}

}  // namespace

Result<LineMap> line_map_from_xml(const std::string& xml, const std::string& name) {
  return io::map_from_xml<LineMapReading>(xml, name);
}

Result<LineMap> read_line_map(const std::filesystem::path& file) {
  return io::read_map_file<LineMapReading>(file);
}

Result<std::vector<std::string>> validate_line_map(const std::filesystem::path& file) {
  return io::validate_map_file<LineMapReading>(file);
}

}  // namespace straightedge
