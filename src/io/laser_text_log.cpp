// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "io/log_record.hpp"
#include "straightedge/trigonometry.hpp"

namespace straightedge::io {
namespace {

// A circle whose last beam is its first again, and the rounding of whoever wrote it.
constexpr double widest_aperture = 2 * pi + 0.01;

double aperture_of(LogRecord& record) {
  const double aperture = record.number("aperture");
  if (!(aperture > 0) || aperture > widest_aperture)
    throw BadRecord{"the aperture is " + to_short_text(aperture) + " and not above 0 and at most 2 pi"};
  return aperture;
}

bool turns_left(LogRecord& record) {
  const std::string_view text = record.word("right_to_left");
  if (text != "0" && text != "1") throw BadRecord{"right_to_left is " + quoted(text) + " and not 0 or 1"};
  return text == "1";
}

double max_range_of(LogRecord& record) {
  const double range = record.number("max_range");
  if (range < 0) throw BadRecord{"max_range is below 0"};
  return range;
}

LoggedScan scan_of(LogRecord& record) {
  LoggedScan logged;
  LaserScan& scan = logged.scan;
  scan.time_s = record.number("time");
  scan.laser_in_robot = record.pose("sensor's pose");
  const double aperture = aperture_of(record);
  const double side = turns_left(record) ? 1 : -1;
  scan.max_range_m = max_range_of(record);
  const std::size_t beams = record.beams();
  scan.ranges_m = record.ranges(beams);
  record.expect_end("last range");
  // One beam has no neighbour, and points into the middle.
  scan.first_angle_rad = beams > 1 ? -side * aperture / 2 : 0;
  scan.angle_step_rad = side * aperture / (beams > 1 ? static_cast<double>(beams - 1) : 1.0);
  return logged;
}

}  // namespace

void take_text_record(LogRecord& record, LogSoFar& so_far) {
  if (record.kind() == "ODOM") {
    record.number("time");
    so_far.odometry = record.pose("odometry");
    record.expect_end("odometry's angle");
  } else if (record.kind() == "SCAN") {
    LoggedScan logged = scan_of(record);
    auto& scans = so_far.log.scans;
    const double time = logged.scan.time_s;
    if (!scans.empty() && time < scans.back().scan.time_s)
      throw BadRecord{"time " + to_text(time) + " comes after " + to_text(scans.back().scan.time_s) +
                      ": times must not run backwards"};
    logged.odometry = so_far.odometry;
    scans.push_back(std::move(logged));
  } else {
    throw BadRecord{quoted(record.kind()) + " is no record of a laser log (ODOM, SCAN)"};
  }
}

}  // namespace straightedge::io
