// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "ransac/lattice.hpp"
#include "straightedge/ransac_search.hpp"

namespace straightedge::ransac {

/// Gives each cell to the candidate that fits the nine cells round it best, among those that it supports;
/// writes its index + 1 into memory.owner, 0 for none. A single reading cannot tell two planes apart where
/// they cross: nine that agree can, and no candidate keeps a stripe on another's surface.
void contest_cells(const Lattice& lattice, std::span<const ProposedPlane> candidates) noexcept;

/// Refits every candidate to the cells it owns. One that owns fewer than `least` gets none.
void refit_owners(const Lattice& lattice, std::span<ProposedPlane> candidates, std::uint32_t least,
                  double sigma) noexcept;

}  // namespace straightedge::ransac
