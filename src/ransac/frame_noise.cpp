// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/frame_noise.hpp"

#include "straightedge/square_root.hpp"

namespace straightedge::ransac {
namespace {

constexpr std::size_t most_cells = 64;
constexpr std::uint32_t least_cells = 4;
constexpr float least_readings = 48;

}  // namespace

double frame_noise(const Lattice& lattice, const DepthCells& cells,
                   const RansacSearchOptions& options) noexcept {
  if (options.gate.fixed_m > 0) return 1;
  SearchGate gate = search_gate(options.gate, 1);
  gate.most_squared = 1e12F;
  // A few of the cells, evenly.
  const std::size_t all = DepthCells::cell_count(cells.size(lattice.level));
  const std::size_t step = all / most_cells + 1;
  double sorted[most_cells];
  std::uint32_t count = 0;
  for (std::int32_t row = 0; row < lattice.rows; ++row) {
    take_row(lattice, cells, row, gate);
    const std::size_t place = static_cast<std::size_t>(row) * static_cast<std::size_t>(lattice.columns);
    const float* readings = cells.rows(lattice.level, place).first;
    for (std::size_t i = (step - place % step) % step; i < static_cast<std::size_t>(lattice.columns);
         i += step) {
      if (!(readings[i] >= least_readings) || !(lattice.cells.q[lattice.at(0, row) + i] > 0)) continue;
      const double mean = static_cast<double>(lattice.memory.row[i]) / static_cast<double>(readings[i]);
      std::uint32_t at = count++;
      for (; at > 0 && sorted[at - 1] > mean; --at) sorted[at] = sorted[at - 1];
      sorted[at] = mean;
    }
  }
  if (count < least_cells || !(sorted[count / 4] > 0)) return 1;
  const double noise = square_root(sorted[count / 4]) * static_cast<double>(mean_gate) * options.gate.sigmas;
  return noise < 1 ? 1 : (noise > options.most_noise ? options.most_noise : noise);
}

}  // namespace straightedge::ransac
