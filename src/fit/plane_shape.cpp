// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "plane_shape.hpp"

#include <algorithm>
#include <array>

#include "straightedge/detail/quadratic_surface.hpp"
#include "straightedge/square_root.hpp"

namespace straightedge::detail {
namespace {

constexpr double cell_pixels = DepthCells::side * DepthCells::side;
// A solid cell: half of its pixels have readings, and they lie on the plane.
constexpr double least_readings = cell_pixels / 4;
constexpr double on_plane = 2.5;
constexpr double least_solid_share = 0.5;
// Pieces with fewer pixels than this share of the least plane are chance: other planes may have them.
constexpr double crumb_share = 0.3;

// Bend, in standard deviations of one reading, and its significance. True planes of rendered rooms stay below
// both pairs in 98 of 100 cases, strips of balls and pillars above one of them in 9 of 10.
// Of a plane with more cells every n-th is looked at for its bend.
constexpr std::size_t enough_cells = 1000;
struct BendLimit {
  double bend, significance;
};
constexpr std::array<BendLimit, 2> bend_limits{BendLimit{0.3, 1.2}, BendLimit{0.2, 1.75}};
// Walls bend in the pictures of real sensors, though by far less.
constexpr double largest_radius_m = 0.6;

struct Flood {
  const DepthCells& cells;
  std::span<std::uint16_t> labels;
  std::uint16_t label;
  const BentPlane& surface;
  const PlaneGate& gate;
  const ShapeMemory& memory;

  bool enters(std::int32_t cell) const noexcept {
    const auto i = static_cast<std::size_t>(cell);
    const InverseDepthMoments& m = cells.level(0)[i];
    if (memory.visited[i] == label || m.n < least_readings) return false;
    if (labels[i] == label) return true;  // it lies on the plane, or would not have its label
    const double noise = gate.inverse_noise(m.q / m.n);
    return squared_residuals(m, surface.tangent(m.u / m.n, m.v / m.n)) < on_plane * noise * noise * m.n;
  }
  /// Appends the piece that holds `seed` to the list, which has `first` entries; returns its own cells.
  std::size_t piece(std::int32_t seed, std::size_t first, std::size_t& end) const noexcept {
    const Size size = cells.size(0);
    std::size_t own = 0;
    end = first;
    const auto visit = [&](std::int32_t cell) noexcept {
      if (!enters(cell)) return;
      memory.visited[static_cast<std::size_t>(cell)] = label;
      memory.list[end++] = cell;
    };
    visit(seed);
    for (std::size_t next = first; next < end; ++next) {
      const std::int32_t cell = memory.list[next];
      const std::int32_t x = cell % size.width, y = cell / size.width;
      own += labels[static_cast<std::size_t>(cell)] == label ? 1U : 0U;
      if (x > 0) visit(cell - 1);
      if (x + 1 < size.width) visit(cell + 1);
      if (y > 0) visit(cell - size.width);
      if (y + 1 < size.height) visit(cell + size.width);
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

Bend measure_bend(const DepthCells& cells, std::span<const std::int32_t> list, const InverseDepthPlane& plane,
                  const InverseDepthMoments& sum) noexcept {
  const double mean_u = sum.u / sum.n, mean_v = sum.v / sum.n;
  const double spread = (sum.uu + sum.vv) / sum.n - mean_u * mean_u - mean_v * mean_v;
  const double scale = square_root(spread > 1 ? spread : 1.0);
  QuadraticSums sums;
  const std::size_t step = 1 + list.size() / enough_cells;
  for (std::size_t i = 0; i < list.size(); i += step) {
    const InverseDepthMoments& m = cells.level(0)[static_cast<std::size_t>(list[i])];
    const double u = m.u / m.n, v = m.v / m.n;
    sums.add((u - mean_u) / scale, (v - mean_v) / scale, m.q / m.n - plane.at(u, v), m.n);
  }
  QuadraticFit fit;
  if (!fit_quadratic(sums, 0, fit)) return {};  // too few cells, or all in a row
  return {square_root(fit.bend_squares / sums.n),
          largest_curvature(fit.coefficients[3], fit.coefficients[4], fit.coefficients[5]) / (scale * scale)};
}

}  // namespace

PlaneShape plane_shape(const DepthCells& cells, std::span<std::uint16_t> cell_labels, std::uint16_t label,
                       const BentPlane& surface, const FramePlanesOptions& options, double min_pixels,
                       const PinholeCamera& camera, const ShapeMemory& memory, bool drop_crumbs,
                       std::size_t& solid) noexcept {
  // Step 1.
  const Flood flood{cells, cell_labels, label, surface, options.gate, memory};
  double all = 0, in_solid = 0;
  solid = 0;
  for (std::size_t i = 0; i < cell_labels.size(); ++i) {
    if (cell_labels[i] != label) continue;
    all += 1;
    std::size_t end = solid;
    const auto own = static_cast<double>(flood.piece(static_cast<std::int32_t>(i), solid, end));
    if (drop_crumbs && own * cell_pixels < crumb_share * min_pixels)
      drop_label(memory.list.subspan(solid, end - solid), flood);
    if (own * cell_pixels < min_pixels) continue;
    in_solid += own;
    solid = end;
  }
  // Step 2.
  if (in_solid <= 0 || in_solid < least_solid_share * all) return PlaneShape::stripe;
  if (!options.reject_curved) return PlaneShape::flat;
  // Step 3.
  InverseDepthMoments sum;
  for (std::size_t i = 0; i < solid; ++i) sum.add(cells.level(0)[static_cast<std::size_t>(memory.list[i])]);
  const double noise = options.gate.inverse_noise(sum.q / sum.n);
  const Bend found = measure_bend(cells, memory.list.first(solid), surface.plane, sum);
  const double bend = found.rms / noise;
  const double significance = bend * square_root(sum.n / (3 * options.noise_pixels));
  // A sphere or cylinder of radius r has second derivative 1/(r f²) in 1/z, at any distance.
  const double focal_square = camera.fx * camera.fx;
  if (!(found.curvature * focal_square * largest_radius_m > 1)) return PlaneShape::flat;
  for (const BendLimit& limit : bend_limits) {
    if (bend > limit.bend && significance > limit.significance) return PlaneShape::bent;
  }
  return PlaneShape::flat;
}

}  // namespace straightedge::detail
