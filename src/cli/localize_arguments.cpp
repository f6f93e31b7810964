// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/localize_arguments.hpp"

#include <algorithm>
#include <vector>

#include "cli/number_option.hpp"
#include "cli/outputs.hpp"
#include "io/number_text.hpp"
#include "straightedge/trigonometry.hpp"

namespace straightedge::cli {
namespace {

constexpr double most_m = 1e8;
constexpr double most_degrees = 36000;

/// As many numbers as wanted, with blanks or commas between them.
std::vector<double> numbers_of(const std::string& name, std::string text, std::size_t wanted,
                               const char* form) {
  std::replace(text.begin(), text.end(), ',', ' ');
  std::vector<double> numbers;
  bool good = true;
  std::string_view rest = text;
  for (std::string_view word = io::take_word(rest); !word.empty(); word = io::take_word(rest)) {
    const auto number = io::number_from_text<double>(word);
    good = good && number && *number > -most_m && *number < most_m;
    numbers.push_back(number.value_or(0));
  }
  if (!good || numbers.size() != wanted)
    throw CLI::ValidationError(name, "\"" + text + "\" is not " + form + " below 1e8");
  return numbers;
}

CLI::Option* add_pose(CLI::App& command, const std::string& name, std::optional<Pose2>& target,
                      const std::string& help) {
  const auto read = [name, &target](const std::string& text) {
    const std::vector<double> v = numbers_of(name, text, 3, "three numbers X Y DEGREES");
    if (!(v[2] >= -most_degrees && v[2] <= most_degrees))
      throw CLI::ValidationError(name, "\"" + text + "\" turns by more than 36000 degrees");
    target = Pose2{v[0], v[1], wrap_angle(v[2] * degree)};
  };
  return command.add_option_function<std::string>(name, read, help)->type_name("X,Y,DEGREES");
}

std::string pose_words(const Pose2& pose) {
  return io::to_text(pose.x_m) + " " + io::to_text(pose.y_m) + " " +
         io::to_short_text(pose.heading_rad / degree);
}

const char* name_of(ScanLineMethod method) {
  if (method == ScanLineMethod::ransac) return "ransac";
  return method == ScanLineMethod::hough ? "hough" : "split";
}

const char* name_of(OdometrySource source) {
  if (source == OdometrySource::flaser) return "flaser";
  return source == OdometrySource::none ? "none" : "odom";
}

}  // namespace

void LocalizeArguments::add_to(CLI::App& command) {
  add_files(command);
  add_robot(command);
  add_matching(command);
}

void LocalizeArguments::add_files(CLI::App& command) {
  command.add_option("MAP.xml", map, "the line map, in metres or with its resolution; - is standard input")
      ->required();
  command
      .add_option(
          "SCANS", scans,
          "the laser's log: ODOM and SCAN records, or CARMEN's ODOM and FLASER; may be packed by gzip; "
          "- is standard input")
      ->required();
  command
      .add_option(
          "-o,--output", trajectory,
          "where the poses go, a line \"t x y 0 0 0 qz qw\" (TUM) for each scan with a pose; none while "
          "the robot searches or is lost; - is standard output")
      ->type_name("TRAJECTORY.txt")
      ->required();
  command.add_option("--covariance", covariance, "a line \"t xx xy xh yy yh hh\" for each of these poses")
      ->type_name("FILE");
  command.add_option("--svg", svg, "the map, the robot's way, and the scans laid on the walls")
      ->type_name("OUT.svg");
  command
      .add_option(
          "--truth", truth,
          "where the robot really was, lines \"t x y theta\" or TUM's; the errors are told, nothing else "
          "changes")
      ->type_name("FILE");
  command.add_option("--explain", explain, "every step of one scan as a picture, with a page")
      ->type_name("DIR");
  explain_scan_option_ =
      add_whole(command, "--explain-scan", explain_scan, {0, 1000000000}, "N",
                "which scan that is, the first is 1; 0: the first that matched lines of the map");
}

void LocalizeArguments::add_robot(CLI::App& command) {
  add_pose(command, "--start", start_,
           "where the robot stands at the first scan, in the map's world, three numbers with blanks or "
           "commas between; without it the place is searched");
  const auto read_sigma = [this](const std::string& text) {
    const std::vector<double> v = numbers_of("--start-sigma", text, 2, "two numbers METRES DEGREES");
    if (!(v[0] > 0 && v[0] <= 100 && v[1] > 0 && v[1] <= 180))
      throw CLI::ValidationError("--start-sigma",
                                 "\"" + text + "\" is not above 0 and at most 100 m and 180 degrees");
    start_sigma_ = {v[0], v[0], v[1] * degree};
  };
  start_sigma_option_ = command
                            .add_option_function<std::string>("--start-sigma", read_sigma,
                                                              "how sure that is: standard deviations")
                            ->type_name("METRES,DEGREES")
                            ->default_str("0.2," + io::to_short_text(start_sigma_.heading_rad / degree));
  add_pose(command, "--laser", laser_, "where the laser sits in the robot, in place of the log's");
  add_choice(
      command, "--odometry", odometry_,
      {{"odom", OdometrySource::records}, {"flaser", OdometrySource::flaser}, {"none", OdometrySource::none}},
      "which poses of the log are odometry: its ODOM records, the laser's poses in CARMEN's FLASER (of raw "
      "logs; corrected ones hold a mapping program's there), or none");
  add_real(command, "--max-range", max_range_m_, {0, 1e6}, "METRES",
           "readings from here on are none; 0 is the log's own, 80 for CARMEN's");
}

void LocalizeArguments::add_matching(CLI::App& command) {
  add_choice(command, "--lines", options_.lines.method,
             {{"split", ScanLineMethod::split_and_merge},
              {"ransac", ScanLineMethod::ransac},
              {"hough", ScanLineMethod::hough}},
             "how the lines of a scan are found: split and merge, RANSAC or the Hough transform");
  add_real(command, "--noise", options_.lines.range_sigma_m, {0, 1}, "METRES",
           "standard deviation of a range, above 0");
  add_real(command, "--min-length", options_.lines.min_length_m, {0.05, 100}, "METRES",
           "shorter lines of a scan are dropped");
  add_choice(command, "--association", options_.match.association,
             {{"joint", Association::joint}, {"nearest", Association::nearest}},
             "lines and walls are paired by the largest set that agrees, or each by itself");
  add_real(command, "--gate", options_.match.gate, {0, 1000, false}, "CHI2",
           "pairs farther apart than this are refused; chi-square of 2 degrees of freedom");
}

Result<Done> LocalizeArguments::check() const {
  const auto bad = [](const std::string& sentence) { return Failure{Problem::bad_option, sentence}; };
  if (map == "-" && scans == "-") return bad("MAP.xml and SCANS cannot both be standard input");
  if (start_sigma_option_->count() > 0 && !start_) return bad("--start-sigma needs --start");
  if (explain_scan_option_->count() > 0 && explain.empty()) return bad("--explain-scan needs --explain");
  if (!(options_.lines.range_sigma_m > 0)) return bad("--noise must be above 0");
  return Done{};
}

LocalizeOptions LocalizeArguments::options() const {
  LocalizeOptions options = options_;
  options.lines.seed = common.seed;
  options.start = start_;
  options.start_covariance = {};
  options.start_covariance[0] = start_sigma_.x_m * start_sigma_.x_m;
  options.start_covariance[4] = start_sigma_.y_m * start_sigma_.y_m;
  options.start_covariance[8] = start_sigma_.heading_rad * start_sigma_.heading_rad;
  return options;
}

Result<Done> LocalizeArguments::apply_to(LaserLog& log) const {
  if (odometry_ == OdometrySource::flaser && log.format != LaserLogFormat::carmen)
    return Failure{Problem::bad_option, "--odometry flaser: " + scans + " is no CARMEN log"};
  for (LoggedScan& logged : log.scans) {
    if (odometry_ == OdometrySource::none) logged.odometry.reset();
    if (odometry_ == OdometrySource::flaser) logged.odometry = logged.recorded;
    if (max_range_m_ > 0) logged.scan.max_range_m = max_range_m_;
    if (laser_) logged.scan.laser_in_robot = *laser_;
  }
  return Done{};
}

std::string LocalizeArguments::words() const {
  std::string text = std::string("lines ") + name_of(options_.lines.method);
  text += ", noise " + io::to_text(options_.lines.range_sigma_m);
  text += ", min-length " + io::to_text(options_.lines.min_length_m);
  text += options_.match.association == Association::joint ? ", joint" : ", nearest";
  text += ", gate " + io::to_text(options_.match.gate) + ", odometry " + name_of(odometry_);
  if (max_range_m_ > 0) text += ", max-range " + io::to_text(max_range_m_);
  if (laser_) text += ", laser " + pose_words(*laser_);
  if (start_) {
    text += ", start " + pose_words(*start_) + ", start-sigma " + io::to_text(start_sigma_.x_m) + " " +
            io::to_short_text(start_sigma_.heading_rad / degree);
  }
  return text + ", seed " + io::to_text(common.seed) + "; of " + base_name(scans) + " in " + base_name(map);
}

}  // namespace straightedge::cli
