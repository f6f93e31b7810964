// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "map/plane_extent.hpp"
#include "straightedge/host/plane_leaves.hpp"
#include "straightedge/host/plane_map.hpp"
#include "straightedge/host/plane_map_builder.hpp"

namespace straightedge {

/// Plane coordinates and back: metres along the axes of plane_basis from a point of the plane.
struct PlaneChart {
  Vector3 origin, u, v;

  /// `near` is moved onto the plane and becomes the origin.
  PlaneChart(const Plane& plane, const Vector3& near);
  PlanePoint on(const Vector3& p) const { return {dot(u, p - origin), dot(v, p - origin)}; }
  Vector3 at(const PlanePoint& p) const { return origin + p.a * u + p.b * v; }
};

ExtentOptions extent_options(const PlaneMapOptions& options);

/// Step 7 of the builder: the borders of the leaves' readings on the plane.
///
/// A leaf covers the rectangle that a uniform spread with its second moments would have, √3 deviations to
/// each side of its mean, and half the way to the next reading; and no less than one bundle of readings does,
/// so that far, oblique views do not fall apart. Where its readings lie along an oblique border one
/// coordinate tells of the other: of the rectangle remains what is within √3 of the deviations that are left,
/// of each coordinate when the other one is known.
std::vector<ExtentPiece> covered_by(const PlaneChart& chart, std::span<const PlaneLeaf> leaves,
                                    std::span<const std::uint32_t> which);

std::vector<MapPolygon> polygons_of(const PlaneChart& chart, std::span<const ExtentLoop> loops);

}  // namespace straightedge
