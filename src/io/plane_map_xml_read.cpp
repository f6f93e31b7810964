// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <tinyxml2.h>

#include <string_view>

#include "io/map_xml.hpp"
#include "io/side_text.hpp"
#include "straightedge/host/plane_map_file.hpp"

namespace straightedge {
namespace {

using io::XmlBreach;
using io::XmlElement;

/// A map and where its elements stand in the text, so that breaches of the rules can name the line.
struct PlaneMapReading {
  struct PlanePlace {
    int line = 0;
    std::vector<int> polygons;
  };
  PlaneMap map;
  std::vector<PlanePlace> planes;

  void read(const tinyxml2::XMLElement& root);
  std::vector<PlaneMapBreach> check() const { return check_plane_map(map); }
  int line_of(const PlaneMapBreach& breach) const {
    if (!breach.plane) return 1;
    const PlanePlace& place = planes[*breach.plane];
    return breach.polygon ? place.polygons[*breach.polygon] : place.line;
  }
};

void read_frame(const XmlElement& element) {
  if (element.required_text("unit") != "metre") element.refuse("`unit` is not \"metre\"");
  element.expect("origin", "world");
}

MapMoments read_moments(const XmlElement& element) {
  MapMoments moments;
  moments.weight = element.required_number<double>("weight");
  const auto mean = element.required_numbers<3>("mean");
  moments.mean = {mean[0], mean[1], mean[2]};
  moments.scatter = element.required_numbers<6>("scatter");
  return moments;
}

Vector3 read_point(const XmlElement& element) {
  return {element.required_number<double>("x"), element.required_number<double>("y"),
          element.required_number<double>("z")};
}

MapPolygon read_polygon(const tinyxml2::XMLElement& node) {
  const XmlElement element(node);
  MapPolygon polygon;
  if (const auto hole = element.text("hole")) {
    polygon.hole = *hole == "true" || *hole == "1";
    if (!polygon.hole && *hole != "false" && *hole != "0") {
      element.refuse("`hole` is neither \"true\" nor \"false\"");
    }
  }
  for (const auto* child = node.FirstChildElement("v"); child != nullptr;
       child = child->NextSiblingElement("v")) {
    polygon.points.push_back(read_point(XmlElement(*child)));
  }
  return polygon;
}

MapPlane read_attributes(const XmlElement& element) {
  MapPlane plane;
  plane.id = element.required_number<std::uint32_t>("id");
  plane.plane.normal = {element.required_number<double>("nx"), element.required_number<double>("ny"),
                        element.required_number<double>("nz")};
  plane.plane.distance = element.required_number<double>("d");
  plane.points = element.number<std::uint64_t>("points");
  plane.count = element.number<std::uint32_t>("count");
  plane.source = element.text("source");
  if (const auto seen = element.text("seen")) {
    const auto side = io::side_from_text<SeenSide>(*seen);
    if (!side) element.refuse("`seen` is none of +, - and both");
    plane.seen = *side;
  }
  return plane;
}

void read_plane(const tinyxml2::XMLElement& node, PlaneMapReading& reading) {
  const XmlElement element(node);
  MapPlane plane = read_attributes(element);
  PlaneMapReading::PlanePlace place{element.line(), {}};
  for (const auto* child = node.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
    const std::string_view name = child->Name();
    if (name == "covariance") {
      if (plane.covariance) element.refuse("has two covariances");
      plane.covariance = XmlElement(*child).required_numbers<10>("upper");
    } else if (name == "moments") {
      if (plane.moments) element.refuse("has moments twice");
      plane.moments = read_moments(XmlElement(*child));
    } else if (name == "polygon") {
      plane.polygons.push_back(read_polygon(*child));
      place.polygons.push_back(child->GetLineNum());
    }
  }
  reading.map.planes.push_back(std::move(plane));
  reading.planes.push_back(std::move(place));
}

void PlaneMapReading::read(const tinyxml2::XMLElement& root) {
  io::require_kind(XmlElement(root), MapKind::planes);
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
      read_frame(element);
    } else if (name == "plane") {
      read_plane(*child, *this);
    }
  }
  if (frames == 0) throw XmlBreach{root.GetLineNum(), "has no `frame`, so its unit is unknown"};
}

}  // namespace

Result<PlaneMap> plane_map_from_xml(const std::string& xml, const std::string& name) {
  return io::map_from_xml<PlaneMapReading>(xml, name);
}

Result<PlaneMap> read_plane_map(const std::filesystem::path& file) {
  return io::read_map_file<PlaneMapReading>(file);
}

Result<std::vector<std::string>> validate_plane_map(const std::filesystem::path& file) {
  return io::validate_map_file<PlaneMapReading>(file);
}

}  // namespace straightedge
