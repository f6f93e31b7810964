// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cli/command.hpp"
#include "straightedge/host/laser_log.hpp"
#include "straightedge/host/localize_options.hpp"

namespace straightedge::cli {

/// Which poses of a log are its odometry.
enum class OdometrySource : std::uint8_t { records, flaser, none };

/// The options of `localize`, as they were given.
class LocalizeArguments {
 public:
  void add_to(CLI::App& command);

  /// bad_option: options that contradict one another.
  Result<Done> check() const;

  LocalizeOptions options() const;

  /// What an option says in place of the log: odometry, range, the laser's place. bad_option: the log has no
  /// such odometry.
  Result<Done> apply_to(LaserLog& log) const;

  /// The options in words for the files, with the seed and the inputs' names.
  std::string words() const;

  CommonArguments common;
  std::string map;
  std::string scans;
  std::string trajectory;
  std::string covariance;
  std::string svg;
  std::string truth;
  std::string explain;
  std::uint64_t explain_scan = 0;  ///< from 1; 0: the first that was expected somewhere and matched lines

 private:
  void add_files(CLI::App& command);
  void add_robot(CLI::App& command);
  void add_matching(CLI::App& command);

  std::optional<Pose2> start_;
  std::optional<Pose2> laser_;
  Pose2 start_sigma_{0.2, 0.2, 0.1};
  double max_range_m_ = 0;
  OdometrySource odometry_ = OdometrySource::records;
  LocalizeOptions options_;
  CLI::Option* start_sigma_option_ = nullptr;
  CLI::Option* explain_scan_option_ = nullptr;
};

}  // namespace straightedge::cli
