// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hough/corridor.hpp"
#include "straightedge/segment_refit.hpp"
#include "straightedge/square_root.hpp"
#include "straightedge/trigonometry.hpp"

/// The steps of segment_refit.hpp for any `Edges`, which has the edge pixels that may be used:
///   size()                                   of the picture
///   for_each(steep, k, from, to, visit)      calls visit(x, y) for those of them in row k (not steep: column
///                                            k) from column (row) `from` to `to`
///   gradient(x, y), point(x, y)              of such a pixel
///   collect(strip, options, start, direction, found)
///                                            step 2, in one direction: collect_each or what gives the same
///   clear(x, y)                              it may be used no more
namespace straightedge::refitting {

// Pixels are looked for a little outside the corridor: their sub-pixel position may lie inside.
inline constexpr double position_reach = 0.75;
// A line that moves by less than this many pixels, at its ends, has the same pixels nearly always.
inline constexpr double settled_within = 0.03;
// Places that tell which side is light.
inline constexpr std::int32_t most_places = 48;
// Two walls that nearly continue one another: halves of this many pixels, a step of this many between them.
inline constexpr double min_half = 12;
inline constexpr double min_step = 0.7;

struct Extent {
  std::int32_t first;
  std::int32_t last;
};

/// Steps of the corridor's major axis from one end of the rough segment to the other.
inline Extent steps_of(const Corridor& strip, const HoughSegment& rough) noexcept {
  const std::int32_t a = strip.steep() ? rough.y0 : rough.x0;
  const std::int32_t b = strip.steep() ? rough.y1 : rough.x1;
  return a < b ? Extent{a, b} : Extent{b, a};
}

/// Step 1.
template <class Edges>
bool find_light_side(const Edges& edges, Extent steps, Corridor& strip) noexcept {
  double sum = 0;
  const CorridorSteps corridor(edges, strip);
  const std::int32_t stride = (steps.last - steps.first) / most_places + 1;
  for (std::int32_t k = steps.first; k <= steps.last; k += stride) {
    corridor.visit(k, [&](std::int32_t x, std::int32_t y) noexcept {
      const EdgeGradient gradient = edges.gradient(x, y);
      const double toward = gradient.dx * strip.nx + gradient.dy * strip.ny;
      sum += toward > 0 ? 1 : toward < 0 ? -1 : 0;
    });
  }
  if (sum < 0) {
    strip.nx = -strip.nx;
    strip.ny = -strip.ny;
  }
  return sum != 0;
}

struct Collected {
  LineMoments moments;
  LineMoments halves[2];  // before and behind the middle
  double begin = 0, end = 0;
  std::uint32_t pixels = 0;
  std::uint64_t places = 0;  // sum over the pixels of a number that stands for their place

