// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/plane_raster.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include "straightedge/rounding.hpp"

namespace straightedge {
namespace {

constexpr double most_cells = 1 << 24;

/// What `value` does to another cell's value where it spreads.
std::uint8_t spread(std::uint8_t value, std::uint8_t a, std::uint8_t b) {
  return value != 0 ? a | b : a & b;
}

/// to[i] = spread(a[i], b[i]); `to` may be `a`.
void spread(std::uint8_t value, const std::uint8_t* a, const std::uint8_t* b, std::uint8_t* to,
            std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) to[i] = spread(value, a[i], b[i]);
}

/// Every line gets the value where one of `window` lines from it on has it: lines of a power of two first,
/// two of which then overlap. There are `lines + window − 1` lines before, of which `lines` are left.
void spread_lines(std::vector<std::uint8_t>& cells, std::size_t lines, std::size_t length, std::size_t window,
                  std::uint8_t value) {
  std::size_t width = 1;
  for (; 2 * width <= window; width *= 2) {
    const std::size_t left = (lines + window - 2 * width) * length;
    spread(value, cells.data(), cells.data() + width * length, cells.data(), left);
  }
  spread(value, cells.data(), cells.data() + (window - width) * length, cells.data(), lines * length);
}

/// A cell is grown over when one within `reach` on its row is covered.
void grow_rows(Raster& raster, std::size_t reach, std::uint8_t value) {
  const auto width = static_cast<std::size_t>(raster.width);
  std::vector<std::uint8_t> line(width + 2 * reach);
  for (std::int32_t y = 0; y < raster.height; ++y) {
    const auto row = raster.cells.begin() + static_cast<std::ptrdiff_t>(raster.index(0, y));
    std::fill(line.begin(), line.end(), static_cast<std::uint8_t>(1 - value));
    std::copy_n(row, width, line.begin() + static_cast<std::ptrdiff_t>(reach));
    spread_lines(line, width, 1, 2 * reach + 1, value);
    std::copy_n(line.begin(), width, row);
  }
}

/// The same on columns.
void grow_columns(Raster& raster, std::size_t reach, std::uint8_t value) {
  const auto width = static_cast<std::size_t>(raster.width), height = static_cast<std::size_t>(raster.height);
  std::vector<std::uint8_t> cells((height + 2 * reach) * width, static_cast<std::uint8_t>(1 - value));
  std::copy(raster.cells.begin(), raster.cells.end(),
            cells.begin() + static_cast<std::ptrdiff_t>(reach * width));
  spread_lines(cells, height, width, 2 * reach + 1, value);
  std::copy_n(cells.begin(), raster.cells.size(), raster.cells.begin());
}

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

const std::uint8_t* find(const std::uint8_t* begin, const std::uint8_t* end, std::uint8_t value) {
  const void* const found = std::memchr(begin, value, static_cast<std::size_t>(end - begin));
  return found != nullptr ? static_cast<const std::uint8_t*>(found) : end;
}

/// Runs of that value row by row, joined into connected regions.
std::vector<CellRun> regions_of(const Raster& raster, std::uint8_t value, bool by_corners) {
  const std::int32_t reach = by_corners ? 1 : 0;
  std::vector<CellRun> runs;
  std::size_t above = 0;  // first run of the row before that may touch
  for (std::int32_t y = 0; y < raster.height; ++y) {
    const std::uint8_t* const row = raster.cells.data() + raster.index(0, y);
    const std::uint8_t* const row_end = row + raster.width;
    const std::size_t row_begin = runs.size();
    for (const std::uint8_t* at = find(row, row_end, value); at != row_end; at = find(at, row_end, value)) {
      const std::uint8_t* const begin = at;
      at = find(at, row_end, static_cast<std::uint8_t>(1 - value));
      const auto index = static_cast<std::uint32_t>(runs.size());
      const auto x0 = static_cast<std::int32_t>(begin - row), x1 = static_cast<std::int32_t>(at - row);
      runs.push_back({y, x0, x1, index, static_cast<std::uint64_t>(x1 - x0)});
      while (above < row_begin && runs[above].end + reach <= x0) ++above;
      for (std::size_t other = above; other < row_begin && runs[other].begin < x1 + reach; ++other)
        join(runs, static_cast<std::uint32_t>(other), index);
    }
    above = row_begin;
  }
  return runs;
}

void set_run(Raster& raster, const CellRun& run, std::uint8_t value) {
  std::fill_n(raster.cells.begin() + static_cast<std::ptrdiff_t>(raster.index(run.begin, run.y)),
              run.end - run.begin, value);
}

/// 1 where a cell is covered and the one below it is not.
std::vector<std::uint8_t> lower_borders(const Raster& raster) {
  const auto width = static_cast<std::size_t>(raster.width);
  std::vector<std::uint8_t> lower(raster.cells.size(), 0);
  for (std::size_t i = width; i < lower.size(); ++i)
    lower[i] = static_cast<std::uint8_t>(raster.cells[i] & (raster.cells[i - width] ^ 1U));
  return lower;
}

/// round_half_even without a branch: where pieces end within a cell is anybody's guess.
std::int64_t nearest_cell(double x) {
  const std::int64_t below = floor_to_integer(x);
  const double rest = x - static_cast<double>(below);
  return below +
         (static_cast<std::int64_t>(rest > 0.5) | (static_cast<std::int64_t>(rest == 0.5) & below & 1));
}

double cell_area(const Raster& raster, std::size_t cells) {
  return static_cast<double>(cells) * raster.cell * raster.cell;
}

}  // namespace

