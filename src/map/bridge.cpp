// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/bridge.hpp"

#include <algorithm>

#include "map/sample.hpp"

namespace straightedge {
namespace {

constexpr double max_gap = 100;      // pixels
constexpr double wall_share = 0.55;  // of the pieces' own contrast
constexpr double clearance = 3;      // pixels from the wall's edge to where its ground is read

/// How much lighter it is beside the axis than on it, on average.
double contrast(GrayView blurred, const WallLine& line, double begin, double end) {
  const double aside = 0.5 * line.width + clearance;
  double sum = 0;
  int places = 0;
  for (double s = begin; s <= end; s += 1, ++places) {
    const auto gray = [&](double u) {
      return sample(blurred, line.x_at(s) + u * line.nx, line.y_at(s) + u * line.ny);
    };
    sum += 0.5 * (gray(aside) + gray(-aside)) - gray(0);
  }
  return places > 0 ? sum / places : 0;
}

/// Whether the gap between a piece and the next one on its line is wall; then the piece takes the next.
bool bridge(GrayView blurred, WallLine& piece, WallLine& next) {
  const Span other = piece.span_of(next);
  const double gap = other.begin - piece.end;
  if (gap <= 0 || gap > max_gap) return false;
  const double here = contrast(blurred, piece, piece.begin, piece.end);
  const double there = contrast(blurred, piece, other.begin, other.end);
  if (contrast(blurred, piece, piece.end, other.begin) < wall_share * std::min(here, there)) return false;
  piece.end = other.end;
  piece.pixels += next.pixels;
  piece.votes += next.votes;
  piece.count += next.count;
  next.end = next.begin;
  return true;
}

}  // namespace

std::uint32_t bridge_pale_gaps(std::vector<WallLine>& lines,
                               const std::vector<std::vector<std::size_t>>& groups, GrayView blurred) {
  std::uint32_t bridged = 0;
  for (std::vector<std::size_t> group : groups) {
    const WallLine first = lines[group.front()];
    if (!first.axis) continue;
    std::stable_sort(group.begin(), group.end(), [&](std::size_t a, std::size_t b) {
      return first.span_of(lines[a]).begin < first.span_of(lines[b]).begin;
    });
    std::size_t at = group.front();
    for (std::size_t k = 1; k < group.size(); ++k) {
      // Members may run either way along the line; the piece that grows must run the way of the sorting.
      const bool same_way = lines[at].tx() * first.tx() + lines[at].ty() * first.ty() > 0;
      if (same_way && bridge(blurred, lines[at], lines[group[k]])) {
        ++bridged;
      } else {
        at = group[k];
      }
    }
  }
  return bridged;
}

}  // namespace straightedge
