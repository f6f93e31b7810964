// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "localize/pose_candidates.hpp"

#include <algorithm>
#include <cmath>

#include "straightedge/trigonometry.hpp"

namespace straightedge::localize {

WallFaces::WallFaces(const WallMap& map) {
  for (std::uint32_t i = 0; i < map.walls().size(); ++i) {
    const Wall& wall = map.walls()[i];
    for (const bool plus : {true, false}) {
      if (!wall.open_on(plus)) continue;
      const double side = plus ? 1 : -1;
      faces_.push_back({wrap_angle(plus ? wall.theta : wall.theta + pi), side * wall.nx, side * wall.ny, i});
    }
  }
  std::stable_sort(faces_.begin(), faces_.end(),
                   [](const Face& a, const Face& b) { return a.theta < b.theta; });
}

template <class Visit>
void WallFaces::near(double theta, double tolerance, const Visit& visit) const {
  for (const double turn : {-2 * pi, 0.0, 2 * pi}) {
    const double low = theta + turn - tolerance, high = theta + turn + tolerance;
    auto at = std::lower_bound(faces_.begin(), faces_.end(), low,
                               [](const Face& face, double value) { return face.theta < value; });
    for (; at != faces_.end() && at->theta <= high; ++at) visit(*at);
  }
}

namespace {

using Face = WallFaces::Face;

constexpr std::size_t most_lines = 7;    // of the scan, the longest ones
constexpr double least_sine = 0.3;       // between two lines that fix a place
constexpr double angle_tolerance = 0.1;  // radians, between pairs of lines and of walls
constexpr double end_slack_m = 0.6;      // a line may reach so far past its wall
constexpr double slide_step_m = 0.7;
constexpr std::size_t quick_readings = 16;
constexpr std::size_t most_scored = 600;  // by all readings
constexpr double same_place_m = 0.6;
constexpr double same_heading_rad = 0.2;

double length_of(const ScanLine& line) {
  const double dx = line.x1_m - line.x0_m, dy = line.y1_m - line.y0_m;
  return std::sqrt(dx * dx + dy * dy);
}

/// Tries poses and keeps the likeliest by a few readings.
class Trials {
 public:
  Trials(const WallMap& map, const Readings& readings, double tolerance, const SearchOptions& options)
      : map_(map), tolerance_(tolerance), most_(options.max_pairs) {
    quick_.laser_x_m = readings.laser_x_m;
    quick_.laser_y_m = readings.laser_y_m;
    const std::size_t count = std::min(quick_readings, readings.ends.size());
    for (std::size_t i = 0; i < count; ++i)
      quick_.ends.push_back(readings.ends[(2 * i + 1) * readings.ends.size() / (2 * count)]);
  }

  bool full() const { return tried_ >= most_; }
  std::uint32_t tried() const { return tried_; }

  void add(const Pose2& pose) {
    if (full()) return;
    ++tried_;
    kept_.push_back({pose, score_pose(map_, pose, quick_, tolerance_).log_likelihood});
    if (kept_.size() >= 4 * most_scored) shrink();
  }

  std::vector<CandidatePose>& finish() {
    shrink();
    return kept_;
  }

 private:
  void shrink() {
    std::stable_sort(kept_.begin(), kept_.end(), [](const CandidatePose& a, const CandidatePose& b) {
      return a.log_likelihood > b.log_likelihood;
    });
    if (kept_.size() > most_scored) kept_.resize(most_scored);
  }

