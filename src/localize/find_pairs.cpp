// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "localize/match.hpp"
#include "straightedge/trigonometry.hpp"

namespace straightedge::localize {
namespace {

// The uncertainty of the pose along a wall makes its ends uncertain, but not without limit.
constexpr double most_end_slack_m = 1.5;

/// A line of the scan, put into the world by the pose.
struct Placed {
  double nx = 1, ny = 0;
  double cx = 0, cy = 0;
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  double length = 0;
};

Placed place(const ScanLine& line, const Pose2& pose) {
  const SineCosine turn = sine_cosine(pose.heading_rad);
  const double c = turn.cosine, s = turn.sine;
  const auto x = [&](double px, double py) { return pose.x_m + c * px - s * py; };
  const auto y = [&](double px, double py) { return pose.y_m + s * px + c * py; };
  Placed p;
  p.nx = c * line.normal_x - s * line.normal_y;
  p.ny = s * line.normal_x + c * line.normal_y;
  p.cx = x(line.centroid_x_m, line.centroid_y_m);
  p.cy = y(line.centroid_x_m, line.centroid_y_m);
  p.x0 = x(line.x0_m, line.y0_m);
  p.y0 = y(line.x0_m, line.y0_m);
  p.x1 = x(line.x1_m, line.y1_m);
  p.y1 = y(line.x1_m, line.y1_m);
  p.length = std::sqrt((p.x1 - p.x0) * (p.x1 - p.x0) + (p.y1 - p.y0) * (p.y1 - p.y0));
  return p;
}

double end_slack(const Wall& wall, const StateMatrix& p, const MatchOptions& options) {
  const double tx = -wall.ny, ty = wall.nx;
  const double along = tx * tx * p(0, 0) + 2 * tx * ty * p(0, 1) + ty * ty * p(1, 1);
  return options.end_slack_m + std::min(most_end_slack_m, 2 * std::sqrt(std::max(0.0, along)));
}

bool overlaps(const Wall& wall, const Placed& p, double slack, double share) {
  const double s0 = wall.along(p.x0, p.y0), s1 = wall.along(p.x1, p.y1);
  const double common =
      std::min(std::max(s0, s1), wall.end + slack) - std::max(std::min(s0, s1), wall.begin - slack);
  return common > 0 && common >= share * p.length;
}

/// How far a wall got; the order of the stages.
int stage_of(LineVerdict verdict) {
  switch (verdict) {
    case LineVerdict::wrong_side:
      return 1;
    case LineVerdict::no_overlap:
      return 2;
    case LineVerdict::gate:
      return 3;
    case LineVerdict::matched:
      return 4;
    default:
      return 0;
  }
}

LineVerdict judge_wall(const WallMap& map, const PoseBelief& belief, const ScanLine& line, const Placed& p,
                       const MatchOptions& options, LinePair& pair) {
  const Wall& wall = map.walls()[pair.wall];
  const double facing = p.nx * wall.nx + p.ny * wall.ny;
  if (!wall.open_on(facing > 0)) return LineVerdict::wrong_side;
  if (!overlaps(wall, p, end_slack(wall, belief.covariance, options), options.min_overlap))
    return LineVerdict::no_overlap;
  pair = make_pair(belief.pose, line, pair.line, map, pair.wall);
  if (!judge_pair(pair, belief, wall)) return LineVerdict::gate;
  return pair.chi_square <= options.gate ? LineVerdict::matched : LineVerdict::gate;
}

/// Of two refusals, the later stage is kept; of two at the gate, the smaller chi-square.
void note(const Wall& wall, LineVerdict verdict, double chi_square, LineMatch& match) {
  const int stage = stage_of(verdict), before = stage_of(match.verdict);
  if (match.has_wall &&
      (stage < before || (stage == before && !(stage >= 3 && chi_square < match.chi_square))))
    return;
  match = {verdict, wall.line_id, wall.segment_id, true, chi_square};
}

}  // namespace

void find_pairs(const WallMap& map, const PoseBelief& belief, std::span<const ScanLine> lines,
                const MatchOptions& options, PairList& list, std::vector<LineMatch>& matches) {
  list.pairs.clear();
  list.starts.assign(1, 0);
  matches.assign(lines.size(), LineMatch{LineVerdict::no_wall, 0, 0, false, 0});
  const double most_sine = sine(options.max_angle_rad);
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    const Placed p = place(lines[i], belief.pose);
    for (std::uint32_t w = 0; w < map.walls().size(); ++w) {
      const Wall& wall = map.walls()[w];
      if (std::fabs(wall.across(p.cx, p.cy)) > options.max_offset_m) continue;
      if (std::fabs(p.nx * wall.ny - p.ny * wall.nx) > most_sine) continue;
      // A wall that ends far away is none for this line, not one that it misses.
      const double s = wall.along(p.cx, p.cy);
      if (s < wall.begin - p.length - 5 || s > wall.end + p.length + 5) continue;
      LinePair pair;
      pair.line = i;
      pair.wall = w;
      const LineVerdict verdict = judge_wall(map, belief, lines[i], p, options, pair);
      note(wall, verdict, pair.chi_square, matches[i]);
      if (verdict == LineVerdict::matched) list.pairs.push_back(pair);
    }
    const auto begin = list.pairs.begin() + list.starts.back();
    std::sort(begin, list.pairs.end(), [](const LinePair& a, const LinePair& b) {
      return a.chi_square < b.chi_square || (a.chi_square == b.chi_square && a.wall < b.wall);
    });
    if (list.pairs.size() > list.starts.back() + options.max_branches)
      list.pairs.resize(list.starts.back() + options.max_branches);
    list.starts.push_back(static_cast<std::uint32_t>(list.pairs.size()));
  }
}

}  // namespace straightedge::localize
