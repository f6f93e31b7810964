// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/plane_extent.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <utility>

#include "map/plane_raster.hpp"
#include "straightedge/rounding.hpp"

namespace straightedge {
namespace {

constexpr double smallest_lot_cell = 0.25;  // metres
constexpr double straight_cells = 2.5;

using Cell = std::pair<std::int64_t, std::int64_t>;  // row first

template <class Visit>
void for_each_cell(const ExtentPiece& p, double size, Visit visit) {
  const double cells = 1 / size;
  const std::int64_t x0 = floor_to_integer(p.a0 * cells), x1 = floor_to_integer(p.a1 * cells);
  const std::int64_t y0 = floor_to_integer(p.b0 * cells), y1 = floor_to_integer(p.b1 * cells);
  for (std::int64_t y = y0; y <= y1; ++y) {
    for (std::int64_t x = x0; x <= x1; ++x) visit(Cell{y, x});
  }
}

/// Numbers the cells' connected regions, in the order of their first cells; neighbours by sides and corners.
/// Cells come sorted, each once.
std::vector<std::uint32_t> number_lots(std::span<const Cell> cells) {
  // For each cell one of its region that comes no later; the region's first one stands for itself.
  std::vector<std::uint32_t> earlier(cells.size());
  const auto first_of = [&](std::uint32_t i) {
    while (earlier[i] != i) i = earlier[i] = earlier[earlier[i]];
    return i;
  };
  std::uint32_t above = 0;  // the row before: cells from the left neighbour's column on
  for (std::uint32_t i = 0; i < cells.size(); ++i) {
    const auto [row, column] = cells[i];
    std::uint32_t first = i > 0 && cells[i - 1] == Cell{row, column - 1} ? first_of(i - 1) : i;
    earlier[i] = first;
    while (cells[above] < Cell{row - 1, column - 1}) ++above;
    for (std::uint32_t n = above; cells[n] <= Cell{row - 1, column + 1}; ++n) {
      const std::uint32_t other = first_of(n);
      earlier[std::max(first, other)] = std::min(first, other);
      first = std::min(first, other);
    }
  }
  std::uint32_t count = 0;
  std::vector<std::uint32_t> lots(cells.size());
  for (std::uint32_t i = 0; i < cells.size(); ++i) lots[i] = earlier[i] == i ? count++ : lots[first_of(i)];
  return lots;
}

/// The lot of each cell that was met.
std::vector<std::uint32_t> lots_of_cells(std::span<const Cell> met) {
  struct Met {
    Cell cell;
    std::uint32_t place;
  };
  std::vector<Met> sorted;
  sorted.reserve(met.size());
  for (const Cell& cell : met) sorted.push_back({cell, static_cast<std::uint32_t>(sorted.size())});
  std::sort(sorted.begin(), sorted.end(), [](const Met& a, const Met& b) { return a.cell < b.cell; });
  std::vector<Cell> cells;
  for (const Met& m : sorted) {
    if (cells.empty() || cells.back() != m.cell) cells.push_back(m.cell);
  }
  const std::vector<std::uint32_t> lots = number_lots(cells);
  std::vector<std::uint32_t> of_met(met.size());
  std::size_t at = 0;
  for (const Met& m : sorted) {
    if (cells[at] != m.cell) ++at;
    of_met[m.place] = lots[at];
  }
  return of_met;
}

/// Cells in the order in which they are met. Most have been met shortly before: those are not listed again.
class MetCells {
 public:
  /// Its place in the list.
  std::uint32_t meet(const Cell& cell) {
    std::uint32_t& lately = lately_[static_cast<std::size_t>((cell.first & 7) * 8 + (cell.second & 7))];
    if (lately < cells_.size() && cells_[lately] == cell) return lately;
    lately = static_cast<std::uint32_t>(cells_.size());
    cells_.push_back(cell);
    return lately;
  }
  const std::vector<Cell>& cells() const { return cells_; }

