// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "plane_shape.hpp"

#include <algorithm>
#include <array>

#include "depth_surfaces.hpp"
#include "four_labels.hpp"
#include "straightedge/detail/quadratic_surface.hpp"
#include "straightedge/square_root.hpp"

namespace straightedge::detail {
namespace {

// A solid cell: a quarter of its pixels have readings, and they lie on the plane.
constexpr float on_plane = 2.5F;
constexpr double least_solid_share = 0.5;
// Pieces with fewer pixels than this share of the least plane are chance: other planes may have them.
constexpr double crumb_share = 0.3;

// Bend, in standard deviations of one reading, and its significance. True planes of rendered rooms stay below
// both pairs in 98 of 100 cases, strips of balls and pillars above one of them in 9 of 10.
// Of a plane with more cells every n-th is looked at for its bend.
constexpr std::size_t enough_cells = 500;
struct BendLimit {
  double bend, significance;
};
constexpr std::array<BendLimit, 2> bend_limits{BendLimit{0.3, 1.2}, BendLimit{0.2, 1.75}};
// Walls bend in the pictures of real sensors, though by far less.
constexpr double largest_radius_m = 0.6;

// Beside the label of the plane that visited a cell: it is not the plane's.
constexpr std::uint16_t refused = 0x8000;

constexpr std::uint16_t label_of(std::uint16_t visited) noexcept {
  return static_cast<std::uint16_t>(visited & ~refused);
}

/// Runs of cells in a row: begin, end, begin, end, ...
struct Pieces {
  std::span<std::int32_t> runs;
  std::size_t end = 0;
  std::size_t own = 0, cells = 0;  ///< of the last piece

  void begin_at(std::size_t first) noexcept {
    end = first;
    own = cells = 0;
  }
  void append(std::int32_t left, std::int32_t right, std::size_t own_cells) noexcept {
    runs[end++] = left;
    runs[end++] = right;
    own += own_cells;
    cells += static_cast<std::size_t>(right - left);
  }
};

struct Flood {
  const DepthCells& cells;
  std::span<const std::uint8_t> counts;
  Size size;
  std::int32_t least;  ///< readings of a solid cell
  std::span<std::uint16_t> labels;
  std::uint16_t label;
  DepthSurface surface;
  const PlaneGate& gate;
  const ShapeMemory& memory;
  std::uint64_t own_four = 0;  ///< the label, four times

