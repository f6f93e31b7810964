// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/straight_part.hpp"

#include "map/strip_moments.hpp"

namespace straightedge {
namespace {

constexpr double straight = 0.25;          // pixels of residual
constexpr double bend_share = 0.6;         // of the sum of squares that a bend must take off
constexpr std::int32_t fewest_places = 5;  // on each side of it

/// A place as the line sees it; without weight where it does not count.
struct Seen {
  double weight = 0, along = 0, across = 0;
};

Seen see(const StripBatch& places, std::int32_t i, const StripRule& strip, const LineFit& fit) noexcept {
  if (places.inside[i] == 0) return {};
  const double x = places.x[i] - strip.px - fit.centroid_x, y = places.y[i] - strip.py - fit.centroid_y;
  return {places.weight[i], y * fit.normal_x - x * fit.normal_y, x * fit.normal_x + y * fit.normal_y};
}

/// Steps 2 and 3.
std::optional<std::int32_t> find_bend(const StripBatch& places, const StripRule& strip,
                                      const StraightPart& part) noexcept {
  double weight = 0, spread = 0, left_over = 0;
  for (std::int32_t i = part.first; i < part.end; ++i) {
    const Seen p = see(places, i, strip, part.fit);
    weight += p.weight;
    spread += p.weight * p.along * p.along;
    left_over += p.weight * p.across * p.across;
  }
  double w = 0, wt = 0, wtt = 0, wr = 0, wrt = 0;  // over the places beyond k
  double most = bend_share * left_over;
  std::optional<std::int32_t> bend;
  for (std::int32_t k = part.end - 1; k >= part.first + fewest_places; --k) {
    const Seen p = see(places, k, strip, part.fit);
    const double t = p.along;
    if (k < part.end - fewest_places && p.weight > 0) {
      const double h = wt - t * w, ht = wtt - t * wt, hh = wtt - 2 * t * wt + t * t * w, rh = wrt - t * wr;
      const double own = hh - h * h / weight - ht * ht / spread;
      if (own > 0 && rh * rh > most * own) {
        most = rh * rh / own;
        bend = k;
      }
    }
    w += p.weight;
    wt += p.weight * t;
    wtt += p.weight * t * t;
    wr += p.weight * p.across;
    wrt += p.weight * p.across * t;
  }
  return bend;
}

}  // namespace

std::optional<StraightPart> find_straight_part(const StripBatch& places, const StripRule& strip) noexcept {
  StraightPart part{.first = 0, .end = places.count, .moments = {}, .fit = {}};
  for (;;) {
    part.moments = {};
    for (std::int32_t i = part.first; i < part.end; ++i)
      if (places.inside[i] != 0) add(places, i, part.moments);
    if (fit_line(part.moments, part.fit) != Status::ok) return std::nullopt;
    if (part.fit.residual <= straight) return part;
    const std::optional<std::int32_t> bend = find_bend(places, strip, part);
    if (!bend) return part;
    (*bend - part.first > part.end - *bend ? part.end : part.first) = *bend;
  }
}

}  // namespace straightedge
