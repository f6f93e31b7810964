// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "straightedge/host/pose2.hpp"
#include "straightedge/host/scan_lines.hpp"

namespace straightedge {

/// How the odometry errs: standard deviations of a step of d metres and a turn of a radians.
struct MotionOptions {
  double along_per_m = 0.06;    ///< of the way, for each metre, [0, 10]
  double along_per_rad = 0.02;  ///< of the way, metres for each radian, [0, 10]
  double along_m = 0.003;       ///< of the way, however short, [0, 10]
  double turn_per_rad = 0.1;   ///< of the heading, for each radian, [0, 10]
  double turn_per_m = 0.03;     ///< of the heading, radians for each metre, [0, 10]
  double turn_rad = 0.003;      ///< of the heading, however small, [0, pi]
  double scale = 0.05;          ///< fault of every way, the same always: a share, [0, 1]; learnt on the way
  double drift_per_m = 0.02;    ///< fault of every heading, radians for each metre, [0, 1]; learnt likewise
  double unknown_m = 0.15;      ///< without odometry: of the way, beside the last motion, [0, 10]
  double unknown_rad = 0.1;     ///< without odometry: of the heading, [0, pi]
};

enum class Association : std::uint8_t {
  nearest,  ///< each line its nearest wall, the surest line first
  joint,    ///< the largest set of pairs that agree with one another
};

struct MatchOptions {
  Association association = Association::joint;
  double gate = 9.21;                   ///< chi-square of a pair, 2 degrees of freedom, above 0
  double max_angle_rad = 0.35;          ///< [0, pi/2], whatever the uncertainty
  double max_offset_m = 1.0;            ///< (0, 100], likewise
  double min_overlap = 0.5;             ///< share of the scan's line that must lie along the wall, [0, 1]
  double end_slack_m = 0.25;            ///< a wall may end so much farther than the map says, [0, 10]
  std::uint32_t max_branches = 4;       ///< walls tried for a line, [1, 16]
  std::uint32_t max_nodes = 512;        ///< of the tree of joint hypotheses, [1, 1e6]
  double ambiguity = 4;                 ///< chi-square by which a hypothesis must beat its rivals, >= 0
  double wall_angle_floor_rad = 0.003;  ///< error of a map line, on top of its covariance, [0, 0.1]
  double wall_offset_floor_m = 0.03;    ///< the same of its offset, [0, 1]
  double wall_roughness_pixels = 0.35;  ///< how far a wall's course leaves its line, of the map's image,
                                        ///< [0, 10]; a map without image is smooth
};

struct SearchOptions {
  std::uint32_t max_hypotheses = 48;  ///< followed at the same time, [1, 1024]
  std::uint32_t max_pairs = 400000;   ///< candidate poses looked at for a scan, [1, 1e8]
  double min_on_walls = 0.6;          ///< share of readings that a pose must explain to stand, [0, 1]
  double max_through_walls = 0.1;     ///< share of readings that may lie behind walls, [0, 1]
  double lead = 12;                   ///< log likelihood ratio by which the best must lead, > 0
  std::uint32_t min_scans = 2;        ///< that have to agree before a pose stands, [1, 1000]
};

struct LossOptions {
  double min_on_walls = 0.35;      ///< share of readings on walls below which a scan speaks against the pose
  double max_through_walls = 0.3;  ///< share behind walls above which a scan speaks against the pose
  double usual_share = 0.6;        ///< so does a share on walls below this part of the usual one, [0, 1], if
  double min_matched = 0.4;        ///< fewer of the lines than this find their wall, [0, 1], or half of
                                   ///< max_through_walls is exceeded
  std::uint32_t scans = 5;         ///< that speak against it, net of those for it: lost, [1, 1000]
  double on_wall_m = 0.12;         ///< a reading so near a wall lies on it, (0, 1]
  double on_wall_roughness = 2.5;  ///< and so many roughnesses of the walls on top, [0, 10]
  double max_sigma_m = 2.5;        ///< a pose vaguer than this is lost too, (0, 1e4]
};

struct LocalizeOptions {
  ScanLineOptions lines;
  MotionOptions motion;
  MatchOptions match;
  SearchOptions search;
  LossOptions loss;
  std::optional<Pose2> start;                                                  ///< none: search
  std::array<double, 9> start_covariance{0.04, 0, 0, 0, 0.04, 0, 0, 0, 0.01};  ///< row by row, positive
};

}  // namespace straightedge
