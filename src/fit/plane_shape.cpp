// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "plane_shape.hpp"

#include <algorithm>
#include <array>

#include "straightedge/detail/quadratic_surface.hpp"
#include "straightedge/square_root.hpp"

namespace straightedge::detail {
namespace {

// A solid cell: a quarter of its pixels have readings, and they lie on the plane.
constexpr double on_plane = 2.5;
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

struct Flood {
  std::span<const InverseDepthMoments> cells;
  std::span<const std::uint8_t> counts;
  Size size;
  std::int32_t least;  ///< readings of a solid cell
  std::span<std::uint16_t> labels;
  std::uint16_t label;
  const BentPlane& surface;
  const PlaneGate& gate;
  const ShapeMemory& memory;

  bool enters(std::size_t i) const noexcept {
    if (memory.visited[i] == label) return false;
    // What has the label has readings enough and lies on the plane, or it would not have it.
    if (labels[i] == label) return true;
    if (counts[i] < least) return false;
    const InverseDepthMoments& m = cells[i];
    const double noise = gate.inverse_noise(m.q / m.n);
    return squared_residuals(m, surface.tangent(m.u / m.n, m.v / m.n)) < on_plane * noise * noise * m.n;
  }
  /// Appends the cell and those left and right of it that belong to the piece. `first` is the first cell of
  /// its row.
  void visit(std::int32_t cell, std::int32_t first, std::size_t& end) const noexcept {
    if (!enters(static_cast<std::size_t>(cell))) return;
    std::int32_t left = cell, right = cell + 1;
    while (left > first && enters(static_cast<std::size_t>(left - 1))) --left;
    while (right < first + size.width && enters(static_cast<std::size_t>(right))) ++right;
    for (std::int32_t i = left; i < right; ++i) {
      memory.visited[static_cast<std::size_t>(i)] = label;
      memory.list[end++] = i;
    }
  }
  /// Visits the cells [left, right) of another row, which begins at `first`.
  void visit_all(std::int32_t left, std::int32_t right, std::int32_t first, std::size_t& end) const noexcept {
    for (std::int32_t i = left; i < right; ++i) {
      if (memory.visited[static_cast<std::size_t>(i)] != label) visit(i, first, end);
    }
  }
  /// Appends the piece that holds `seed` to the list, which has `first` entries; returns its own cells.
  std::size_t piece(std::int32_t seed, std::size_t first, std::size_t& end) const noexcept {
    std::size_t own = 0;
    end = first;
    visit(seed, seed / size.width * size.width, end);
    for (std::size_t next = first; next < end;) {
      const std::int32_t left = memory.list[next], row = left / size.width * size.width;
      std::int32_t right = left;
      for (; next < end && memory.list[next] == right && right < row + size.width; ++next, ++right) {
        own += labels[static_cast<std::size_t>(right)] == label ? 1U : 0U;
      }
      if (row > 0) visit_all(left - size.width, right - size.width, row - size.width, end);
      if (static_cast<std::size_t>(row + size.width) < labels.size()) {
        visit_all(left + size.width, right + size.width, row + size.width, end);
      }
    }
    return own;
  }
};

void drop_label(std::span<const std::int32_t> piece, const Flood& flood) noexcept {
  for (const std::int32_t cell : piece) {
    std::uint16_t& label = flood.labels[static_cast<std::size_t>(cell)];
    if (label == flood.label) label = 0;
  }
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
  InverseDepthMoments sum;
};

Sample sample(std::span<const InverseDepthMoments> cells, std::span<const std::int32_t> list) noexcept {
  Sample found{1 + list.size() / enough_cells, {}};
  for (std::size_t i = 0; i < list.size(); i += found.step) {
    found.sum.add(cells[static_cast<std::size_t>(list[i])]);
  }
  return found;
}

Bend measure_bend(std::span<const InverseDepthMoments> cells, std::span<const std::int32_t> list,
                  const InverseDepthPlane& plane, const Sample& taken) noexcept {
  const InverseDepthMoments& sum = taken.sum;
  const double mean_u = sum.u / sum.n, mean_v = sum.v / sum.n;
  const double spread = (sum.uu + sum.vv) / sum.n - mean_u * mean_u - mean_v * mean_v;
  const double scale = square_root(spread > 1 ? spread : 1.0);
  QuadraticSums sums;
  for (std::size_t i = 0; i < list.size(); i += taken.step) {
    const InverseDepthMoments& m = cells[static_cast<std::size_t>(list[i])];
    const double u = m.u / m.n, v = m.v / m.n;
    sums.add((u - mean_u) / scale, (v - mean_v) / scale, m.q / m.n - plane.at(u, v), m.n);
  }
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
  const std::span<const InverseDepthMoments> small = cells.level(cells.finest());
  const double cell_pixels = options.cell * options.cell;
  const Flood flood{small,
                    cells.counts(),
                    cells.size(cells.finest()),
                    options.cell * options.cell / 4,
                    plane.labels,
                    plane.label,
                    surface,
                    options.gate,
                    memory};
  double all = static_cast<double>(plane.count), in_solid = 0;
  solid = 0;
  std::size_t left = plane.count;
  for (std::size_t i = plane.first; left > 0; ++i) {
    i = next_seed(plane, memory.visited, i);
    std::size_t end = solid;
    const std::size_t own_cells = flood.piece(static_cast<std::int32_t>(i), solid, end);
    const auto own = static_cast<double>(own_cells);
    left -= own_cells;
    if (drop_crumbs && own * cell_pixels < crumb_share * min_pixels) {
      drop_label(memory.list.subspan(solid, end - solid), flood);
      all -= own;
    }
    if (own * cell_pixels < min_pixels) continue;
    in_solid += own;
    solid = end;
  }
  // Step 2.
  if (in_solid <= 0 || in_solid < least_solid_share * all) return PlaneShape::stripe;
  if (!options.reject_curved) return PlaneShape::flat;
  // Step 3.
  const std::span<const std::int32_t> list = memory.list.first(solid);
  const Sample taken = sample(small, list);
  const double noise = options.gate.inverse_noise(taken.sum.q / taken.sum.n);
  const Bend found = measure_bend(small, list, surface.plane, taken);
  const double bend = found.rms / noise;
  const double readings = taken.sum.n * static_cast<double>(taken.step);
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
