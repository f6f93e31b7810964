// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cell_labels.hpp"

#include <algorithm>

#include "labels_around.hpp"

namespace straightedge::detail {
namespace {

// A cell is a plane's when the mean square of its residuals is below so many variances of the noise.
// One for pure noise; a small cell's readings share their noise, so that its mean square strays further.
constexpr double pure = 2;
constexpr std::array<double, DepthCells::levels> pure_of_neighbour{4, 3, 2, 2};

// Cells with fewer readings than this share of their pixels are left to the next finer level.
constexpr double least_share = 0.2;

// A cell below this leaves no doubt about the smaller ones in it.
constexpr double beyond_doubt = 1;

std::size_t place_of(Size size, std::int32_t x, std::int32_t y) noexcept {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x);
}

struct Best {
  std::uint16_t label = 0;
  double squares = 1e300;

  void offer(std::uint16_t plane, double found) noexcept {
    if (found < squares) {
      squares = found;
      label = plane;
    }
  }
};

/// The labels of one level; a block of 2x2 cells lies in one coarser cell and shares what is around, where
/// planes are taken for flat.
struct Level {
  const DepthCells& cells;
  std::span<const BentPlane> planes;
  const PlaneGate& gate;
  const CellLabels& labels;
  int level;

  LabelsAround around(std::int32_t x, std::int32_t y) const noexcept {
    if (level + 1 == DepthCells::levels) return {};
    return LabelsAround(cells.size(level + 1), labels[static_cast<std::size_t>(level) + 1], x / 2, y / 2);
  }
  std::uint16_t label_of(const InverseDepthMoments& cell, const LabelsAround& near,
                         std::span<const InverseDepthPlane> flat) const noexcept {
    const double q = cell.q / cell.n;
    const double noise = gate.inverse_noise(q);
    const double unit = cell.n * noise * noise;
    Best best;
    for (std::size_t k = 0; k < near.count; ++k) best.offer(near.labels[k], squared_residuals(cell, flat[k]));
    if (best.squares < pure_of_neighbour[static_cast<std::size_t>(level)] * unit) return best.label;
    const double u = cell.u / cell.n, v = cell.v / cell.n;
    for (std::size_t k = 0; k < planes.size(); ++k) {
      // The squares are at least those of the means: a plane far from them cannot become the cell's.
      const double off = q - planes[k].at(u, v);
      if (off * off > 2 * pure * noise * noise) continue;
      best.offer(static_cast<std::uint16_t>(k + 1), squared_residuals(cell, planes[k].tangent(u, v)));
    }
    return best.squares < pure * unit ? best.label : std::uint16_t{0};
  }
  /// The plane that the coarser cell of a block and all around it have, if the cell fits it so well that no
  /// part of it can be another's; else 0.
  std::uint16_t inherited(std::int32_t x, std::int32_t y, const LabelsAround& near) const noexcept {
    if (near.count != 1) return 0;
    const std::size_t place = place_of(cells.size(level + 1), x / 2, y / 2);
    const InverseDepthMoments& cell = cells.level(level + 1)[place];
    const std::uint16_t label = labels[static_cast<std::size_t>(level) + 1][place];
    if (label == 0) return 0;
    const double noise = gate.inverse_noise(cell.q / cell.n);
    const InverseDepthPlane plane = planes[label - 1U].tangent(cell.u / cell.n, cell.v / cell.n);
    return squared_residuals(cell, plane) < beyond_doubt * cell.n * noise * noise ? label : std::uint16_t{0};
  }
  void block(std::int32_t x, std::int32_t y) const noexcept {
    const Size size = cells.size(level);
    const LabelsAround near = around(x, y);
    const std::uint16_t given = inherited(x, y, near);
    const std::int32_t side = DepthCells::side << level;
    const double least = least_share * side * side;
    std::array<InverseDepthPlane, 9> flat;
    for (std::size_t k = 0; given == 0 && k < near.count; ++k) {
      flat[k] = planes[near.labels[k] - 1U].tangent((x + 1) * side, (y + 1) * side);
    }
    for (std::int32_t j = y; j < std::min(y + 2, size.height); ++j) {
      for (std::int32_t i = x; i < std::min(x + 2, size.width); ++i) {
        const std::size_t place = place_of(size, i, j);
        const InverseDepthMoments& cell = cells.level(level)[place];
        std::uint16_t label = 0;
        if (cell.n >= least) label = given != 0 ? given : label_of(cell, near, flat);
        labels[static_cast<std::size_t>(level)][place] = label;
      }
    }
  }
};

}  // namespace

void label_cells(const DepthCells& cells, std::span<const BentPlane> planes, const PlaneGate& gate,
                 const CellLabels& labels) noexcept {
  for (int level = DepthCells::levels - 1; level >= 0; --level) {
    const Level work{cells, planes, gate, labels, level};
    const Size size = cells.size(level);
    for (std::int32_t y = 0; y < size.height; y += 2) {
      for (std::int32_t x = 0; x < size.width; x += 2) work.block(x, y);
    }
  }
}

}  // namespace straightedge::detail
