// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "straightedge/found_planes.hpp"
#include "straightedge/host/image.hpp"

/// How well labels and planes of a depth frame meet the truth.
namespace support {

using Labels = straightedge::Image<std::uint16_t>;

/// Readings by (true surface, label); those of no surface and no label too.
using LabelTable = std::map<std::pair<std::uint16_t, std::uint16_t>, int>;

inline LabelTable count_pairs(const Labels& labels, const Labels& raw, const Labels& truth) {
  LabelTable table;
  for (int y = 0; y < raw.height(); ++y) {
    for (int x = 0; x < raw.width(); ++x) {
      if (raw.at(x, y) != 0) ++table[{truth.at(x, y), labels.at(x, y)}];
    }
  }
  return table;
}

/// Share of the readings whose label is right: label 0 for surface 0, each other label for the surface that
/// most of its readings look at, each surface for the one label that serves it best.
inline double agreement(const Labels& labels, const Labels& raw, const Labels& truth) {
  std::map<std::uint16_t, std::pair<std::uint16_t, int>> surface_of;  // a label's surface, and readings there
  int readings = 0;
  for (const auto& [pair, count] : count_pairs(labels, raw, truth)) {
    readings += count;
    if ((pair.first == 0) != (pair.second == 0)) continue;
    auto& best = surface_of[pair.second];
    if (count > best.second) best = {pair.first, count};
  }
  std::map<std::uint16_t, int> right;
  for (const auto& [label, best] : surface_of) {
    right[best.first] = std::max(right[best.first], best.second);
  }
  int sum = 0;
  for (const auto& [surface, count] : right) sum += count;
  return readings > 0 ? static_cast<double>(sum) / readings : 1;
}

/// How many of the planes found are this one.
inline int count_of(const std::vector<straightedge::FoundPlane>& planes, const straightedge::Plane& truth,
                    double angle_rad = 0.02, double distance_m = 0.02) {
  return static_cast<int>(
      std::count_if(planes.begin(), planes.end(), [&](const straightedge::FoundPlane& found) {
        const straightedge::Plane& p = found.fit.plane;
        return dot(p.normal, truth.normal) > std::cos(angle_rad) &&
               std::fabs(p.distance - truth.distance) < distance_m;
      }));
}

/// Counts over many frames; a surface is correct when it and one label share most of the readings of both
/// (doi:10.1109/34.506791). Surfaces and labels with few readings are left out.
struct SegmentationScore {
  static constexpr double overlap = 0.8;
  static constexpr int least_readings = 1000;

  int surfaces = 0, found = 0, correct = 0;
  double labelled = 0, pure = 0, on_surfaces = 0, covered = 0;  ///< readings

  void add(const Labels& labels, const Labels& raw, const Labels& truth) {
    const LabelTable table = count_pairs(labels, raw, truth);
    std::map<std::uint16_t, int> of_surface, of_label, purest;
    for (const auto& [pair, count] : table) {
      of_surface[pair.first] += count;
      of_label[pair.second] += count;
      if (pair.first != 0) purest[pair.second] = std::max(purest[pair.second], count);
      on_surfaces += pair.first != 0 ? count : 0;
      covered += pair.first != 0 && pair.second != 0 ? count : 0;
    }
    for (const auto& [id, count] : of_surface) surfaces += id != 0 && count >= least_readings ? 1 : 0;
    for (const auto& [label, count] : of_label) {
      if (label == 0 || count < least_readings) continue;
      ++found;
      labelled += count;
      pure += purest[label];
    }
    for (const auto& [pair, count] : table) {
      const int surface = of_surface[pair.first], label = of_label[pair.second];
      if (pair.first == 0 || pair.second == 0 || std::min(surface, label) < least_readings) continue;
      correct += count >= overlap * surface && count >= overlap * label ? 1 : 0;  // 80 %: one pair at most
    }
  }
  double correct_share() const { return surfaces > 0 ? static_cast<double>(correct) / surfaces : 1; }
  double precision() const { return found > 0 ? static_cast<double>(correct) / found : 1; }
  double purity() const { return labelled > 0 ? pure / labelled : 1; }
  double coverage() const { return on_surfaces > 0 ? covered / on_surfaces : 1; }
};

}  // namespace support
