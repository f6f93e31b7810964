// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "io/log_record.hpp"
#include "straightedge/trigonometry.hpp"

namespace straightedge::io {
namespace {

constexpr double usual_max_range_m = 80;  // scanners of that time report a little more where nothing returns
constexpr double most_late_s = 1;

/// Time, and the two words of the computer that wrote it, which old logs do not have.
double end_of(LogRecord& record) {
  const double time = record.number("time");
  if (!record.at_end()) record.word("host");
  if (!record.at_end()) record.word("logger's time");
  record.expect_end("logger's time");
  return time;
}

LoggedScan scan_of(LogRecord& record) {
  LoggedScan logged;
  LaserScan& scan = logged.scan;
  const std::size_t beams = record.beams();
  scan.ranges_m = record.ranges(beams);
  logged.recorded = record.pose("laser's pose");
  record.pose("odometry");
  scan.time_s = end_of(record);
  scan.max_range_m = usual_max_range_m;
  const std::size_t steps = beams % 2 == 0 ? beams : beams - 1;
  scan.first_angle_rad = beams == 1 ? 0 : -pi / 2;
  scan.angle_step_rad = pi / static_cast<double>(steps > 0 ? steps : 1);
  return logged;
}

}  // namespace

void take_carmen_record(LogRecord& record, LogSoFar& so_far) {
  if (record.kind() == "ODOM") {
    so_far.odometry = record.pose("odometry");
    for (const char* const what : {"tv", "rv", "acceleration"}) record.number(what);
    end_of(record);
  } else if (record.kind() == "FLASER") {
    LoggedScan logged = scan_of(record);
    auto& scans = so_far.log.scans;
    const double late = scans.empty() ? 0 : scans.back().scan.time_s - logged.scan.time_s;
    if (late >= most_late_s)
      throw BadRecord{"time " + to_text(logged.scan.time_s) + " comes after " +
                      to_text(scans.back().scan.time_s) + ": times must not run backwards"};
    if (late > 0) {
      ++so_far.log.late_scans;
      return;
    }
    logged.odometry = so_far.odometry;
    scans.push_back(std::move(logged));
  }
}

}  // namespace straightedge::io
