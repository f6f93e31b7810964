// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/contest.hpp"

#include "ransac/support.hpp"

namespace straightedge::ransac {
namespace {

/// More than nine cells can cost.
constexpr float unowned = 10;

CellBox box_of(const Lattice& lattice, const ProposedPlane& c) noexcept {
  return {c.column0 / lattice.cell, c.row0 / lattice.cell, c.column1 / lattice.cell, c.row1 / lattice.cell};
}

void contest_for(const Lattice& lattice, const ProposedPlane& candidate, float label) noexcept {
  const InverseDepthPlane& plane = candidate.fit.plane;
  const CellBox box = box_of(lattice, candidate);
  const detail::RansacSearchMemory& m = lattice.memory;
  (void)mark_core(lattice, m.q, plane, box);
  const std::size_t first = lattice.at(box.x0, box.y0);
  const SearchBox shape{box.x1 - box.x0, box.y1 - box.y0, lattice.stride};
  lattice.kernels.take_cheaper(lattice.readings(m.q, first), &m.core[first], shape, in_floats(plane), label,
                               m.row.data(), &m.free_q[first], &m.owner[first]);
}

std::uint32_t mark_owned(const Lattice& lattice, std::size_t first, std::int32_t count,
                         float label) noexcept {
  const float* owner = &lattice.memory.owner[first];
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
  // What is free is of no more use: its memory has the costs.
  for (float& cost : lattice.memory.free_q) cost = unowned;
  for (float& owner : lattice.memory.owner) owner = 0;
  float label = 0;
  for (const ProposedPlane& candidate : candidates) contest_for(lattice, candidate, ++label);
}

void refit_owners(const Lattice& lattice, std::span<ProposedPlane> candidates, std::uint32_t least,
                  double sigma) noexcept {
  const detail::RansacSearchMemory& m = lattice.memory;
  float label = 0;
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
