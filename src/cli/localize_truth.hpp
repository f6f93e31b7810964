// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "cli/localize_run.hpp"
#include "straightedge/host/laser_log.hpp"
#include "straightedge/host/planar_trajectory.hpp"

namespace straightedge::cli {

/// How far poses lie from the truth: every pose that has a truth, the first ones too.
struct PoseErrors {
  std::size_t compared = 0;
  std::size_t without_truth = 0;  ///< poses at times of which the truth says nothing
  double rms_m = 0, median_m = 0, worst_m = 0;
  double rms_rad = 0, median_rad = 0, worst_rad = 0;
  std::optional<double> nees;  ///< mean of eᵀ P⁻¹ e; 3 is what honest covariances give
};

/// The truth between its poses is a straight way with an even turn. Of times before its first or behind its
/// last pose, or in a gap of a second or more, it says nothing.
std::optional<Pose2> truth_at(std::span<const TimedPose2> truth, double time_s);

/// With `covariances` false: no NEES.
PoseErrors compare_poses(std::span<const TimedPose2> poses, std::span<const TimedPose2> truth,
                         bool covariances);

/// Where the odometry alone would have led from the first pose that was found, at every scan that has one.
std::vector<TimedPose2> odometry_alone(const LocalizeRun& run, const LaserLog& log);

}  // namespace straightedge::cli
