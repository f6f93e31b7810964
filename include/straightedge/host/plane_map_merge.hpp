// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "straightedge/host/plane_map.hpp"
#include "straightedge/host/plane_map_builder.hpp"
#include "straightedge/host/result.hpp"

namespace straightedge {

/// One map of two that share a world frame, where their leaves are not at hand (with leaves,
/// PlaneMapBuilder::merge is exact).
///
/// 1. A plane of one map and a plane of the other are the same when they agree as patches do in the builder:
///    chi-square with floors, caps on angle and offset. The pair that misses least is joined first; each
///    plane has at most one partner.
/// 2. Partners' moments are added and fitted anew. A plane without moments counts by the corners of its
///    polygons, each as a reading with a deviation of 1 cm, or by its normal alone.
/// 3. Their polygons are united on a grid of 1/64 m. Planes without partner stay as they are.
/// 4. Order and ids as in the builder.
///
/// The order of the two maps does not matter. bad_option: options out of range; bad_content: a map that
/// breaks a rule of its numbers (normals, finite values). Planes times planes in time.
Result<PlaneMap> merge_plane_maps(const PlaneMap& a, const PlaneMap& b, const PlaneMapOptions& options = {});

}  // namespace straightedge
