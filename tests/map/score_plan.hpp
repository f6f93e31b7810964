// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "draw_plan.hpp"

namespace plan {

struct Score {
  double truth = 0, hit = 0;      ///< true walls, and those that are covered by at least four fifths
  double found = 0, right = 0;    ///< segments of the map, and those that lie on a true wall
  double covered = 0, drawn = 0;  ///< length of true walls that is covered, and all that was drawn on them
  std::vector<double> offsets, angles;

  double recall() const { return hit / truth; }
  double precision() const { return right / found; }
  double redundancy() const { return drawn / covered; }

  void add(const Score& other) {
    truth += other.truth;
    hit += other.hit;
    found += other.found;
    right += other.right;
    covered += other.covered;
    drawn += other.drawn;
    offsets.insert(offsets.end(), other.offsets.begin(), other.offsets.end());
    angles.insert(angles.end(), other.angles.begin(), other.angles.end());
  }
};

struct Stretch {
  double from = 0, to = 0;
  double length() const { return std::max(to - from, 0.0); }
};

/// Where on the true wall a found segment lies; nothing when it is more than 2 degrees or 1.5 pixels off.
inline Stretch stretch_on(const Wall& truth, const Wall& found) {
  const double reach = 1.5;
  if (angle_between(truth, found) > 2 * straightedge::degree ||
      std::fabs(distance_from(truth, found.a)) > reach || std::fabs(distance_from(truth, found.b)) > reach)
    return {};
  const double a = along(truth, found.a), b = along(truth, found.b);
  return {std::max(std::min(a, b), 0.0), std::min(std::max(a, b), truth.length())};
}

inline double length_of_union(std::vector<Stretch> stretches) {
  std::sort(stretches.begin(), stretches.end(),
            [](const Stretch& a, const Stretch& b) { return a.from < b.from; });
  double sum = 0, end = 0;
  for (const Stretch& s : stretches) {
    sum += std::max(s.to - std::max(s.from, end), 0.0);
    end = std::max(end, s.to);
  }
  return sum;
}

/// Compares by length: a wall in two pieces is as good as one, but a wall drawn twice is not.
inline Score score(const std::vector<Wall>& truth, const std::vector<Found>& found) {
  Score out;
  out.truth = static_cast<double>(truth.size());
  out.found = static_cast<double>(found.size());
  std::vector<double> own(found.size(), 0.0);
  for (const Wall& wall : truth) {
    std::vector<Stretch> stretches;
    for (std::size_t i = 0; i < found.size(); ++i) {
      const Stretch s = stretch_on(wall, found[i].wall);
      if (s.length() <= 0) continue;
      stretches.push_back(s);
      own[i] = std::max(own[i], s.length());
      out.drawn += s.length();
      if (s.length() < 0.8 * wall.length()) continue;
      out.offsets.push_back(offset_error(found[i].wall, wall));
      out.angles.push_back(angle_between(found[i].wall, wall));
    }
    const double covered = length_of_union(stretches);
    out.covered += covered;
    out.hit += covered >= 0.8 * wall.length() ? 1 : 0;
  }
  for (std::size_t i = 0; i < found.size(); ++i) out.right += own[i] >= 0.8 * found[i].wall.length() ? 1 : 0;
  return out;
}

inline double median(std::vector<double> values) {
  if (values.empty()) return 1e9;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

}  // namespace plan