  bool same_pixels(const Collected& other) const noexcept {
    return pixels == other.pixels && places == other.places;
  }
};

/// Scrambled, so that sums over different sets of pixels differ.
inline std::uint64_t number_of(std::int32_t x, std::int32_t y) noexcept {
  const std::uint64_t place = static_cast<std::uint64_t>(x) << 32U | static_cast<std::uint32_t>(y);
  const std::uint64_t product = place * 0x9E3779B97F4A7C15U;
  return product ^ product >> 29U;
}

/// The corridor in which pixels are looked for.
inline Corridor widened(Corridor strip) noexcept {
  strip.half_width += position_reach;
  return strip;
}

/// Step 2, in one direction of the major axis.
template <class Edges>
void collect_each(const Edges& edges, const Corridor& strip, const RefitOptions& options, std::int32_t start,
                  std::int32_t direction, Collected& result) noexcept {
  const double step_length = strip.step_length();
  const Corridor wide = widened(strip);
  const CorridorSteps corridor(edges, wide);
  Collected found = result;
  // Pixels behind one another lie in one half nearly always: its sums stay at hand.
  int half = 0;
  LineMoments sums = found.halves[half];
  double hole = 0;
  for (std::int32_t k = start; hole <= options.max_gap; k += direction) {
    hole += step_length;
    const bool inside = corridor.visit(k, [&](std::int32_t x, std::int32_t y) noexcept {
      if (!strip.faces_light(edges.gradient(x, y))) return;
      const EdgePoint edge = edges.point(x, y);
      const double off = strip.across(edge.x, edge.y);
      if (off > strip.half_width || off < -strip.half_width) return;
      const double s = strip.along(edge.x, edge.y);
      if (found.pixels == 0) found.begin = found.end = s;
      found.begin = s < found.begin ? s : found.begin;
      found.end = s > found.end ? s : found.end;
      ++found.pixels;
      found.places += number_of(x, y);
      const int other = s < 0 ? 0 : 1;
      if (other != half) {
        found.halves[half] = sums;
        sums = found.halves[other];
        half = other;
      }
      sums.add(edge.x - strip.px, edge.y - strip.py, edge.weight);
      hole = 0;
    });
    if (!inside) break;
  }
  found.halves[half] = sums;
  result = found;
}

/// Step 3: the corridor laid along the new fit, its light side kept.
inline bool follow(const Collected& found, Corridor& strip, LineFit& fit) noexcept {
  if (fit_line(found.moments, fit) != Status::ok) return false;
  const double side = fit.normal_x * strip.nx + fit.normal_y * strip.ny < 0 ? -1 : 1;
  strip.nx = side * fit.normal_x;
  strip.ny = side * fit.normal_y;
  strip.px += fit.centroid_x;
  strip.py += fit.centroid_y;
  return true;
}

/// Whether the line stayed where it was, at both ends of what was collected along it before.
inline bool hardly_moved(const Corridor& before, const Corridor& now, const Collected& found) noexcept {
  const double begin =
      now.across(before.px + found.begin * before.tx(), before.py + found.begin * before.ty());
  const double end = now.across(before.px + found.end * before.tx(), before.py + found.end * before.ty());
  return begin < settled_within && begin > -settled_within && end < settled_within && end > -settled_within;
}

/// Step 4. True when the two halves lie on parallel lines a step apart; the corridor is then laid along the
/// half with more pixels.
inline bool is_stepped(const Collected& found, Corridor& strip) noexcept {
  LineFit half[2];
  for (int h = 0; h < 2; ++h) {
    if (found.halves[h].count < min_half || fit_line(found.halves[h], half[h]) != Status::ok) return false;
  }
  const double x = 0.5 * (half[0].centroid_x + half[1].centroid_x);
  const double y = 0.5 * (half[0].centroid_y + half[1].centroid_y);
  const double side = half[0].normal_x * half[1].normal_x + half[0].normal_y * half[1].normal_y < 0 ? -1 : 1;
  const double step = side * half[1].distance(x, y) - half[0].distance(x, y);
  if (step * step < min_step * min_step) return false;
  const int larger = found.halves[0].count >= found.halves[1].count ? 0 : 1;
  Collected chosen;
  chosen.moments = found.halves[larger];
  LineFit fit;
  return follow(chosen, strip, fit);
}

/// Step 2, both ways from the corridor's middle.
template <class Edges>
Collected collect_both_ways(const Edges& edges, const Corridor& strip, const RefitOptions& options) noexcept {
  const auto middle = static_cast<std::int32_t>((strip.steep() ? strip.py : strip.px) + 0.5);
  Collected found;
  edges.collect(strip, options, middle, 1, found);
  edges.collect(strip, options, middle - 1, -1, found);
  found.moments = found.halves[0];
  found.moments.add(found.halves[1]);
  return found;
}

inline RefinedSegment refined_from(const Collected& found, const Corridor& before, const Corridor& strip,
                                   const LineFit& fit) noexcept {
  RefinedSegment refined{found.moments, before.px,   before.py, fit,         strip.nx,
                         strip.ny,      found.begin, found.end, found.pixels};
  const double moved = fit.centroid_x * strip.tx() + fit.centroid_y * strip.ty();
  refined.begin -= moved;
  refined.end -= moved;
  refined.fit.centroid_x += before.px;
  refined.fit.centroid_y += before.py;
  return refined;
}

inline bool valid(const RefitOptions& o) noexcept {
  return o.corridor >= 0.5 && o.corridor <= 8 && o.max_angle >= 0 && o.max_angle <= pi / 2 &&
         o.max_gap >= 0 && o.max_gap < 1e6 && o.rounds >= 1 && o.rounds <= 20;
}

inline Corridor corridor_of(const HoughSegment& rough, const RefitOptions& options) noexcept {
  const double dx = rough.x1 - rough.x0;
  const double dy = rough.y1 - rough.y0;
  const double length = square_root(dx * dx + dy * dy);
  Corridor strip;
  strip.px = 0.5 * (rough.x0 + rough.x1);
  strip.py = 0.5 * (rough.y0 + rough.y1);
  strip.nx = length > 0 ? dy / length : 1;
  strip.ny = length > 0 ? -dx / length : 0;
  strip.half_width = options.corridor + 0.5;  // the rough line is a pixel off at times
  strip.cos_max_angle = cosine(options.max_angle);
  return strip;
}

/// The manual is in segment_refit.hpp.
template <class Edges>
Status refit(const Edges& edges, const HoughSegment& rough, const RefitOptions& options,
             RefinedSegment& refined) noexcept {
  refined = {};
  if (!valid(options)) return Status::invalid_option;
  Corridor strip = corridor_of(rough, options);
  if (!find_light_side(edges, steps_of(strip, rough), strip)) return Status::ok;  // Step 1
  Collected last;
  double corridor = options.corridor;
  bool may_step = true;
  for (int left = options.rounds; left > 0; --left) {
    const Collected found = collect_both_ways(edges, strip, options);  // Step 2
    const Corridor before = strip;
    LineFit fit;
    const bool known = found.same_pixels(last);
    last = found;
    if (!follow(found, strip, fit)) {  // Step 3
      refined = {};
      return Status::ok;
    }
    const bool settled = known || (left < options.rounds && hardly_moved(before, strip, found));
    Corridor larger = before;
    const bool stepped = may_step && (left == 2 || (settled && left > 2)) && is_stepped(found, larger);
    if (stepped) {  // Step 4
      may_step = false;
      strip = larger;
      corridor *= 0.5;
      left = 4;
    } else {
      refined = refined_from(found, before, strip, fit);
      if (settled) break;
    }
    strip.half_width = corridor;
  }
  return Status::ok;
}

template <class Edges>
std::uint32_t claim(Edges& edges, const RefinedSegment& segment, double corridor, double max_angle,
                    double margin) noexcept {
  Corridor strip;
  strip.px = segment.fit.centroid_x;
  strip.py = segment.fit.centroid_y;
  strip.nx = segment.light_x;
  strip.ny = segment.light_y;
  strip.half_width = corridor;
  strip.cos_max_angle = cosine(max_angle);
  const double from = segment.begin - margin;
  const double to = segment.end + margin;
  const double direction = strip.steep() ? strip.ty() : strip.tx();
  const double at = strip.steep() ? strip.py : strip.px;
  const double a = at + from * direction;
  const double b = at + to * direction;
  // The corners of the rectangle reach beyond its axis.
  const auto first = static_cast<std::int32_t>((a < b ? a : b) - corridor) - 1;
  const auto last = static_cast<std::int32_t>((a < b ? b : a) + corridor) + 1;
  std::uint32_t claimed = 0;
  const CorridorSteps steps(edges, strip);
  for (std::int32_t k = first; k <= last; ++k) {
    steps.visit(k, [&](std::int32_t x, std::int32_t y) noexcept {
      const double s = strip.along(x, y);
      const double off = strip.across(x, y);
      if (s < from || s > to || off > corridor || off < -corridor) return;
      if (!strip.faces_light(edges.gradient(x, y))) return;
      edges.clear(x, y);
      ++claimed;
    });
  }
  return claimed;
}

}  // namespace straightedge::refitting
