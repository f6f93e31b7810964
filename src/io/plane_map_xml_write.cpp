// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <new>
#include <string>

#include "io/map_xml.hpp"
#include "io/side_text.hpp"
#include "straightedge/host/plane_map_file.hpp"

namespace straightedge {
namespace {

using io::XmlWriter;

void write_frame(XmlWriter& writer) {
  writer.open("frame");
  writer.attribute("origin", "world");
  writer.attribute("unit", "metre");
  writer.close();
}

void write_covariance(XmlWriter& writer, const std::array<double, 10>& upper) {
  writer.open("covariance");
  writer.attribute("upper", upper);
  writer.close();
}

void write_moments(XmlWriter& writer, const MapMoments& moments) {
  writer.open("moments");
  writer.attribute("weight", moments.weight);
  writer.attribute("mean", std::array{moments.mean.x, moments.mean.y, moments.mean.z});
  writer.attribute("scatter", moments.scatter);
  writer.close();
}

void write_polygon(XmlWriter& writer, const MapPolygon& polygon) {
  writer.open("polygon");
  if (polygon.hole) writer.attribute("hole", "true");
  for (const Vector3& point : polygon.points) {
    writer.open("v");
    writer.attribute("x", point.x);
    writer.attribute("y", point.y);
    writer.attribute("z", point.z);
    writer.close();
  }
  writer.close();
}

void write_plane(XmlWriter& writer, const MapPlane& plane) {
  writer.open("plane");
  writer.attribute("id", plane.id);
  writer.attribute("nx", plane.plane.normal.x);
  writer.attribute("ny", plane.plane.normal.y);
  writer.attribute("nz", plane.plane.normal.z);
  writer.attribute("d", plane.plane.distance);
  writer.attribute("points", plane.points);
  writer.attribute("count", plane.count);
  writer.attribute("source", plane.source);
  writer.attribute_unless_empty("seen", io::to_text(plane.seen));
  if (plane.covariance) write_covariance(writer, *plane.covariance);
  if (plane.moments) write_moments(writer, *plane.moments);
  for (const MapPolygon& polygon : plane.polygons) write_polygon(writer, polygon);
  writer.close();
}

}  // namespace

Result<std::string> plane_map_to_xml(const PlaneMap& map) try {
  if (const auto breaches = check_plane_map(map); !breaches.empty()) {
    return Failure{Problem::bad_option, "the map breaks a rule of its format: " + breaches.front().sentence};
  }
  XmlWriter writer;
  io::open_map(writer, MapKind::planes, map.meta);
  write_frame(writer);
  for (const MapPlane& plane : map.planes) write_plane(writer, plane);
  writer.close();
  return writer.text();
} catch (const std::bad_alloc&) {
  return Failure{Problem::cannot_write, "the map's text does not fit into memory"};
}

Result<Done> write_plane_map(const std::filesystem::path& file, const PlaneMap& map) {
  return io::write_map_text(file, plane_map_to_xml(map));
}

}  // namespace straightedge
