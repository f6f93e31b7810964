// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "localize/option_check.hpp"

#include "straightedge/trigonometry.hpp"

namespace straightedge::localize {
namespace {

bool within(double value, double least, double most) {
  return value >= least && value <= most;
}

bool above(double value, double least, double most) {
  return value > least && value <= most;
}

bool within(std::uint32_t value, std::uint32_t least, std::uint32_t most) {
  return value >= least && value <= most;
}

bool sound(const MotionOptions& o) {
  return within(o.along_per_m, 0, 10) && within(o.along_per_rad, 0, 10) && within(o.along_m, 0, 10) &&
         within(o.turn_per_rad, 0, 10) && within(o.turn_per_m, 0, 10) && within(o.turn_rad, 0, pi) &&
         within(o.scale, 0, 1) && within(o.drift_per_m, 0, 1) && within(o.unknown_m, 0, 10) &&
         within(o.unknown_rad, 0, pi);
}

bool sound(const MatchOptions& o) {
  return above(o.gate, 0, 1e6) && within(o.max_angle_rad, 0, pi / 2) && above(o.max_offset_m, 0, 100) &&
         within(o.min_overlap, 0, 1) && within(o.end_slack_m, 0, 10) && within(o.max_branches, 1U, 16U) &&
         within(o.max_nodes, 1U, 1000000U) && within(o.ambiguity, 0, 1e6) &&
         within(o.wall_angle_floor_rad, 0, 0.1) && within(o.wall_offset_floor_m, 0, 1) &&
         within(o.wall_roughness_pixels, 0, 10);
}

bool sound(const SearchOptions& o) {
  return within(o.max_hypotheses, 1U, 1024U) && within(o.max_pairs, 1U, 100000000U) &&
         within(o.min_on_walls, 0, 1) && within(o.max_through_walls, 0, 1) && above(o.lead, 0, 1e6) &&
         within(o.min_scans, 1U, 1000U);
}

bool sound(const LossOptions& o) {
  return within(o.min_on_walls, 0, 1) && within(o.max_through_walls, 0, 1) && within(o.scans, 1U, 1000U) &&
         above(o.max_sigma_m, 0, 1e4) && within(o.usual_share, 0, 1) && within(o.min_matched, 0, 1) &&
         above(o.on_wall_m, 0, 1) && within(o.on_wall_roughness, 0, 10);
}

/// Symmetric, and its leading minors positive.
bool positive(const std::array<double, 9>& c) {
  for (const double v : c) {
    if (!within(v, -1e12, 1e12)) return false;
  }
  const double two = c[0] * c[4] - c[1] * c[1];
  const double three = c[0] * (c[4] * c[8] - c[5] * c[5]) - c[1] * (c[1] * c[8] - c[5] * c[2]) +
                       c[2] * (c[1] * c[5] - c[4] * c[2]);
  return c[1] == c[3] && c[2] == c[6] && c[5] == c[7] && c[0] > 0 && two > 0 && three > 0;
}

}  // namespace

const char* objection_to(const LocalizeOptions& options) noexcept {
  if (!valid(options.lines)) return "an option of the scan's lines is not a number or out of its range";
  if (!sound(options.motion)) return "an option of the motion is not a number or out of its range";
  if (!sound(options.match)) return "an option of the matching is not a number or out of its range";
  if (!sound(options.search)) return "an option of the search is not a number or out of its range";
  if (!sound(options.loss)) return "an option of the loss check is not a number or out of its range";
  if (options.start && !usable(*options.start)) return "the start pose is not a number or too far away";
  if (!positive(options.start_covariance)) return "the start's covariance is not symmetric and positive";
  return nullptr;
}

}  // namespace straightedge::localize
