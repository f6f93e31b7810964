// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "ransac/lattice.hpp"

namespace straightedge::ransac {

/// How far readings of this frame stray from the planes on which they lie, in units of the standard deviation
/// that the gate supposes: the lower quartile over the lattice's cells, each the residual of its best plane.
/// Between 1 and most_noise; 1 if there are too few such cells, or the gate is in metres. Takes the
/// lattice with a gate of its own.
double frame_noise(const Lattice& lattice, const DepthCells& cells,
                   const RansacSearchOptions& options) noexcept;

}  // namespace straightedge::ransac
