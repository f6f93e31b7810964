// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/window.hpp"

#include "ransac/triple.hpp"
#include "straightedge/ransac_stop.hpp"
#include "straightedge/square_root.hpp"

namespace straightedge::ransac {
namespace {

constexpr std::uint32_t at_once = search_lanes;

// What kernels write after the last row's readings has room.
static_assert(2 * window_half * (2 * window_half + 1) + search_lanes <= Window::capacity);

void draw_triples(const Window& w, Pcg32& random, SearchTriples& triples) noexcept {
  for (std::uint32_t l = 0; l < at_once; ++l) {
    const Triple triple = draw_three(random, w.count);
    for (int i = 0; i < 3; ++i) {
      triples.u[i][l] = w.u[triple.of[i]];
      triples.v[i][l] = w.v[triple.of[i]];
      triples.q[i][l] = w.q[triple.of[i]];
    }
  }
}

/// Of the first `count`; of equals the first.
std::uint32_t cheapest(const SearchPlanes& planes, std::uint32_t count) noexcept {
  std::uint32_t best = 0;
  for (std::uint32_t l = 1; l < count; ++l)
    if (planes.cost[l] < planes.cost[best]) best = l;
  return best;
}

/// Least squares from sums of the residuals r of a plane: the plane that is to be added to it. False: the
/// readings are on a line.
bool solve(const SearchSums& s, SearchPlane& plane) noexcept {
  const double n = static_cast<double>(s.n);
  if (!(n >= 3)) return false;
  const double u = static_cast<double>(s.u) / n, v = static_cast<double>(s.v) / n,
               r = static_cast<double>(s.r) / n;
  const double uu = static_cast<double>(s.uu) - n * u * u, uv = static_cast<double>(s.uv) - n * u * v;
  const double vv = static_cast<double>(s.vv) - n * v * v;
  const double ur = static_cast<double>(s.ur) - n * u * r, vr = static_cast<double>(s.vr) - n * v * r;
  const double determinant = uu * vv - uv * uv;
  if (!(determinant > 1e-6 * uu * vv)) return false;
  const double a = (ur * vv - vr * uv) / determinant, b = (vr * uu - ur * uv) / determinant;
  plane.a += static_cast<float>(a);
  plane.b += static_cast<float>(b);
  plane.c += static_cast<float>(r - a * u - b * v);
  return true;
}

struct Scored {
  SearchPlane plane;
  SearchInliers inliers;
  float cost = 0;
};

void score(const Lattice& lattice, const Window& w, Scored& s) noexcept {
  s.inliers = lattice.kernels.find_inliers(readings_of(w), padded(w), s.plane, 1);
  s.cost = s.inliers.squares + static_cast<float>(w.count - s.inliers.count);
}

/// Local optimisation: refits with the threshold from wide to narrow, as long as they cost less.
void optimise(const Lattice& lattice, const Window& w, Scored& best) noexcept {
  score(lattice, w, best);
  for (const float gates : {1.5F, 1.0F}) {
    SearchSums sums;
    lattice.kernels.sum_inliers(readings_of(w), padded(w), best.plane, gates * gates, sums);
    Scored refitted{best.plane, {}, 0};
    if (!solve(sums, refitted.plane)) break;
    score(lattice, w, refitted);
    if (refitted.cost < best.cost) best = refitted;
  }
}

/// A window's cells, as far as they are in the picture.
struct Extent {
  std::int32_t column, row, columns, rows;

  Extent(const Lattice& l, std::int32_t middle_column, std::int32_t middle_row) noexcept
      : column(middle_column > window_half ? middle_column - window_half : 0),
        row(middle_row > window_half ? middle_row - window_half : 0),
        columns((middle_column + window_half < l.columns ? middle_column + window_half + 1 : l.columns) -
                column),
        rows((middle_row + window_half < l.rows ? middle_row + window_half + 1 : l.rows) - row) {}
};

}  // namespace

std::uint32_t count_free(const Lattice& lattice, std::int32_t column, std::int32_t row) noexcept {
  const Extent e(lattice, column, row);
  return lattice.kernels.count_readings(&lattice.cells.q[lattice.at(e.column, e.row)],
                                        {e.columns, e.rows, lattice.stride});
}

void gather(const Lattice& lattice, std::int32_t column, std::int32_t row, Window& window) noexcept {
  window.count = 0;
  window.u0 = column * lattice.cell;
  window.v0 = row * lattice.cell;
  const Extent e(lattice, column, row);
  const auto u0 = static_cast<float>(window.u0), v0 = static_cast<float>(window.v0);
  for (std::int32_t r = e.row; r < e.row + e.rows; ++r) {
    const std::uint32_t k = window.count;
    window.count += lattice.kernels.gather_row(lattice.readings(lattice.at(e.column, r)), e.columns, u0, v0,
                                               {window.u + k, window.v + k, window.q + k, window.w + k});
  }
  for (std::uint32_t k = window.count; k < padded(window); ++k) {
    window.u[k] = window.v[k] = 0;
    window.q[k] = no_reading;
    window.w[k] = 1;
  }
}

WindowPlane best_of_window(const Lattice& lattice, const Window& window, const RansacSearchOptions& options,
                           std::uint64_t stream) noexcept {
  WindowPlane found;
  const std::uint32_t n = window.count;
  if (n < 3) return found;
  const auto most = static_cast<std::uint32_t>(options.max_draws);
  Pcg32 random(options.seed, stream);
  Scored best;
  best.cost = static_cast<float>(n);
  do {
    SearchTriples triples;
    SearchPlanes planes;
    draw_triples(window, random, triples);
    lattice.kernels.try_triples(readings_of(window), n, triples, planes);
    const std::uint32_t tried = most - found.draws < at_once ? most - found.draws : at_once;
    found.draws += tried;
    const std::uint32_t l = cheapest(planes, tried);
    if (!(planes.cost[l] < best.cost)) continue;
    Scored scored{{planes.a[l], planes.b[l], planes.c[l]}, {}, 0};
    optimise(lattice, window, scored);
    if (scored.cost < best.cost) best = scored;
  } while (found.draws < most &&
           miss_probability(triple_probability(best.inliers.count, n), found.draws) > 1 - options.confidence);
  found.inliers = best.inliers.count;
  if (found.inliers == 0) return found;
  found.rms = square_root(static_cast<double>(best.inliers.squares) / found.inliers);
  found.local = best.plane;
  const auto a = static_cast<double>(best.plane.a), b = static_cast<double>(best.plane.b);
  found.plane = {a, b, static_cast<double>(best.plane.c) - a * window.u0 - b * window.v0};
  return found;
}

}  // namespace straightedge::ransac
