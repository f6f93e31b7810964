// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "straightedge/host/line_map.hpp"
#include "straightedge/host/result.hpp"

namespace straightedge {

/// One row a segment, in the map's order and frame:
/// `x0,y0,x1,y1,line,rho,theta,width,votes,pixels` under a row with these names. Numbers are the shortest
/// that read back to the same bits; what a line or segment does not have is left empty.
std::string line_map_to_csv(const LineMap& map);

Result<Done> write_csv(const std::filesystem::path& file, const LineMap& map);

}  // namespace straightedge
