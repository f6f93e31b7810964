// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

/// What the checks of line maps and of plane maps share.
namespace straightedge::io {

/// How far a point may lie off the line or plane that it belongs to, as a part of max(1, size).
inline constexpr double off_feature_tolerance = 1e-6;

inline bool all_finite(std::span<const double> values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

/// Calls `report` for each place that has the id of one before it. A place begins with its id; the
/// rest of it tells the order.
template <class Place, class Report>
void for_each_repeated(std::vector<Place> places, const Report& report) {
  std::sort(places.begin(), places.end());
  for (std::size_t i = 1; i < places.size(); ++i) {
    if (places[i].id == places[i - 1].id) report(places[i]);
  }
}

/// Whether the symmetric matrix, given by its upper triangle row by row, is positive semidefinite within
/// rounding. `scales[i]` says how large coordinate i is (a standard deviation); what is left after
/// division by the scales is taken to carry an error of 1e-9. A coordinate of scale 0 must be certain.
bool is_semidefinite(std::span<const double> upper, std::span<const double> scales);

}  // namespace straightedge::io
