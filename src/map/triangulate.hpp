// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "straightedge/host/plane_map.hpp"

namespace straightedge {

/// Corners as indices into the points of all polygons, one polygon after the other; counter-clockwise seen
/// from where the normal points.
using Triangle = std::array<std::uint32_t, 3>;

/// Cuts a plane's extent into triangles whose corners are the borders' own points, so that programs that
/// know neither holes nor concave faces draw it right.
///
/// 1. Look along the axis nearest to the normal, and count coordinates in 2^29 steps of the extent: whole
///    numbers, with which every later decision is exact.
/// 2. Take borders apart where they touch in a corner (touching_corners.hpp).
/// 3. Join each hole with the border around it by a bridge, an edge that is walked there and back, to a
///    corner that its leftmost point sees (hole_bridges.hpp).
/// 4. Cut off ears, triangles of three corners in a row that hold no other corner, until nothing is left
///    (ear_clipping.hpp).
///
/// G. H. Meisters, "Polygons Have Ears", American Mathematical Monthly 82(6), 1975,
/// doi:10.1080/00029890.1975.11993898. M. Held, "FIST: Fast Industrial-Strength Triangulation of Polygons",
/// Algorithmica 30(4), 2001, doi:10.1007/s00453-001-0028-4.
///
/// Borders may touch in corners. Points on straight pieces of a border may be left out. Borders that cross
/// give triangles that overlap; holes outside of every outer border and borders without area give none. Time
/// about n log n for n points, and n for each hole; memory 80 bytes a point.
std::vector<Triangle> triangulate(std::span<const MapPolygon> polygons, const Vector3& normal);

}  // namespace straightedge
