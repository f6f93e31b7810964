// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numeric>

#include "localize/pieces.hpp"
#include "localize/scan_points.hpp"

namespace straightedge::localize {
namespace {

// "The same line", 2 degrees of freedom, one true pair in a thousand refused.
constexpr double same_line = 13.8;

/// Step 2.
void cut_runs(const PointRow& row, std::vector<Stretch>& runs) {
  runs.clear();
  const auto count = static_cast<std::uint32_t>(row.points.size());
  std::uint32_t begin = 0;
  for (std::uint32_t i = 1; i <= count; ++i) {
    if (i < count) {
      const ScanPoint &a = row.points[i - 1], &b = row.points[i];
      const double limit = allowed_gap(a, b, row.options, row.angle_step_rad);
      const double dx = a.x_m - b.x_m, dy = a.y_m - b.y_m;
      if (dx * dx + dy * dy <= limit * limit) continue;
    }
    runs.push_back({begin, i, static_cast<std::uint32_t>(runs.size())});
    begin = i;
  }
}

/// The point of the stretch that is farthest from the line through its ends.
std::uint32_t farthest(const PointRow& row, const Stretch& s, double& distance) {
  const ScanPoint &a = row.points[s.begin], &b = row.points[s.end - 1];
  const double dx = b.x_m - a.x_m, dy = b.y_m - a.y_m;
  const double length = std::sqrt(dx * dx + dy * dy);
  std::uint32_t at = s.begin;
  distance = 0;
  for (std::uint32_t i = s.begin + 1; i + 1 < s.end; ++i) {
    const double px = row.points[i].x_m - a.x_m, py = row.points[i].y_m - a.y_m;
    // A run that comes back to where it began has no direction.
    const double d = length > 1e-9 ? std::fabs(px * dy - py * dx) / length : std::sqrt(px * px + py * py);
    if (d > distance) {
      distance = d;
      at = i;
    }
  }
  return at;
}

/// Step 3. Pieces come out in the order of the row.
void split(const PointRow& row, StretchMemory& memory, ScanLineCounts& counts) {
  memory.done.clear();
  std::reverse(memory.todo.begin(), memory.todo.end());
  while (!memory.todo.empty()) {
    const Stretch s = memory.todo.back();
    memory.todo.pop_back();
    if (s.end - s.begin < row.options.min_points) {
      ++counts.too_few;
      continue;
    }
    double distance = 0;
    const std::uint32_t at = farthest(row, s, distance);
    if (distance > row.options.split_distance_m) {
      memory.todo.push_back({at, s.end, s.run});  // the corner point is of both
      memory.todo.push_back({s.begin, at + 1, s.run});
    } else {
      memory.done.push_back(s);
    }
  }
}

/// Step 4. Whether both stretches, and what lies between, are one line.
bool one_line(const PointRow& row, const StretchMemory& memory, const Stretch& a, const Stretch& b) {
  if (a.run != b.run || b.begin > a.end) return false;
  const auto numbers = [&](const Stretch& s) {
    return std::span<const std::uint32_t>(memory.numbers).subspan(s.begin, s.end - s.begin);
  };
  const Stretch both{a.begin, b.end, a.run};
  LineFit fit, fit_a, fit_b;
  if (!fit_points(row.points, numbers(both), row.laser, row.options, fit)) return false;
  for (std::uint32_t i = both.begin; i < both.end; ++i) {
    if (std::fabs(fit.distance(row.points[i].x_m, row.points[i].y_m)) > row.options.split_distance_m)
      return false;
  }
  return fit_points(row.points, numbers(a), row.laser, row.options, fit_a) &&
         fit_points(row.points, numbers(b), row.laser, row.options, fit_b) &&
         line_chi_square(fit_a, fit_b) <= same_line;
}

}  // namespace

void split_and_merge(const PointRow& row, StretchMemory& memory, Pieces& pieces, ScanLineCounts& counts) {
  memory.numbers.resize(row.points.size());
  std::iota(memory.numbers.begin(), memory.numbers.end(), 0U);
  cut_runs(row, memory.todo);
  split(row, memory, counts);
  std::vector<Stretch>& merged = memory.todo;  // empty by now
  for (const Stretch& s : memory.done) {
    if (!merged.empty() && one_line(row, memory, merged.back(), s)) {
      merged.back().end = s.end;
      ++counts.merged;
    } else {
      merged.push_back(s);
    }
  }
  for (const Stretch& s : merged) {
    for (std::uint32_t i = s.begin; i < s.end; ++i) pieces.add(i);
    pieces.close();
  }
  merged.clear();
}

}  // namespace straightedge::localize
