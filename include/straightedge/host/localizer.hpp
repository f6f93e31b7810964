// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "straightedge/host/line_map.hpp"
#include "straightedge/host/localize_options.hpp"
#include "straightedge/host/pose2.hpp"
#include "straightedge/host/result.hpp"
#include "straightedge/host/scan_lines.hpp"

namespace straightedge {

enum class LocalizeState : std::uint8_t {
  searching,  ///< no pose yet: candidates are being tried
  tracking,   ///< the pose stands
  lost,       ///< it stood, and does not any more; the search has begun anew
};

/// What there is to say about the scan itself.
enum class ScanVerdict : std::uint8_t {
  used,
  no_readings,     ///< empty, or no reading in it: the pose is predicted alone
  unusable,        ///< step or angle or laser pose is not a number: passed over
  time_backwards,  ///< older than the scan before: passed over
};

/// What became of a line of the scan.
enum class LineVerdict : std::uint8_t {
  matched,     ///< corrected the pose
  no_wall,     ///< no wall of the map near enough in angle and distance
  wrong_side,  ///< near walls have their open floor on the other side
  no_overlap,  ///< near walls end before it
  gate,        ///< chi-square: farther off than the uncertainties allow
  not_joint,   ///< alone compatible, not with the other pairs
  ambiguous,   ///< two walls explain it about equally well, and nothing else tells them apart
  no_pose,     ///< no pose to match from
};

/// One sentence part for each value, for reports.
const char* to_string(LocalizeState state) noexcept;
const char* to_string(ScanVerdict verdict) noexcept;
const char* to_string(LineVerdict verdict) noexcept;

struct LineMatch {
  LineVerdict verdict = LineVerdict::no_pose;
  std::uint32_t line_id = 0;  ///< of the map; of the nearest that was refused too, where there is one
  std::uint32_t segment_id = 0;
  bool has_wall = false;  ///< the two ids mean something
  double chi_square = 0;  ///< of the pair alone, 2 degrees of freedom; where the gate was asked
};

/// Lines of a scan by what became of them; the sum of all but `lines` is `lines`.
struct MatchCounts {
  std::uint32_t lines = 0, matched = 0, no_wall = 0, wrong_side = 0, no_overlap = 0, gate = 0, not_joint = 0,
                ambiguous = 0, no_pose = 0;
};

struct SearchCounts {
  std::uint32_t pairs = 0;       ///< pairs of scan lines with pairs of walls that agree
  std::uint32_t candidates = 0;  ///< poses that were scored
  std::uint32_t hypotheses = 0;  ///< still kept after this scan
};

/// How the readings of a scan lie in the map, seen from the pose (shares of the readings looked at).
struct ScanFit {
  double on_walls = 0;       ///< near the wall that the beam meets first
  double before_walls = 0;   ///< shorter: people, furniture, walls that the map does not have
  double through_walls = 0;  ///< longer: a robot that stands there cannot see this
  double nowhere = 0;        ///< the map has no wall along the beam
};

struct LocalizeResult {
  LocalizeState state = LocalizeState::searching;
  ScanVerdict scan = ScanVerdict::used;
  double time_s = 0;
  Pose2 pose;                          ///< world_from_robot; while not tracking: the best guess, see has_pose
  bool has_pose = false;               ///< tracking; a pose to be used
  std::array<double, 9> covariance{};  ///< of (x, y, heading), row by row, metres and radians
  std::vector<ScanLine> lines;         ///< of the scan, robot frame
  std::vector<LineMatch> matches;      ///< one a line
  ScanLineCounts line_counts;
  MatchCounts match_counts;
  SearchCounts search_counts;  ///< zero while tracking
  ScanFit fit;                 ///< of `pose`
  double mean_chi_square = 0;  ///< of the matched pairs; 2 is ideal
};

/// Finds and follows a robot in a line map by the lines of its laser scanner. Steps of each scan:
///
///  1. Lines of the scan with their covariance (scan_lines.hpp).
///  2. Predict: the odometry's motion since the last scan moves the pose and widens its covariance. Its scale
///     and drift are learnt on the way. Without odometry the last motion goes on, with wide noise.
///  3. Match (docs/localization.md): walls near in angle and distance, of the right side, overlapping, within
///     the chi-square gate; then nearest neighbour, or the joint hypothesis with most pairs. A pair that some
///     equally good hypothesis gives to another wall is ambiguous and not used.
///  4. Correct: extended Kalman filter. The errors of the map's lines are the same in every scan, so they are
///     carried along as "considered" parameters (Schmidt): seeing one wall a thousand times does not make the
///     pose more certain than the wall.
///  5. Check: the readings seen from the pose. A scan that lies much worse than usual is matched once more
///  with
///     a wider prediction, for slips and late odometry. When too few readings lie on walls, or too many
///     behind them, for several scans, the robot is lost.
///  6. Search, while there is no pose: pairs of scan lines on pairs of walls give candidate poses, the
///  readings
///     score them; the best are followed as hypotheses, each with a filter of its own, until one stands out.
///
/// S. F. Schmidt, "Application of state-space methods to navigation problems", 1966,
/// doi:10.1016/B978-1-4831-6716-9.50011-4. J. Neira, J. D. Tardós, "Data association in stochastic mapping
/// using the joint compatibility test", 2001, doi:10.1109/70.976019. K. O. Arras, J. A. Castellanos,
/// R. Siegwart, "Feature-based multi-hypothesis localization and tracking for mobile robots using geometric
/// constraints", ICRA 2002, doi:10.1109/ROBOT.2002.1014734.
///
/// Deterministic. Memory is kept from scan to scan. A value: copies go their own ways.
class Localizer {
 public:
  /// bad_option: an option out of its range. bad_content: the map is in pixels (`to_metres` first), has no
  /// segments, or numbers that are not finite or span more than 1e5 m. The map is copied.
  static Result<Localizer> create(const LineMap& map, const LocalizeOptions& options = {});

  Localizer(Localizer&&) noexcept;
  Localizer& operator=(Localizer&&) noexcept;
  Localizer(const Localizer&);
  Localizer& operator=(const Localizer&);
  ~Localizer();

  /// `odometry`: the odometry's absolute pose at the scan's time, in a frame of its own; differences count.
  /// The result is overwritten by the next call.
  const LocalizeResult& step(const LaserScan& scan, const std::optional<Pose2>& odometry = std::nullopt);

  const LocalizeResult& result() const noexcept;

  /// Puts the robot somewhere: tracking from there on.
  void start_at(const Pose2& pose, const std::array<double, 9>& covariance);

 private:
  struct State;
  explicit Localizer(std::unique_ptr<State> state) noexcept;
  std::unique_ptr<State> state_;
};

}  // namespace straightedge