 private:
  std::vector<Cell> cells_;
  std::array<std::uint32_t, 64> lately_{};
};

/// Step 1. The pieces of each lot.
std::vector<std::vector<ExtentPiece>> lots_of(std::span<const ExtentPiece> pieces, double size) {
  MetCells met;
  std::vector<std::uint32_t> first_cells;  // of pieces
  first_cells.reserve(pieces.size());
  for (const ExtentPiece& p : pieces) {
    bool first = true;
    for_each_cell(p, size, [&](const Cell& cell) {
      const std::uint32_t place = met.meet(cell);
      if (first) first_cells.push_back(place);
      first = false;
    });
  }
  const std::vector<std::uint32_t> lot_of_met = lots_of_cells(met.cells());
  std::vector<std::size_t> sizes;
  for (const std::uint32_t place : first_cells) {
    const std::uint32_t lot = lot_of_met[place];
    if (sizes.size() <= lot) sizes.resize(lot + 1);
    ++sizes[lot];
  }
  std::vector<std::vector<ExtentPiece>> lots(sizes.size());
  for (std::size_t lot = 0; lot < lots.size(); ++lot) lots[lot].reserve(sizes[lot]);
  for (std::size_t i = 0; i < pieces.size(); ++i) lots[lot_of_met[first_cells[i]]].push_back(pieces[i]);
  return lots;
}

/// Squared distance of p from the segment a b.
double squared_distance(const PlanePoint& p, const PlanePoint& a, const PlanePoint& b) {
  const double da = b.a - a.a, db = b.b - a.b;
  const double pa = p.a - a.a, pb = p.b - a.b;
  const double size = da * da + db * db;
  double t = size > 0 ? (pa * da + pb * db) / size : 0;
  t = std::clamp(t, 0.0, 1.0);
  const double ea = pa - t * da, eb = pb - t * db;
  return ea * ea + eb * eb;
}

/// Marks what Douglas and Peucker keep between two kept points; indices may run over the end.
void keep_between(std::span<const PlanePoint> points, std::size_t first, std::size_t last, double tolerance,
                  std::vector<std::uint8_t>& kept) {
  std::vector<std::pair<std::size_t, std::size_t>> open{{first, last}};
  while (!open.empty()) {
    const auto [from, to] = open.back();
    open.pop_back();
    double farthest = tolerance * tolerance;
    std::size_t at = from;
    for (std::size_t i = from + 1; i < to; ++i) {
      const double d = squared_distance(points[i % points.size()], points[from], points[to % points.size()]);
      if (d > farthest) {
        farthest = d;
        at = i;
      }
    }
    if (at == from) continue;
    kept[at % points.size()] = 1;
    open.push_back({from, at});
    open.push_back({at, to});
  }
}

/// Step 6.
std::vector<PlanePoint> simplified(std::span<const PlanePoint> loop, double tolerance) {
  // Two points that are surely corners: the lowest left one, and the farthest from it.
  const auto lower = [](const PlanePoint& p, const PlanePoint& q) {
    return p.a + p.b != q.a + q.b ? p.a + p.b < q.a + q.b : p.a < q.a;
  };
  const auto first = std::min_element(loop.begin(), loop.end(), lower);
  std::vector<PlanePoint> points(first, loop.end());
  points.insert(points.end(), loop.begin(), first);
  std::size_t far = 0;
  double most = -1;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double d = squared_distance(points[i], points[0], points[0]);
    if (d <= most) continue;
    most = d;
    far = i;
  }
  std::vector<std::uint8_t> kept(points.size(), 0);
  kept[0] = kept[far] = 1;
  keep_between(points, 0, far, tolerance, kept);
  keep_between(points, far, points.size(), tolerance, kept);
  std::vector<PlanePoint> left;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (kept[i] != 0) left.push_back(points[i]);
  }
  return left;
}