  const WallMap& map_;
  Readings quick_;
  double tolerance_;
  std::uint32_t most_, tried_ = 0;
  std::vector<CandidatePose> kept_;
};

struct Turned {
  double x = 0, y = 0;
};

Turned turned(double x, double y, const SineCosine& turn) {
  return {turn.cosine * x - turn.sine * y, turn.sine * x + turn.cosine * y};
}

/// Both ends of the line lie on the wall, with some slack.
bool lies_on(const ScanLine& line, const Wall& wall, const Pose2& pose, const SineCosine& turn) {
  const Turned a = turned(line.x0_m, line.y0_m, turn), b = turned(line.x1_m, line.y1_m, turn);
  for (const Turned& end : {a, b}) {
    const double s = wall.along(pose.x_m + end.x, pose.y_m + end.y);
    if (s < wall.begin - end_slack_m || s > wall.end + end_slack_m) return false;
  }
  return true;
}

/// How far the turned line's centroid must be moved along the face's normal.
double offset_to(const Face& face, const Wall& wall, const Turned& centroid) {
  return face.nx * (wall.x - centroid.x) + face.ny * (wall.y - centroid.y);
}

/// Way a.
void try_pair(const WallMap& map, const ScanLine& a, const ScanLine& b, const Face& on_a, const Face& on_b,
              Trials& trials) {
  const Wall &wall_a = map.walls()[on_a.wall], &wall_b = map.walls()[on_b.wall];
  if (length_of(b) > wall_b.length() + 2 * end_slack_m) return;
  const double heading_a = wrap_angle(on_a.theta - a.theta_rad);
  const double difference = wrap_angle(on_b.theta - b.theta_rad - heading_a);
  const double share = a.var_theta / (a.var_theta + b.var_theta);
  const double heading = wrap_angle(heading_a + share * difference);
  const SineCosine turn = sine_cosine(heading);
  const double determinant = on_a.nx * on_b.ny - on_a.ny * on_b.nx;
  if (std::fabs(determinant) < 0.5 * least_sine) return;
  const double da = offset_to(on_a, wall_a, turned(a.centroid_x_m, a.centroid_y_m, turn));
  const double db = offset_to(on_b, wall_b, turned(b.centroid_x_m, b.centroid_y_m, turn));
  const Pose2 pose{(da * on_b.ny - db * on_a.ny) / determinant, (db * on_a.nx - da * on_b.nx) / determinant,
                   heading};
  if (lies_on(a, wall_a, pose, turn) && lies_on(b, wall_b, pose, turn)) trials.add(pose);
}

void try_pairs(const WallMap& map, const WallFaces& faces, std::span<const ScanLine> lines, Trials& trials) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t j = i + 1; j < lines.size(); ++j) {
      const ScanLine &a = lines[i], &b = lines[j];
      if (std::fabs(a.normal_x * b.normal_y - a.normal_y * b.normal_x) < least_sine) continue;
      for (const Face& on_a : faces.all()) {
        if (trials.full()) return;
        if (length_of(a) > map.walls()[on_a.wall].length() + 2 * end_slack_m) continue;
        faces.near(wrap_angle(b.theta_rad + on_a.theta - a.theta_rad), angle_tolerance,
                   [&](const Face& on_b) { try_pair(map, a, b, on_a, on_b, trials); });
      }
    }
  }
}

/// The pose with the line on the face, its end 0 at `s` along the wall.
Pose2 pose_at(const ScanLine& line, const Face& face, const Wall& wall, double s) {
  const double heading = wrap_angle(face.theta - line.theta_rad);
  const Turned end = turned(line.x0_m, line.y0_m, sine_cosine(heading));
  return {wall.x - s * wall.ny - end.x, wall.y + s * wall.nx - end.y, heading};
}

/// Ways b and c. The way from end 0 to end 1 has the floor on its left.
void try_ends(const WallMap& map, const WallFaces& faces, const ScanLine& line, bool slide, Trials& trials) {
  const double length = length_of(line);
  for (const Face& face : faces.all()) {
    const Wall& wall = map.walls()[face.wall];
    if (length > wall.length() + 2 * end_slack_m) continue;
    // End 0 to end 1 runs against (−ny, nx) of the face's normal.
    const double way = face.nx * wall.nx + face.ny * wall.ny > 0 ? -1 : 1;
    const double first = way > 0 ? wall.begin : wall.end, last = way > 0 ? wall.end : wall.begin;
    trials.add(pose_at(line, face, wall, first));
    trials.add(pose_at(line, face, wall, last - way * length));
    for (double s = slide_step_m; slide && s + length < wall.length(); s += slide_step_m)
      trials.add(pose_at(line, face, wall, first + way * s));
  }
}

}  // namespace

bool same_place(const Pose2& a, const Pose2& b) noexcept {
  const double dx = a.x_m - b.x_m, dy = a.y_m - b.y_m;
  return dx * dx + dy * dy < same_place_m * same_place_m &&
         std::fabs(wrap_angle(a.heading_rad - b.heading_rad)) < same_heading_rad;
}

void find_candidates(const WallMap& map, const WallFaces& faces, std::span<const ScanLine> lines,
                     const Readings& readings, double tolerance_m, const SearchOptions& options,
                     std::vector<CandidatePose>& candidates, SearchCounts& counts) {
  candidates.clear();
  std::vector<ScanLine> longest(lines.begin(), lines.end());
  std::stable_sort(longest.begin(), longest.end(),
                   [](const ScanLine& a, const ScanLine& b) { return length_of(a) > length_of(b); });
  if (longest.size() > most_lines) longest.resize(most_lines);
  Trials trials(map, readings, tolerance_m, options);
  try_pairs(map, faces, longest, trials);
  for (std::size_t i = 0; i < longest.size(); ++i) try_ends(map, faces, longest[i], i == 0, trials);
  // Step d.
  std::vector<CandidatePose>& tried = trials.finish();
  counts.pairs += trials.tried();
  counts.candidates += static_cast<std::uint32_t>(tried.size());
  for (CandidatePose& candidate : tried)
    candidate.log_likelihood = score_pose(map, candidate.pose, readings, tolerance_m).log_likelihood;
  std::stable_sort(tried.begin(), tried.end(), [](const CandidatePose& a, const CandidatePose& b) {
    return a.log_likelihood > b.log_likelihood;
  });
  for (const CandidatePose& candidate : tried) {
    if (candidates.size() >= options.max_hypotheses) return;
    const bool known = std::any_of(candidates.begin(), candidates.end(), [&](const CandidatePose& other) {
      return same_place(candidate.pose, other.pose);
    });
    if (!known) candidates.push_back(candidate);
  }
}

}  // namespace straightedge::localize