Raster raster_for(std::span<const ExtentPiece> pieces, double cell, double margin) {
  ExtentPiece all = pieces.front();
  for (const ExtentPiece& p : pieces) {
    all = {std::min(all.a0, p.a0), std::max(all.a1, p.a1), std::min(all.b0, p.b0), std::max(all.b1, p.b1)};
  }
  const double wide = all.a1 - all.a0 + 2 * margin, high = all.b1 - all.b0 + 2 * margin;
  while ((wide / cell + 6) * (high / cell + 6) > most_cells) cell *= 2;
  Raster raster;
  raster.cell = cell;
  // On multiples of the cell, so that lots of one plane fit together.
  const auto first = [&](double low) { return floor_to_integer((low - margin) / cell) - 2; };
  const auto count = [&](double low, double high_end) {
    return static_cast<std::int32_t>(floor_to_integer((high_end + margin) / cell) + 3 - first(low));
  };
  raster.origin = {static_cast<double>(first(all.a0)) * cell, static_cast<double>(first(all.b0)) * cell};
  raster.width = count(all.a0, all.a1);
  raster.height = count(all.b0, all.b1);
  raster.cells.assign(raster.index(0, raster.height), 0);
  return raster;
}

void paint(Raster& raster, const ExtentPiece& piece) {
  const auto cell = [&](double from_origin) {
    return static_cast<std::int32_t>(nearest_cell(from_origin / raster.cell));
  };
  const std::int32_t x0 = cell(piece.a0 - raster.origin.a), x1 = cell(piece.a1 - raster.origin.a);
  const std::int32_t y0 = cell(piece.b0 - raster.origin.b), y1 = cell(piece.b1 - raster.origin.b);
  const std::int32_t wide = std::max(x1 - x0, 1);
  for (std::int32_t y = y0; y < std::max(y1, y0 + 1); ++y) {
    std::uint8_t* const row = &raster.cells[raster.index(x0, y)];
    for (std::int32_t x = 0; x < wide; ++x) row[x] = 1;
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
      for (std::int32_t x = column(row[i]); x < column(row[i + 1]); ++x) raster.cells[raster.index(x, y)] = 1;
    }
  }
}

void close_gaps(Raster& raster, double max_gap) {
  const std::int64_t cells = round_half_even(max_gap / 2 / raster.cell);
  if (cells < 1) return;
  const auto reach =
      static_cast<std::size_t>(std::min<std::int64_t>(cells, std::max(raster.width, raster.height)));
  for (const std::uint8_t value : {std::uint8_t{1}, std::uint8_t{0}}) {
    grow_rows(raster, reach, value);
    grow_columns(raster, reach, value);
  }
}

void fill_holes(Raster& raster, double max_hole) {
  std::vector<CellRun> runs = regions_of(raster, 0, true);
  for (std::uint32_t i = 0; i < runs.size(); ++i) {
    const std::uint32_t first = first_of(runs, i);
    if (first == 0 || cell_area(raster, runs[first].cells) >= max_hole) continue;  // 0: the outside
    set_run(raster, runs[i], 1);
  }
}

void drop_islands(Raster& raster, double min_area) {
  std::vector<CellRun> runs = regions_of(raster, 1, false);
  for (std::uint32_t i = 0; i < runs.size(); ++i) {
    if (cell_area(raster, runs[first_of(runs, i)].cells) < min_area) set_run(raster, runs[i], 0);
  }
}

std::vector<CellLoop> cell_borders(const Raster& raster) {
  // Headings: 0 right, 1 up, 2 left, 3 down. Covered cells are on the left of the way.
  constexpr std::int32_t step_x[] = {1, 0, -1, 0}, step_y[] = {0, 1, 0, -1};
  constexpr std::int32_t left_x[] = {0, -1, -1, 0}, left_y[] = {0, 0, -1, -1};  // cell ahead, on the left
  // Cells whose lower side is a border that has not been walked along.
  std::vector<std::uint8_t> lower = lower_borders(raster);
  std::vector<CellLoop> loops;
  const std::uint8_t* const end = lower.data() + lower.size();
  for (const std::uint8_t* start = find(lower.data(), end, 1); start != end; start = find(start, end, 1)) {
    const auto index = static_cast<std::int32_t>(start - lower.data());
    const std::int32_t x = index % raster.width, y = index / raster.width;
    CellLoop loop;
    std::int32_t px = x, py = y, heading = 0;
    do {
      if (heading == 0) lower[raster.index(px, py)] = 0;
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
    loops.push_back(loop);
  }
  return loops;
}

}  // namespace straightedge
