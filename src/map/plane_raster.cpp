// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/plane_raster.hpp"

#include <algorithm>
#include <utility>

#include "straightedge/rounding.hpp"

namespace straightedge {
namespace {

constexpr double most_cells = 1 << 24;

/// A cell is grown over when one within `reach` on its row (or column) is covered.
void grow_lines(const Raster& raster, std::int32_t reach, bool rows, std::uint8_t value,
                std::vector<std::uint8_t>& cells) {
  const std::int32_t lines = rows ? raster.height : raster.width;
  const std::int32_t length = rows ? raster.width : raster.height;
  std::vector<std::uint8_t> grown(static_cast<std::size_t>(length));
  const auto at = [&](std::int32_t line, std::int32_t i) -> std::uint8_t& {
    return cells[rows ? raster.index(i, line) : raster.index(line, i)];
  };
  for (std::int32_t line = 0; line < lines; ++line) {
    std::int32_t count = 0;
    for (std::int32_t i = 0; i < std::min(reach, length); ++i) count += at(line, i) == value ? 1 : 0;
    for (std::int32_t i = 0; i < length; ++i) {
      if (i + reach < length) count += at(line, i + reach) == value ? 1 : 0;
      if (i - reach - 1 >= 0) count -= at(line, i - reach - 1) == value ? 1 : 0;
      grown[static_cast<std::size_t>(i)] = count > 0 ? value : static_cast<std::uint8_t>(1 - value);
    }
    for (std::int32_t i = 0; i < length; ++i) at(line, i) = grown[static_cast<std::size_t>(i)];
  }
}

/// Calls `visit` with the cells of each connected region of that value, in the order of their first cells.
template <class Visit>
void for_each_region(const Raster& raster, std::uint8_t value, bool by_corners, Visit visit) {
  std::vector<std::uint8_t> seen(raster.cells.size(), 0);
  std::vector<std::uint32_t> region;
  const auto width = static_cast<std::uint32_t>(raster.width);
  for (std::size_t start = 0; start < raster.cells.size(); ++start) {
    if (seen[start] != 0 || raster.cells[start] != value) continue;
    region.assign(1, static_cast<std::uint32_t>(start));
    seen[start] = 1;
    for (std::size_t i = 0; i < region.size(); ++i) {
      const auto x = static_cast<std::int32_t>(region[i] % width);
      const auto y = static_cast<std::int32_t>(region[i] / width);
      for (std::int32_t dy = -1; dy <= 1; ++dy) {
        for (std::int32_t dx = -1; dx <= 1; ++dx) {
          if (!by_corners && dx != 0 && dy != 0) continue;
          const std::int32_t nx = x + dx, ny = y + dy;
          if (nx < 0 || ny < 0 || nx >= raster.width || ny >= raster.height) continue;
          const std::size_t next = raster.index(nx, ny);
          if (seen[next] != 0 || raster.cells[next] != value) continue;
          seen[next] = 1;
          region.push_back(static_cast<std::uint32_t>(next));
        }
      }
    }
    visit(region);
  }
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
    return static_cast<std::int32_t>(round_half_even(from_origin / raster.cell));
  };
  const std::int32_t x0 = cell(piece.a0 - raster.origin.a), x1 = cell(piece.a1 - raster.origin.a);
  const std::int32_t y0 = cell(piece.b0 - raster.origin.b), y1 = cell(piece.b1 - raster.origin.b);
  for (std::int32_t y = y0; y < std::max(y1, y0 + 1); ++y) {
    for (std::int32_t x = x0; x < std::max(x1, x0 + 1); ++x) raster.cells[raster.index(x, y)] = 1;
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
  const auto reach = static_cast<std::int32_t>(round_half_even(max_gap / 2 / raster.cell));
  if (reach < 1) return;
  for (const std::uint8_t value : {std::uint8_t{1}, std::uint8_t{0}}) {
    grow_lines(raster, reach, true, value, raster.cells);
    grow_lines(raster, reach, false, value, raster.cells);
  }
}

void fill_holes(Raster& raster, double max_hole) {
  std::vector<std::uint8_t> filled = raster.cells;
  for_each_region(raster, 0, true, [&](const std::vector<std::uint32_t>& region) {
    if (region.front() == 0 || cell_area(raster, region.size()) >= max_hole) return;  // 0: the outside
    for (const std::uint32_t i : region) filled[i] = 1;
  });
  raster.cells = filled;
}

void drop_islands(Raster& raster, double min_area) {
  std::vector<std::uint8_t> left = raster.cells;
  for_each_region(raster, 1, false, [&](const std::vector<std::uint32_t>& region) {
    if (cell_area(raster, region.size()) >= min_area) return;
    for (const std::uint32_t i : region) left[i] = 0;
  });
  raster.cells = left;
}

std::vector<CellLoop> cell_borders(const Raster& raster) {
  // Headings: 0 right, 1 up, 2 left, 3 down. Covered cells are on the left of the way.
  constexpr std::int32_t step_x[] = {1, 0, -1, 0}, step_y[] = {0, 1, 0, -1};
  constexpr std::int32_t left_x[] = {0, -1, -1, 0}, left_y[] = {0, 0, -1, -1};  // cell ahead, on the left
  std::vector<std::uint8_t> walked(raster.cells.size(), 0);                     // along a cell's lower side
  std::vector<CellLoop> loops;
  for (std::int32_t y = 1; y < raster.height; ++y) {
    for (std::int32_t x = 0; x < raster.width; ++x) {
      if (!raster.covered(x, y) || raster.covered(x, y - 1) || walked[raster.index(x, y)] != 0) continue;
      CellLoop loop;
      std::int32_t px = x, py = y, heading = 0;
      do {
        if (heading == 0) walked[raster.index(px, py)] = 1;
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
  }
  return loops;
}

}  // namespace straightedge