/// Steps 3 to 6.
void read_loops(Raster& raster, const ExtentOptions& options, double min_area,
                std::vector<ExtentLoop>& loops) {
  close_gaps(raster, options.max_gap);
  fill_holes(raster, options.max_hole);
  drop_islands(raster, min_area);
  for (const CellLoop& cells : cell_borders(raster)) {
    std::vector<PlanePoint> points;
    for (std::size_t i = 0; i < cells.x.size(); ++i) {
      points.push_back(
          {raster.origin.a + cells.x[i] * raster.cell, raster.origin.b + cells.y[i] * raster.cell});
    }
    const bool hole = signed_area(points) < 0;
    std::vector<PlanePoint> few = simplified(points, straight_cells * raster.cell);
    // A sliver keeps its shape.
    if (few.size() < 3 || (signed_area(few) < 0) != hole || signed_area(few) == 0) few = points;
    const double area = signed_area(few);
    loops.push_back({std::move(few), area});
  }
}

/// Steps 2 to 6 of one lot.
void loops_of(std::span<const ExtentPiece> pieces, const ExtentOptions& options, double min_area,
              std::vector<ExtentLoop>& loops) {
  Raster raster = raster_for(pieces, options.cell, options.max_gap);
  for (const ExtentPiece& piece : pieces) paint(raster, piece);
  read_loops(raster, options, min_area, loops);
}

void largest_first(std::vector<ExtentLoop>& loops) {
  std::stable_sort(loops.begin(), loops.end(),
                   [](const ExtentLoop& a, const ExtentLoop& b) { return a.area > b.area; });
}

bool sensible(const ExtentPiece& p) {
  constexpr double most = 1e6;
  return p.a0 > -most && p.a1 < most && p.b0 > -most && p.b1 < most && p.a0 <= p.a1 && p.b0 <= p.b1;
}

ExtentPiece bounds_of(const ExtentLoop& loop) {
  ExtentPiece box{loop.points[0].a, loop.points[0].a, loop.points[0].b, loop.points[0].b};
  for (const PlanePoint& p : loop.points) {
    box = {std::min(box.a0, p.a), std::max(box.a1, p.a), std::min(box.b0, p.b), std::max(box.b1, p.b)};
  }
  return box;
}

}  // namespace

double signed_area(std::span<const PlanePoint> loop) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const PlanePoint& p = loop[i];
    const PlanePoint& q = loop[(i + 1) % loop.size()];
    sum += (p.a - loop[0].a) * (q.b - loop[0].b) - (q.a - loop[0].a) * (p.b - loop[0].b);
  }
  return sum / 2;
}

std::vector<ExtentLoop> extent_loops(std::span<const ExtentPiece> pieces, const ExtentOptions& options) {
  std::vector<ExtentPiece> good;
  std::copy_if(pieces.begin(), pieces.end(), std::back_inserter(good), sensible);
  std::vector<ExtentLoop> loops;
  // Step 1.
  const auto lots = lots_of(good, std::max(smallest_lot_cell, options.max_gap));
  for (const auto& lot : lots) loops_of(lot, options, options.min_area, loops);
  if (loops.empty()) {
    for (const auto& lot : lots) loops_of(lot, options, 0, loops);
  }
  largest_first(loops);
  return loops;
}

std::vector<ExtentLoop> united_loops(std::span<const std::vector<ExtentLoop>> things,
                                     const ExtentOptions& options) {
  std::vector<ExtentPiece> boxes;
  std::vector<std::vector<ExtentLoop>> good(things.size());
  for (std::size_t i = 0; i < things.size(); ++i) {
    for (const ExtentLoop& loop : things[i]) {
      if (loop.points.size() < 3 || !sensible(bounds_of(loop))) continue;
      boxes.push_back(bounds_of(loop));
      good[i].push_back(loop);
    }
  }
  std::vector<ExtentLoop> loops;
  if (boxes.empty()) return loops;
  Raster raster = raster_for(boxes, options.cell, options.max_gap);
  for (const auto& thing : good) paint(raster, thing);
  read_loops(raster, options, 0, loops);
  largest_first(loops);
  return loops;
}

}  // namespace straightedge
