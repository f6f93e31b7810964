// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/plane_raster.hpp"

#include <algorithm>
#include <utility>

#include "straightedge/rounding.hpp"

namespace straightedge {
namespace {

constexpr double most_cells = 1 << 24;

/// Cells of one value without a gap, and the region that they belong to.
struct CellRun {
  std::int32_t y, begin, end;
  std::uint32_t parent;  ///< a run of the same region that comes no later; the first one is its own
  std::uint64_t cells;   ///< of a first run: of the whole region
};

std::uint32_t first_of(std::vector<CellRun>& runs, std::uint32_t run) {
  while (runs[run].parent != run) run = runs[run].parent = runs[runs[run].parent].parent;
  return run;
}

void join(std::vector<CellRun>& runs, std::uint32_t a, std::uint32_t b) {
  a = first_of(runs, a);
  b = first_of(runs, b);
  if (a == b) return;
  if (b < a) std::swap(a, b);
  runs[b].parent = a;
  runs[a].cells += runs[b].cells;
}

/// The first cell from x on, before the end, that has the value; else the end.
std::int32_t find(const std::uint64_t* row, std::int32_t x, std::int32_t end, bool value) {
  while (x < end) {
    const std::uint64_t word = value ? row[x / 64] : ~row[x / 64];
    const std::uint64_t rest = word >> (static_cast<unsigned>(x) % 64);
    if (rest != 0) return std::min<std::int32_t>(x + __builtin_ctzll(rest), end);
    x = (x / 64 + 1) * 64;
  }
  return end;
}

/// Runs of that value row by row, joined into connected regions.
std::vector<CellRun> regions_of(const Raster& raster, bool value, bool by_corners) {
  const std::int32_t reach = by_corners ? 1 : 0;
  std::vector<CellRun> runs;
  std::size_t above = 0;  // first run of the row before that may touch
  for (std::int32_t y = 0; y < raster.height; ++y) {
    const std::uint64_t* const row = raster.row(y);
    const std::size_t row_begin = runs.size();
    for (std::int32_t x0 = find(row, 0, raster.width, value); x0 < raster.width;) {
      const std::int32_t x1 = find(row, x0, raster.width, !value);
      const auto index = static_cast<std::uint32_t>(runs.size());
      runs.push_back({y, x0, x1, index, static_cast<std::uint64_t>(x1 - x0)});
      while (above < row_begin && runs[above].end + reach <= x0) ++above;
      for (std::size_t other = above; other < row_begin && runs[other].begin < x1 + reach; ++other)
        join(runs, static_cast<std::uint32_t>(other), index);
      x0 = find(row, x1, raster.width, value);
    }
    above = row_begin;
  }
  return runs;
}

/// Cells that are covered while the ones below them are not.
Raster lower_borders(const Raster& raster) {
  Raster lower = raster;
  for (std::size_t i = raster.pitch; i < lower.words.size(); ++i)
    lower.words[i] &= ~raster.words[i - raster.pitch];
  return lower;
}

/// The border between cells that is nearest to a place at or above 0.
std::int32_t nearest_border(double cells) {
  return static_cast<std::int32_t>(cells + 0.5);
}

double cell_area(const Raster& raster, std::size_t cells) {
  return static_cast<double>(cells) * raster.cell * raster.cell;
}

}  // namespace

Raster::Raster(std::int32_t columns, std::int32_t rows)
    : width(columns),
      height(rows),
      pitch(static_cast<std::size_t>(columns) / 64 + 1),
      words(static_cast<std::size_t>(rows) * pitch) {}

Raster raster_for(std::span<const ExtentPiece> pieces, double cell, double margin) {
  ExtentPiece all = pieces.front();
  for (const ExtentPiece& p : pieces) {
    all = {std::min(all.a0, p.a0), std::max(all.a1, p.a1), std::min(all.b0, p.b0), std::max(all.b1, p.b1)};
  }
  const double wide = all.a1 - all.a0 + 2 * margin, high = all.b1 - all.b0 + 2 * margin;
  while ((wide / cell + 6) * (high / cell + 6) > most_cells) cell *= 2;
  // On multiples of the cell, so that lots of one plane fit together.
  const auto first = [&](double low) { return floor_to_integer((low - margin) / cell) - 2; };
  const auto count = [&](double low, double high_end) {
    return static_cast<std::int32_t>(floor_to_integer((high_end + margin) / cell) + 3 - first(low));
  };
  Raster raster(count(all.a0, all.a1), count(all.b0, all.b1));
  raster.cell = cell;
  raster.origin = {static_cast<double>(first(all.a0)) * cell, static_cast<double>(first(all.b0)) * cell};
  return raster;
}

void paint(Raster& raster, const ExtentPiece& piece) {
  const double cells = 1 / raster.cell;
  const double a0 = (piece.a0 - raster.origin.a) * cells, a1 = (piece.a1 - raster.origin.a) * cells;
  const double b0 = (piece.b0 - raster.origin.b) * cells, b1 = (piece.b1 - raster.origin.b) * cells;
  const double a = (a0 + a1) / 2, b = (b0 + b1) / 2;
  const std::int32_t first = nearest_border(b0), last = std::max(nearest_border(b1), first + 1);
  for (std::int32_t y = first; y < last; ++y) {
    double left = a0, right = a1;
    if (piece.oblique) {
      for (const ExtentStrip& strip : piece.strips) {
        const double middle = a + strip.lean * (y + 0.5 - b), half = strip.half * cells;
        left = std::clamp(middle - half, left, a1);
        right = std::clamp(middle + half, a0, right);
      }
    }
    const std::int32_t x0 = nearest_border(left);
    raster.set(y, x0, std::max(nearest_border(right), x0 + 1), true);
  }
}

void paint(Raster& raster, std::span<const ExtentLoop> loops) {
  std::vector<std::vector<double>> crossings(static_cast<std::size_t>(raster.height));
  for (const ExtentLoop& loop : loops) {
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
      PlanePoint p = loop.points[i], q = loop.points[(i + 1) % loop.points.size()];
      if (p.b > q.b) std::swap(p, q);
      // Rows whose middle lies in [p.b, q.b).
      const auto row = [&](double b) { return -floor_to_integer(0.5 - (b - raster.origin.b) / raster.cell); };
      const std::int64_t last = std::min<std::int64_t>(row(q.b), raster.height);
      for (std::int64_t y = std::max<std::int64_t>(row(p.b), 0); y < last; ++y) {
        const double middle = raster.origin.b + (static_cast<double>(y) + 0.5) * raster.cell;
        crossings[static_cast<std::size_t>(y)].push_back(p.a + (middle - p.b) / (q.b - p.b) * (q.a - p.a));
      }
    }
  }
  for (std::int32_t y = 0; y < raster.height; ++y) {
    std::vector<double>& row = crossings[static_cast<std::size_t>(y)];
    std::sort(row.begin(), row.end());
    for (std::size_t i = 0; i + 1 < row.size(); i += 2) {
      const auto column = [&](double a) {
        return static_cast<std::int32_t>(-floor_to_integer(0.5 - (a - raster.origin.a) / raster.cell));
      };
      raster.set(y, column(row[i]), column(row[i + 1]), true);
    }
  }
}

