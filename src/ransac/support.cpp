// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/support.hpp"

#include "straightedge/square_root.hpp"

namespace straightedge::ransac {
namespace {

/// Float sums of so many rows; what more there are is added up in double.
constexpr std::int32_t rows_at_once = 32;

SearchBox shape_of(const Lattice& lattice, const CellBox& box) noexcept {
  return {box.x1 - box.x0, box.y1 - box.y0, lattice.stride};
}

void add(const SearchSums& s, CoreSums& sums) noexcept {
  InverseDepthMoments& m = sums.moments;
  m.n += static_cast<double>(s.n);
  m.u += static_cast<double>(s.u);
  m.v += static_cast<double>(s.v);
  m.uu += static_cast<double>(s.uu);
  m.uv += static_cast<double>(s.uv);
  m.vv += static_cast<double>(s.vv);
  m.q += static_cast<double>(s.r);
  m.uq += static_cast<double>(s.ur);
  m.vq += static_cast<double>(s.vr);
  m.qq += static_cast<double>(s.rr);
  sums.ww += static_cast<double>(s.ww);
}

/// The marked columns in whole groups.
void bound_columns(const Lattice& lattice, const CellBox& box, CellBox& bounds) noexcept {
  const std::uint8_t* columns = lattice.memory.columns.data();
  std::int32_t first = box.x0, last = box.x1 - 1;
  while (columns[first - box.x0] == 0) ++first;
  while (columns[last - box.x0] == 0) --last;
  bounds.x0 = first / cell_lanes * cell_lanes;
  bounds.x1 = (last / cell_lanes + 1) * cell_lanes;
  if (bounds.x1 > lattice.columns) bounds.x1 = lattice.columns;
}

}  // namespace

Core mark_core(const Lattice& lattice, const InverseDepthPlane& plane, const CellBox& box,
               float gates) noexcept {
  const detail::RansacSearchLevel& c = lattice.cells;
  // Neighbours of the cells at the border of the box count too, where the picture has any.
  const std::int32_t x0 = box.x0 > 0 ? box.x0 - cell_lanes : 0;
  const std::int32_t x1 = box.x1 < lattice.columns ? box.x1 + 1 : lattice.columns;
  const std::int32_t y0 = box.y0 > 0 ? box.y0 - 1 : 0;
  const std::int32_t y1 = box.y1 < lattice.rows ? box.y1 + 1 : lattice.rows;
  const std::size_t outer = lattice.at(x0, y0), inner = lattice.at(box.x0, box.y0);
  lattice.kernels.mark_hits(lattice.readings(outer), {x1 - x0, y1 - y0, lattice.stride}, in_floats(plane),
                            gates * gates, &c.hit[outer]);
  const SearchMarks marks =
      lattice.kernels.keep_dense(&c.hit[inner], shape_of(lattice, box), &c.core[inner],
                                 lattice.memory.counts.data(), lattice.memory.columns.data());
  Core core;
  if (marks.cells == 0) return core;
  core.cells = marks.cells;
  core.bounds.y0 = box.y0 + marks.first_row;
  core.bounds.y1 = box.y0 + marks.end_row;
  bound_columns(lattice, box, core.bounds);
  return core;
}

CoreSums sum_core(const Lattice& lattice, const InverseDepthPlane& plane, const CellBox& box,
                  std::int32_t row_step) noexcept {
  // Counted from the middle of the box, floats resolve a small region as well as a large one.
  const std::int32_t middle_u = (box.x0 + box.x1) / 2 * lattice.cell;
  const std::int32_t middle_v = (box.y0 + box.y1) / 2 * lattice.cell;
  CoreSums sums;
  for (std::int32_t y = box.y0; y < box.y1; y += rows_at_once * row_step) {
    const std::int32_t left = (box.y1 - y + row_step - 1) / row_step;
    const std::size_t first = lattice.at(box.x0, y);
    const SearchBox rows{box.x1 - box.x0, left < rows_at_once ? left : rows_at_once,
                         static_cast<std::ptrdiff_t>(lattice.stride) * row_step};
    SearchSums part;
    lattice.kernels.sum_marked(lattice.readings(first), &lattice.cells.core[first], rows, in_floats(plane),
                               static_cast<float>(middle_u), static_cast<float>(middle_v),
                               lattice.memory.row.data(), part);
    add(part, sums);
  }
  sums.moments = sums.moments.seen_from(-middle_u, -middle_v);
  return sums;
}

bool refit_core(const Lattice& lattice, const CellBox& box, std::int32_t row_step, double sigma,
                InverseDepthFit& fit, double& rms_gates) noexcept {
  const InverseDepthPlane before = fit.plane;
  const CoreSums sums = sum_core(lattice, before, box, row_step);
  if (fit_inverse_depth(sums.moments, sigma, fit) != Status::ok) return false;
  fit.plane = {before.a + fit.plane.a, before.b + fit.plane.b, before.c + fit.plane.c};
  rms_gates = fit.rms * square_root(sums.ww / sums.moments.n);
  return true;
}

}  // namespace straightedge::ransac