  bool enters(std::size_t i) const noexcept {
    if (label_of(memory.visited[i]) == label) return false;
    // What has the label has readings enough and lies on the plane, or it would not have it.
    if (labels[i] == label) return true;
    if (counts[i] >= least && is_on_plane(i)) return true;
    memory.visited[i] = static_cast<std::uint16_t>(label | refused);
    return false;
  }
  bool is_on_plane(std::size_t i) const noexcept {
    const DepthCellRows all = cells.rows(cells.finest(), i);
    const float n = all.first[0], u = all.first[all.apart], v = all.first[2 * all.apart];
    const float q = all.first[3 * all.apart];
    const auto noise = static_cast<float>(gate.inverse_noise(static_cast<double>(q)));
    const float limit = on_plane * (noise * noise);
    // Most cells are off with their means already.
    const float off = q - value_at(surface, u, v);
    return off * off < limit && squared_residuals(cells.at(cells.finest(), i), surface) < limit * n;
  }
  bool is_own(std::int32_t i) const noexcept { return labels[static_cast<std::size_t>(i)] == label; }
  /// The first cell from i to `end` on that is not the plane's own.
  std::int32_t end_of_own(std::int32_t i, std::int32_t end) const noexcept {
    while (i + 4 <= end && four(&labels[static_cast<std::size_t>(i)]) == own_four) i += 4;
    while (i < end && is_own(i)) ++i;
    return i;
  }
  /// Appends the run of cells with the cell that belongs to the piece. `first` is the first cell of its row.
  void visit(std::int32_t cell, std::int32_t first, Pieces& pieces) const noexcept {
    if (!enters(static_cast<std::size_t>(cell))) return;
    const std::int32_t last = first + size.width;
    std::int32_t left = cell, right = cell;
    std::size_t own = 0;
    while (left > first && enters(static_cast<std::size_t>(left - 1))) own += is_own(--left) ? 1U : 0U;
    do {
      const std::int32_t begin = right;
      right = end_of_own(right, last);
      own += static_cast<std::size_t>(right - begin);
      if (right == begin) ++right;  // another's cell, which entered
    } while (right < last && enters(static_cast<std::size_t>(right)));
    std::fill(memory.visited.begin() + left, memory.visited.begin() + right, label);
    pieces.append(left, right, own);
  }
  /// Visits the cells [left, right) of another row, which begins at `first`.
  void visit_all(std::int32_t left, std::int32_t right, std::int32_t first, Pieces& pieces) const noexcept {
    constexpr std::uint64_t no_refusal = ~(std::uint64_t{refused} * four_ones);
    for (std::int32_t i = left; i < right;) {
      if (i + 4 <= right && (four(&memory.visited[static_cast<std::size_t>(i)]) & no_refusal) == own_four) {
        i += 4;
        continue;
      }
      if (label_of(memory.visited[static_cast<std::size_t>(i)]) != label) visit(i, first, pieces);
      ++i;
    }
  }
  /// Appends the piece that holds `seed` to those from `first` on.
  void piece(std::int32_t seed, std::size_t first, Pieces& pieces) const noexcept {
    pieces.begin_at(first);
    visit(seed, seed / size.width * size.width, pieces);
    for (std::size_t next = first; next < pieces.end; next += 2) {
      const std::int32_t left = pieces.runs[next], right = pieces.runs[next + 1];
      const std::int32_t row = left / size.width * size.width;
      if (row > 0) visit_all(left - size.width, right - size.width, row - size.width, pieces);
      if (static_cast<std::size_t>(row + size.width) < labels.size()) {
        visit_all(left + size.width, right + size.width, row + size.width, pieces);
      }
    }
  }
};

void drop_label(std::span<const std::int32_t> runs, const Flood& flood) noexcept {
  for_cells(runs, 1, [&](std::size_t cell) noexcept {
    if (flood.labels[cell] == flood.label) flood.labels[cell] = 0;
  });
}

/// The plane's next cell that was not visited; there must be one.
std::size_t next_seed(const LabelledCells& plane, std::span<const std::uint16_t> visited,
                      std::size_t i) noexcept {
  constexpr std::size_t at_once = 32;
  const std::uint16_t* labels = plane.labels.data();
  const auto is_seed = [&](std::size_t cell) noexcept {
    return static_cast<int>(labels[cell] == plane.label) & static_cast<int>(visited[cell] != plane.label);
  };
  for (; i + at_once < plane.labels.size(); i += at_once) {
    int found = 0;
    for (std::size_t k = 0; k < at_once; ++k) found |= is_seed(i + k);
    if (found != 0) break;
  }
  while (i + 1 < plane.labels.size() && is_seed(i) == 0) ++i;
  return i;
}

struct Bend {
  double rms = 0;        ///< of the quadratic part, 1/metre
  double curvature = 0;  ///< largest second derivative, 1/(metre pixel²)
};

/// Largest absolute eigenvalue of [2a b; b 2c], the second derivatives of a uu + b uv + c vv.
double largest_curvature(double a, double b, double c) noexcept {
  const double mean = a + c;
  const double spread = square_root((a - c) * (a - c) + b * b);
  return (mean < 0 ? -mean : mean) + spread;
}

/// What is known of the cells from some of them.
struct Sample {
  std::size_t step;
  double n = 0, u = 0, v = 0, q = 0, spread = 0;
};

Sample sample(const DepthCells& cells, std::span<const std::int32_t> runs, std::size_t count) noexcept {
  Sample s{1 + count / enough_cells};
  for_cells(runs, s.step, [&](std::size_t i) noexcept {
    const DepthCell cell = cells.at(cells.finest(), i);
    const double n = static_cast<double>(cell.n), u = static_cast<double>(cell.u),
                 v = static_cast<double>(cell.v);
    s.n += n;
    s.u += n * u;
    s.v += n * v;
    s.q += n * static_cast<double>(cell.q);
    s.spread += n * (u * u + v * v) + static_cast<double>(cell.uu + cell.vv);
  });
  s.u /= s.n;
  s.v /= s.n;
  s.q /= s.n;
  s.spread = s.spread / s.n - s.u * s.u - s.v * s.v;
  return s;
}

Bend measure_bend(const DepthCells& cells, std::span<const std::int32_t> runs, const BentPlane& surface,
                  const Sample& taken) noexcept {
  const double scale = square_root(taken.spread > 1 ? taken.spread : 1.0), inverse_scale = 1 / scale;
  QuadraticSums sums;
  for_cells(runs, taken.step, [&](std::size_t i) noexcept {
    const DepthCell cell = cells.at(cells.finest(), i);
    const double u = static_cast<double>(cell.u), v = static_cast<double>(cell.v);
    const double off =
        static_cast<double>(cell.q) - surface.plane.at(u + cells.middle_u(), v + cells.middle_v());
    sums.add((u - taken.u) * inverse_scale, (v - taken.v) * inverse_scale, off, static_cast<double>(cell.n));
  });
  QuadraticFit fit;
  if (!fit_quadratic(sums, 0, fit)) return {};  // too few cells, or all in a row
  return {square_root(fit.bend_squares / sums.n),
          largest_curvature(fit.coefficients[3], fit.coefficients[4], fit.coefficients[5]) / (scale * scale)};
}

}  // namespace

PlaneShape plane_shape(const DepthCells& cells, const LabelledCells& plane, const BentPlane& surface,
                       const FramePlanesOptions& options, double min_pixels, const PinholeCamera& camera,
                       const ShapeMemory& memory, bool drop_crumbs, std::size_t& solid) noexcept {
  // Step 1.
  const double cell_pixels = options.cell * options.cell;
  const Flood flood{cells,
                    cells.counts(),
                    cells.size(cells.finest()),
                    options.cell * options.cell / 4,
                    plane.labels,
                    plane.label,
                    in_floats(surface, cells.middle_u(), cells.middle_v()),
                    options.gate,
                    memory,
                    plane.label * four_ones};
  double all = static_cast<double>(plane.count), in_solid = 0;
  solid = 0;
  std::size_t left = plane.count, solid_cells = 0;
  Pieces pieces{memory.runs};
  for (std::size_t i = plane.first; left > 0; ++i) {
    i = next_seed(plane, memory.visited, i);
    flood.piece(static_cast<std::int32_t>(i), solid, pieces);
    const auto own = static_cast<double>(pieces.own);
    left -= pieces.own;
    if (drop_crumbs && own * cell_pixels < crumb_share * min_pixels) {
      drop_label(memory.runs.subspan(solid, pieces.end - solid), flood);
      all -= own;
    }
    if (own * cell_pixels < min_pixels) continue;
    in_solid += own;
    solid = pieces.end;
    solid_cells += pieces.cells;
  }
  // Step 2.
  if (in_solid <= 0 || in_solid < least_solid_share * all) return PlaneShape::stripe;
  if (!options.reject_curved) return PlaneShape::flat;
  // Step 3.
  const std::span<const std::int32_t> runs = memory.runs.first(solid);
  const Sample taken = sample(cells, runs, solid_cells);
  const double noise = options.gate.inverse_noise(taken.q);
  const Bend found = measure_bend(cells, runs, surface, taken);
  const double bend = found.rms / noise;
  const double readings = taken.n * static_cast<double>(taken.step);
  const double significance = bend * square_root(readings / (3 * options.noise_pixels));
  // A sphere or cylinder of radius r has second derivative 1/(r f²) in 1/z, at any distance.
  const double focal_square = camera.fx * camera.fx;
  if (!(found.curvature * focal_square * largest_radius_m > 1)) return PlaneShape::flat;
  for (const BendLimit& limit : bend_limits) {
    if (bend > limit.bend && significance > limit.significance) return PlaneShape::bent;
  }
  return PlaneShape::flat;
}

}  // namespace straightedge::detail
