// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <new>
#include <string>
#include <vector>

#include "io/ply_bytes.hpp"
#include "map/triangulate.hpp"
#include "straightedge/host/atomic_file.hpp"
#include "straightedge/host/ply.hpp"

namespace straightedge {
namespace {

/// Vertices and faces as they will stand in the file.
struct Mesh {
  std::string vertices, faces;
  std::uint32_t vertex_count = 0;
  std::size_t face_count = 0;
};

void append_plane(Mesh& mesh, const MapPlane& plane) {
  const std::uint32_t first = mesh.vertex_count;
  for (const MapPolygon& polygon : plane.polygons) {
    for (const Vector3& point : polygon.points) io::append_vertex(mesh.vertices, point, plane.id);
    mesh.vertex_count += static_cast<std::uint32_t>(polygon.points.size());
  }
  for (const Triangle& triangle : triangulate(plane.polygons, plane.plane.normal)) {
    mesh.faces += '\3';
    for (const std::uint32_t corner : triangle) io::append_word(mesh.faces, first + corner);
    ++mesh.face_count;
  }
}

std::string header_of(const Mesh& mesh, const MapMeta& meta) {
  std::string text(io::ply_head);
  for (const std::string& line : {meta.tool, meta.options}) {
    if (!line.empty()) text += io::ply_comment(line);
  }
  text.append("element vertex ").append(std::to_string(mesh.vertex_count)).append("\n");
  text.append(io::ply_vertex_properties);
  text.append("element face ").append(std::to_string(mesh.face_count)).append("\n");
  return text.append("property list uchar int vertex_indices\nend_header\n");
}

}  // namespace

Result<Done> write_polygons_ply(const std::filesystem::path& file, const PlaneMap& map) try {
  constexpr std::size_t most_vertices = 0x7FFFFFFF;  // indices are ints
  std::size_t points = 0;
  for (const MapPlane& plane : map.planes) {
    for (const MapPolygon& polygon : plane.polygons) points += polygon.points.size();
  }
  if (points > most_vertices) {
    return Failure{Problem::bad_option, file.string() + ": a PLY file cannot hold more than 2^31 corners"};
  }
  Mesh mesh;
  for (const MapPlane& plane : map.planes) append_plane(mesh, plane);
  return write_file_atomically(file, header_of(mesh, map.meta) + mesh.vertices + mesh.faces);
} catch (const std::bad_alloc&) {
  return Failure{Problem::cannot_write, file.string() + ": the triangles do not fit into memory"};
}

}  // namespace straightedge
