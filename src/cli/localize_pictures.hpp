// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/localize_report.hpp"
#include "straightedge/host/floor_svg.hpp"

/// What is drawn of a run and of one scan.
namespace straightedge::cli {

/// The whole run: ways, readings on the walls, where it was found and lost.
FloorDrawing run_drawing(const LocalizeStory& story);

/// Of one scan in the robot's frame, without a map.
FloorDrawing readings_drawing(const LocalizeStory& story, const ExplainedScan& scan);
FloorDrawing lines_drawing(const LocalizeStory& story, const ExplainedScan& scan);

/// Of one scan on the map: from where the robot was expected, from where it is, from the likeliest candidate.
FloorDrawing matches_drawing(const LocalizeStory& story, const ExplainedScan& scan);
FloorDrawing pose_drawing(const LocalizeStory& story, const ExplainedScan& scan);
FloorDrawing search_drawing(const LocalizeStory& story, const ExplainedScan& scan);

}  // namespace straightedge::cli
