// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/support.hpp"

#include <cstring>

#include "ransac/fold.hpp"
#include "straightedge/square_root.hpp"

namespace straightedge::ransac {
namespace {

constexpr std::uint8_t least_neighbours = 3;

struct FloatPlane {
  explicit FloatPlane(const InverseDepthPlane& p) noexcept
      : a(static_cast<float>(p.a)), b(static_cast<float>(p.b)), c(static_cast<float>(p.c)) {}
  float a, b, c;
};

/// Pointers to the readings of a row of cells.
struct CellRow {
  CellRow(const Lattice& lattice, std::span<const float> free_q, std::size_t first) noexcept
      : u(&lattice.memory.u[first]),
        v(&lattice.memory.v[first]),
        q(&free_q[first]),
        w(&lattice.memory.w[first]) {}
  const float *u, *v, *q, *w;
};

/// Which of `count` readings are within the gate.
void mark_hits(const CellRow& row, std::int32_t count, const FloatPlane& p,
               std::uint8_t* __restrict hit) noexcept {
  for (std::int32_t i = 0; i < count; ++i) {
    const float e = (row.q[i] - ((p.a * row.u[i] + p.b * row.v[i]) + p.c)) * row.w[i];
    hit[i] = e * e < 1 ? 1 : 0;
  }
}

/// Hits with enough hits round them; `stride` to the rows above and below.
void keep_dense(const std::uint8_t* hit, std::ptrdiff_t stride, std::int32_t count,
                std::uint8_t* __restrict core) noexcept {
  const std::uint8_t* above = hit - stride;
  const std::uint8_t* below = hit + stride;
  for (std::int32_t i = 0; i < count; ++i) {
    const auto near = static_cast<std::uint8_t>(above[i - 1] + above[i] + above[i + 1] + hit[i - 1] +
                                                hit[i + 1] + below[i - 1] + below[i] + below[i + 1]);
    core[i] = static_cast<std::uint8_t>((near >= least_neighbours ? 1 : 0) & hit[i]);
  }
}

/// The eight bytes of a group.
std::uint64_t group_of(const std::uint8_t* core) noexcept {
  static_assert(cell_lanes == 8);
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, core, sizeof bytes);
  return bytes;
}

/// Adds the marked cells of a row, which begins at column x0. What lies past the count in the last group is
/// border, never marked.
void add_marked(const std::uint8_t* core, std::int32_t count, std::int32_t x0, std::int32_t y,
                Core& all) noexcept {
  std::uint32_t marked = 0;
  for (std::int32_t i = 0; i < count; i += cell_lanes) {
    const std::uint64_t group = group_of(core + i);
    if (group == 0) continue;
    marked += static_cast<std::uint32_t>((group * 0x0101010101010101ULL) >> 56U);
    if (x0 + i < all.bounds.x0) all.bounds.x0 = x0 + i;
    if (x0 + i + cell_lanes > all.bounds.x1) all.bounds.x1 = x0 + i + cell_lanes;
  }
  if (marked == 0) return;
  if (all.cells == 0) all.bounds.y0 = y;
  all.bounds.y1 = y + 1;
  all.cells += marked;
}

struct LaneSums {
  float n[cell_lanes], u[cell_lanes], v[cell_lanes], uu[cell_lanes], uv[cell_lanes], vv[cell_lanes],
      r[cell_lanes], ur[cell_lanes], vr[cell_lanes], rr[cell_lanes], ww[cell_lanes];
};

/// Adds the marked cells of a group; u and v counted from (u0, v0).
void add_group(const CellRow& row, std::int32_t i, const std::uint8_t* core, const FloatPlane& p, float u0,
               float v0, LaneSums& s) noexcept {
  for (std::int32_t l = 0; l < cell_lanes; ++l) {
    const auto m = static_cast<float>(core[i + l]);
    const float x = row.u[i + l] - u0;
    const float y = row.v[i + l] - v0;
    const float r = row.q[i + l] - ((p.a * row.u[i + l] + p.b * row.v[i + l]) + p.c);
    const float mx = m * x;
    const float my = m * y;
    const float mr = m * r;
    s.n[l] += m;
    s.u[l] += mx;
    s.v[l] += my;
    s.uu[l] += mx * x;
    s.uv[l] += mx * y;
    s.vv[l] += my * y;
    s.r[l] += mr;
    s.ur[l] += mr * x;
    s.vr[l] += mr * y;
    s.rr[l] += mr * r;
    s.ww[l] += m * (row.w[i + l] * row.w[i + l]);
  }
}

void add_row(const LaneSums& s, CoreSums& sums) noexcept {
  InverseDepthMoments& m = sums.moments;
  m.n += fold(s.n);
  m.u += fold(s.u);
  m.v += fold(s.v);
  m.uu += fold(s.uu);
  m.uv += fold(s.uv);
  m.vv += fold(s.vv);
  m.q += fold(s.r);
  m.uq += fold(s.ur);
  m.vq += fold(s.vr);
  m.qq += fold(s.rr);
  sums.ww += fold(s.ww);
}

}  // namespace

