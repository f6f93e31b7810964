// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/merge.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "map/line_floor.hpp"
#include "map/line_grid.hpp"

namespace straightedge {
namespace {

// Nearer than this and no more oblique, two overlapping segments are one wall, whatever the test says.
constexpr double same_place = 2.2;
constexpr double same_direction = 0.26;

LineFit with_floor(const WallLine& line, const PictureFacts& picture) {
  LineFit fit = line.fit;
  add_floor(fit, line.length(), line_floor(picture, line));
  return fit;
}

double facing(const WallLine& a, const WallLine& b) {
  return a.nx * b.nx + a.ny * b.ny;
}

/// Nearly parallel, and the nearer one of b's ends near a's line.
bool near(const WallLine& a, const WallLine& b, double max_angle, double max_offset) {
  if (a.axis != b.axis) return false;
  const double cosine = facing(a, b);
  const double sine = a.nx * b.ny - a.ny * b.nx;
  if (!a.axis && cosine < 0) return false;
  if (std::fabs(sine) > max_angle * std::fabs(cosine)) return false;
  const double d0 = std::fabs(a.across(b.x_at(b.begin), b.y_at(b.begin)));
  const double d1 = std::fabs(a.across(b.x_at(b.end), b.y_at(b.end)));
  return std::min(d0, d1) <= max_offset;
}

bool same_line(const WallLine& a, const WallLine& b, const PictureFacts& picture,
               const MergeOptions& options) {
  return near(a, b, options.max_angle, options.max_offset) &&
         line_chi_square(with_floor(a, picture), with_floor(b, picture)) <= options.gate;
}

LineMoments moments_about(const WallLine& line, double x, double y) {
  return line.moments.seen_from(x - line.origin_x, y - line.origin_y);
}

void absorb(WallLine& a, const WallLine& b) {
  const Span other = a.span_of(b);
  a.begin = std::min(a.begin, other.begin);
  a.end = std::max(a.end, other.end);
  if (a.axis) a.width = (a.width * a.pixels + b.width * b.pixels) / std::max(1U, a.pixels + b.pixels);
  LineMoments sums = a.moments;
  sums.add(moments_about(b, a.origin_x, a.origin_y));
  a.adopt(sums, a.origin_x, a.origin_y);
  a.pixels += b.pixels;
  a.votes += b.votes;
  a.count += b.count;
  a.free_plus |= facing(a, b) > 0 ? b.free_plus : b.free_minus;
  a.free_minus |= facing(a, b) > 0 ? b.free_minus : b.free_plus;
}

/// Step 2. True when nothing of b is left.
bool trim(const WallLine& a, WallLine& b) {
  if (!near(a, b, same_direction, same_place)) return false;
  const double middle = 0.5 * (b.begin + b.end);
  const Span on_b = b.span_of(a);
  const double common = std::min(b.end, on_b.end) - std::max(b.begin, on_b.begin);
  if (common <= 0) return false;
  const double inside = std::clamp(middle, std::max(b.begin, on_b.begin), std::min(b.end, on_b.end));
  if (std::fabs(a.across(b.x_at(inside), b.y_at(inside))) > same_place) return false;
  const double before = on_b.begin - b.begin;
  const double after = b.end - on_b.end;
  if (before > after) {
    b.end = std::min(b.end, on_b.begin);
  } else {
    b.begin = std::max(b.begin, on_b.end);
  }
  return b.length() < 2;
}

/// Step 1. Lines that were absorbed get length zero.
void join_touching(std::vector<WallLine>& lines, const PictureFacts& picture, const MergeOptions& options) {
  LineGrid grid(lines, options.touching + options.max_offset);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    bool grown = lines[i].length() > 0;
    while (grown) {
      grown = false;
      for (const std::uint32_t j : grid.near(lines[i])) {
        if (j <= i || !(lines[j].length() > 0)) continue;
        const Span other = lines[i].span_of(lines[j]);
        if (other.begin > lines[i].end + options.touching || other.end < lines[i].begin - options.touching)
          continue;
        if (!same_line(lines[i], lines[j], picture, options)) continue;
        absorb(lines[i], lines[j]);
        lines[j].end = lines[j].begin;
        grown = true;
      }
    }
  }
}

void drop_empty(std::vector<WallLine>& lines) {
  std::erase_if(lines, [](const WallLine& line) { return !(line.length() > 0); });
}

}  // namespace

std::uint32_t merge_fragments(std::vector<WallLine>& lines, const PictureFacts& picture,
                              const MergeOptions& options) {
  const std::size_t before = lines.size();
  sort_longest_first(lines);
  join_touching(lines, picture, options);
  drop_empty(lines);
  sort_longest_first(lines);
  LineGrid grid(lines, same_place);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (const std::uint32_t j : grid.near(lines[i])) {
      if (j <= i || !(lines[i].length() > 0) || !(lines[j].length() > 0)) continue;
      if (trim(lines[i], lines[j])) lines[j].end = lines[j].begin;
    }
  }
  drop_empty(lines);
  return static_cast<std::uint32_t>(before - lines.size());
}

std::vector<std::vector<std::size_t>> group_collinear(std::vector<WallLine>& lines,
                                                      const PictureFacts& picture,
                                                      const MergeOptions& options) {
  sort_longest_first(lines);
  std::vector<std::vector<std::size_t>> groups;
  std::vector<WallLine> common;  // of each group: all its pixels, its whole extent
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::size_t best = groups.size();
    double best_distance = options.gate;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      if (!near(common[g], lines[i], options.max_angle, options.max_offset)) continue;
      const double distance = line_chi_square(with_floor(common[g], picture), with_floor(lines[i], picture));
      if (distance < best_distance) {
        best = g;
        best_distance = distance;
      }
    }
    if (best == groups.size()) {
      groups.push_back({i});
      common.push_back(lines[i]);
    } else {
      groups[best].push_back(i);
      absorb(common[best], lines[i]);
    }
  }
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (groups[g].size() == 1) continue;  // its fit is its own
    for (const std::size_t i : groups[g])
      lines[i].adopt(moments_about(common[g], common[g].origin_x, common[g].origin_y), common[g].origin_x,
                     common[g].origin_y);
  }
  return groups;
}

}  // namespace straightedge
