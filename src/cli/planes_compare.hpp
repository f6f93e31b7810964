// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/planes_run.hpp"

namespace straightedge::cli {

/// What one method needed and found; a frame here is a cloud too.
struct MethodFigures {
  PlaneMethod method = PlaneMethod::ransac;
  double first_ms = 0;    ///< median time to the first plane of a frame
  double all_ms = 0;      ///< median time to all planes of a frame, with labels
  double planes = 0;      ///< of a frame, mean
  double inliers = 0;     ///< labelled share of the readings, 0..1
  double residual_m = 0;  ///< root mean square over all labelled readings
  std::size_t map_planes = 0;
  std::size_t partnered = 0;  ///< of these, how many have a partner in the other map
};

/// Planes of two maps are partners when their normals differ by less than 2 degrees and the centroid of one
/// lies within 3 cm of the other; of several the nearest.
struct Comparison {
  std::array<MethodFigures, 2> methods;
  double angle_deg = 0;   ///< median over partners
  double offset_m = 0;    ///< median over partners
  double same_label = 0;  ///< of readings that either labels, the share on partners; 0..1
};

/// Of a run of both methods.
Comparison compare_methods(const PlanesRun& run);

/// For people, several lines.
std::string table_of(const Comparison& comparison);
nlohmann::ordered_json json_of(const Comparison& comparison);

}  // namespace straightedge::cli
