// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/contest.hpp"

#include "ransac/support.hpp"

namespace straightedge::ransac {
namespace {

/// More than nine cells can cost.
constexpr float unowned = 10;

/// The cost of each cell of a row and its two neighbours. An empty cell costs the same for all candidates.
void cost_row(const Lattice& lattice, std::size_t first, std::int32_t count, const InverseDepthPlane& plane,
              float* __restrict single, float* __restrict triple) noexcept {
  const auto a = static_cast<float>(plane.a);
  const auto b = static_cast<float>(plane.b);
  const auto c = static_cast<float>(plane.c);
  const float* u = &lattice.memory.u[first];
  const float* v = &lattice.memory.v[first];
  const float* q = &lattice.memory.q[first];
  const float* w = &lattice.memory.w[first];
  for (std::int32_t i = 0; i < count; ++i) {
    const float e = (q[i] - ((a * u[i] + b * v[i]) + c)) * w[i];
    const float squared = e * e;
    single[i] = squared < 1 ? squared : 1;
  }
  for (std::int32_t i = 1; i + 1 < count; ++i) triple[i] = (single[i - 1] + single[i + 1]) + single[i];
}

void take_cheaper(const float* above, const float* here, const float* below, const std::uint8_t* core,
                  std::int32_t count, std::int32_t label, float* __restrict cost,
                  std::int32_t* __restrict owner) noexcept {
  for (std::int32_t i = 0; i < count; ++i) {
    const float sum = (above[i] + below[i]) + here[i];
    const float asked = core[i] != 0 ? sum : unowned;
    const bool cheaper = asked < cost[i];
    cost[i] = cheaper ? asked : cost[i];
    owner[i] = cheaper ? label : owner[i];
  }
}

CellBox box_of(const Lattice& lattice, const ProposedPlane& c) noexcept {
  return {c.column0 / lattice.cell, c.row0 / lattice.cell, c.column1 / lattice.cell, c.row1 / lattice.cell};
}

void contest_for(const Lattice& lattice, const ProposedPlane& candidate, std::int32_t label) noexcept {
  const InverseDepthPlane& plane = candidate.fit.plane;
  const CellBox box = box_of(lattice, candidate);
  const std::int32_t width = box.x1 - box.x0;
  const detail::RansacSearchMemory& m = lattice.memory;
  const auto stride = static_cast<std::size_t>(lattice.stride);
  (void)mark_core(lattice, m.q, plane, box);
  for (std::int32_t row = box.y0 - 1; row <= box.y1; ++row) {
    const std::size_t i = lattice.at(box.x0 - 1, row);
    cost_row(lattice, i, width + 2, plane, m.single.data(), &m.triple[i]);
  }
  for (std::int32_t row = box.y0; row < box.y1; ++row) {
    const std::size_t i = lattice.at(box.x0, row);
    take_cheaper(&m.triple[i - stride], &m.triple[i], &m.triple[i + stride], &m.core[i], width, label,
                 &m.cost[i], &m.owner[i]);
  }
}

std::uint32_t mark_owned(const Lattice& lattice, std::size_t first, std::int32_t count,
                         std::int32_t label) noexcept {
  const std::int32_t* owner = &lattice.memory.owner[first];
  std::uint8_t* core = &lattice.memory.core[first];
  std::int32_t owned = 0;
  for (std::int32_t i = 0; i < count; ++i) {
    core[i] = owner[i] == label ? 1 : 0;
    owned += owner[i] == label ? 1 : 0;
  }
  return static_cast<std::uint32_t>(owned);
}

}  // namespace

void contest_cells(const Lattice& lattice, std::span<const ProposedPlane> candidates) noexcept {
  for (std::size_t i = 0; i < lattice.memory.owner.size(); ++i) {
    lattice.memory.owner[i] = 0;
    lattice.memory.cost[i] = unowned;
  }
  std::int32_t label = 0;
  for (const ProposedPlane& candidate : candidates) contest_for(lattice, candidate, ++label);
}

void refit_owners(const Lattice& lattice, std::span<ProposedPlane> candidates, std::uint32_t least,
                  double sigma) noexcept {
  const detail::RansacSearchMemory& m = lattice.memory;
  std::int32_t label = 0;
  for (ProposedPlane& candidate : candidates) {
    ++label;
    std::uint32_t cells = 0;
    const CellBox box = box_of(lattice, candidate);
    for (std::int32_t row = box.y0; row < box.y1; ++row)
      cells += mark_owned(lattice, lattice.at(box.x0, row), box.x1 - box.x0, label);
    double rms_gates = 0;
    const bool fitted = cells >= least && refit_core(lattice, m.q, box, 1, sigma, candidate.fit, rms_gates);
    candidate.readings = fitted ? cells : 0;
    candidate.score = fitted ? static_cast<double>(cells) * (1 - rms_gates * rms_gates) : 0;
  }
}

}  // namespace straightedge::ransac
