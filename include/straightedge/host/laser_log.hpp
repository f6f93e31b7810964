// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "straightedge/host/laser_scan.hpp"
#include "straightedge/host/pose2.hpp"
#include "straightedge/host/result.hpp"

namespace straightedge {

/// A longer file is refused, and so is one that unpacks to more.
inline constexpr std::size_t max_laser_log_bytes = std::size_t{1} << 29;

/// A scan of more beams is refused.
inline constexpr std::size_t max_scan_beams = std::size_t{1} << 16;

enum class LaserLogFormat : std::uint8_t { text, carmen };

struct LoggedScan {
  LaserScan scan;
  std::optional<Pose2> odometry;  ///< of the robot, in the odometry's own frame
  std::optional<Pose2> recorded;  ///< the laser's pose in a FLASER record: the odometry's in raw logs, the
                                  ///< best that is known in corrected ones
  std::size_t line = 0;           ///< of the file
};

struct LaserLog {
  LaserLogFormat format = LaserLogFormat::text;
  std::vector<LoggedScan> scans;
  std::size_t late_scans = 0;  ///< CARMEN: left out, since they are older than the scan before
};

/// Scans and odometry of a robot's run, from a text file that may be packed by gzip. Two formats, told apart
/// by the first record of a scan. Empty lines and what follows a `#` are passed over. Numbers are metres,
/// radians and seconds.
///
/// The plain format has two records:
///
///     ODOM time x y theta
///     SCAN time sensor_x sensor_y sensor_theta aperture right_to_left max_range n r1 .. rn
///
/// The sensor's pose is that in the robot. Beam i of n, from 0, points to −aperture/2 + i · aperture/(n − 1);
/// with right_to_left 0 the beams turn the other way. max_range 0: not known.
///
/// CARMEN's log, of which FLASER and ODOM are read and all other records passed over:
///
///     FLASER n r1 .. rn x y theta odom_x odom_y odom_theta time [host [logger_time]]
///     ODOM x y theta tv rv accel time [host [logger_time]]
///
/// Beam i points to −90° + i · step, step being 180° / n for even n and 180° / (n − 1) for odd n. The log
/// does not say where the laser sits in the robot (here: at its origin), nor how far it sees (80 m). In
/// corrected logs the pose of FLASER, all six numbers, is the work of a mapping program and no odometry: it
/// goes to `recorded`.
///
/// A scan's odometry is the last ODOM record before it; times of ODOM records are not looked at. Ranges may
/// be "nan" and "inf"; what is no reading is decided later (laser_scan.hpp). Scans may differ in size. Times
/// of scans must not run backwards. CARMEN's do where computers wrote together: a scan that is less than a
/// second older than the one before is left out and counted.
///
/// cannot_read: the file cannot be opened. bad_content, with the line: a record that is broken, numbers that
/// are not finite, a count of beams that is not the record's or above max_scan_beams, an aperture that is not
/// above 0 or beyond a circle, times that run backwards; and without a line: too long, gzip data that is cut
/// short or damaged, no scan at all.
Result<LaserLog> read_laser_log(const std::filesystem::path& file);

/// The same of bytes; `name` is what the sentences of failures call them.
Result<LaserLog> laser_log_from_bytes(std::string_view bytes, const std::string& name);

}  // namespace straightedge
