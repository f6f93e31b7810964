// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "io/number_text.hpp"
#include "io/quoted_word.hpp"
#include "straightedge/host/laser_log.hpp"

/// What the two readers of laser logs share.
namespace straightedge::io {

/// Thrown by the readers and caught in laser_log.cpp, so that the formats read as they are written.
struct BadRecord {
  std::string sentence;
};

/// The words of a record, taken one after the other.
class LogRecord {
 public:
  explicit LogRecord(std::string_view line) : rest_(line.substr(0, line.find('#'))), kind_(take()) {}

  std::string_view kind() const noexcept { return kind_; }
  bool at_end() const noexcept { return rest_.find_first_not_of(blanks) == std::string_view::npos; }

  std::string_view word(const char* what) {
    const std::string_view text = take();
    if (text.empty()) throw BadRecord{"the record ends before its " + std::string(what)};
    return text;
  }

  /// "nan" and "inf" are numbers here.
  double any_number(const char* what) {
    const std::string_view text = word(what);
    const auto value = number_from_text<double>(text);
    if (!value) throw BadRecord{std::string(what) + " " + quoted(text) + " is no number"};
    return *value;
  }

  double number(const char* what) {
    const double value = any_number(what);
    if (!std::isfinite(value)) throw BadRecord{std::string(what) + " is not finite"};
    return value;
  }

  Pose2 pose(const char* what) {
    Pose2 pose;
    for (double* const part : {&pose.x_m, &pose.y_m, &pose.heading_rad}) *part = number(what);
    if (!usable(pose)) throw BadRecord{std::string(what) + " lies too far out"};
    return pose;
  }

  std::size_t beams() {
    const std::string_view text = word("number of beams");
    const auto count = number_from_text<std::uint64_t>(text);
    if (!count || *count > max_scan_beams)
      throw BadRecord{"the number of beams is " + quoted(text) + " and not a whole number from 0 to " +
                      to_text(max_scan_beams)};
    return static_cast<std::size_t>(*count);
  }

  std::vector<float> ranges(std::size_t count) {
    std::vector<float> all;
    all.reserve(std::min(count, rest_.size() / 2 + 1));  // a range has a digit and a blank
    for (std::size_t i = 0; i < count; ++i) {
      constexpr auto most = static_cast<double>(std::numeric_limits<float>::max());
      const double range = any_number("range");
      const double within = std::abs(range) <= most ? range : std::numeric_limits<double>::infinity();
      all.push_back(static_cast<float>(std::isnan(range) ? range : within));
    }
    return all;
  }

  void expect_end(const char* after) const {
    if (!at_end()) throw BadRecord{"more words follow the " + std::string(after)};
  }

 private:
  std::string_view take() { return take_word(rest_); }

  std::string_view rest_;
  std::string_view kind_;
};

/// What a reader of records builds up.
struct LogSoFar {
  LaserLog log;
  std::optional<Pose2> odometry;  ///< the last record's
};

/// Read one record each; throw BadRecord.
void take_text_record(LogRecord& record, LogSoFar& so_far);
void take_carmen_record(LogRecord& record, LogSoFar& so_far);

}  // namespace straightedge::io
