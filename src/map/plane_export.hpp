// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "map/plane_groups.hpp"
#include "straightedge/host/plane_map.hpp"

namespace straightedge {

/// A plane with its numbers, without id and extent.
MapPlane exported(const PlaneGroup& group, const PlaneMapOptions& options);

}  // namespace straightedge