void fill_holes(Raster& raster, double max_hole) {
  std::vector<CellRun> runs = regions_of(raster, false, true);
  for (std::uint32_t i = 0; i < runs.size(); ++i) {
    const std::uint32_t first = first_of(runs, i);
    if (first == 0 || cell_area(raster, runs[first].cells) >= max_hole) continue;  // 0: the outside
    raster.set(runs[i].y, runs[i].begin, runs[i].end, true);
  }
}

void drop_islands(Raster& raster, double min_area) {
  std::vector<CellRun> runs = regions_of(raster, true, false);
  for (std::uint32_t i = 0; i < runs.size(); ++i) {
    if (cell_area(raster, runs[first_of(runs, i)].cells) < min_area)
      raster.set(runs[i].y, runs[i].begin, runs[i].end, false);
  }
}

std::vector<CellLoop> cell_borders(const Raster& raster) {
  // Headings: 0 right, 1 up, 2 left, 3 down. Covered cells are on the left of the way.
  constexpr std::int32_t step_x[] = {1, 0, -1, 0}, step_y[] = {0, 1, 0, -1};
  constexpr std::int32_t left_x[] = {0, -1, -1, 0}, left_y[] = {0, 0, -1, -1};  // cell ahead, on the left
  // Cells whose lower side is a border that has not been walked along.
  Raster lower = lower_borders(raster);
  std::vector<CellLoop> loops;
  for (std::int32_t y = 0, x = 0; y < raster.height;) {
    x = find(lower.row(y), x, raster.width, true);
    if (x == raster.width) {
      ++y;
      x = 0;
      continue;
    }
    CellLoop loop;
    std::int32_t px = x, py = y, heading = 0;
    do {
      if (heading == 0) lower.set(py, px, px + 1, false);
      px += step_x[heading];
      py += step_y[heading];
      const std::int32_t right = (heading + 3) % 4;
      std::int32_t turned = heading;
      if (!raster.covered(px + left_x[heading], py + left_y[heading])) {
        turned = (heading + 1) % 4;
      } else if (raster.covered(px + left_x[right], py + left_y[right])) {
        turned = right;
      }
      if (turned == heading) continue;
      heading = turned;
      loop.x.push_back(px);
      loop.y.push_back(py);
    } while (px != x || py != y || heading != 0);
    loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace straightedge