Core mark_core(const Lattice& lattice, std::span<const float> q, const InverseDepthPlane& plane,
               const CellBox& box) noexcept {
  const FloatPlane p(plane);
  // Neighbours of the cells at the border of the box count too, where the picture has any.
  const std::int32_t x0 = box.x0 > 0 ? box.x0 - 1 : 0;
  const std::int32_t x1 = box.x1 < lattice.columns ? box.x1 + 1 : lattice.columns;
  const std::int32_t y0 = box.y0 > 0 ? box.y0 - 1 : 0;
  const std::int32_t y1 = box.y1 < lattice.rows ? box.y1 + 1 : lattice.rows;
  for (std::int32_t y = y0; y < y1; ++y) {
    const std::size_t i = lattice.at(x0, y);
    mark_hits({lattice, q, i}, x1 - x0, p, &lattice.memory.hit[i]);
  }
  Core core;
  core.bounds = {lattice.columns, 0, 0, 0};
  for (std::int32_t y = box.y0; y < box.y1; ++y) {
    const std::size_t i = lattice.at(box.x0, y);
    keep_dense(&lattice.memory.hit[i], lattice.stride, box.x1 - box.x0, &lattice.memory.core[i]);
    add_marked(&lattice.memory.core[i], box.x1 - box.x0, box.x0, y, core);
  }
  if (core.cells == 0) core.bounds = {};
  if (core.bounds.x1 > lattice.columns) core.bounds.x1 = lattice.columns;
  return core;
}

CoreSums sum_core(const Lattice& lattice, std::span<const float> q, const InverseDepthPlane& plane,
                  const CellBox& box, std::int32_t row_step) noexcept {
  const FloatPlane p(plane);
  // Counted from the middle of the box, floats resolve a small region as well as a large one.
  const std::int32_t middle_u = (box.x0 + box.x1) / 2 * lattice.cell;
  const std::int32_t middle_v = (box.y0 + box.y1) / 2 * lattice.cell;
  CoreSums sums;
  for (std::int32_t y = box.y0; y < box.y1; y += row_step) {
    const std::size_t first = lattice.at(box.x0, y);
    const std::uint8_t* core = &lattice.memory.core[first];
    const CellRow row(lattice, q, first);
    LaneSums lanes{};
    bool any = false;
    for (std::int32_t i = 0; i < box.x1 - box.x0; i += cell_lanes) {
      if (group_of(core + i) == 0) continue;
      any = true;
      add_group(row, i, core, p, static_cast<float>(middle_u), static_cast<float>(middle_v), lanes);
    }
    if (any) add_row(lanes, sums);
  }
  sums.moments = sums.moments.seen_from(-middle_u, -middle_v);
  return sums;
}

bool refit_core(const Lattice& lattice, std::span<const float> q, const CellBox& box, std::int32_t row_step,
                double sigma, InverseDepthFit& fit, double& rms_gates) noexcept {
  const InverseDepthPlane before = fit.plane;
  const CoreSums sums = sum_core(lattice, q, before, box, row_step);
  if (fit_inverse_depth(sums.moments, sigma, fit) != Status::ok) return false;
  fit.plane = {before.a + fit.plane.a, before.b + fit.plane.b, before.c + fit.plane.c};
  rms_gates = fit.rms * square_root(sums.ww / sums.moments.n);
  return true;
}

}  // namespace straightedge::ransac
