// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cell_labels.hpp"

#include <algorithm>

namespace straightedge::detail {
namespace {

// A cell is a plane's when the mean square of its residuals is below so many variances of the noise.
// One for pure noise; a small cell's readings share their noise, so that its mean square strays further.
constexpr double pure = 2;
constexpr std::array<double, DepthCells::levels> pure_of_neighbour{4, 3, 2, 2};

// Cells with fewer readings than this share of their pixels are left to the next finer level.
constexpr double least_share = 0.2;

struct Best {
  std::uint16_t label = 0;
  double squares = 1e300;

  void offer(std::uint16_t plane, const InverseDepthMoments& cell,
             std::span<const BentPlane> planes) noexcept {
    const double found =
        squared_residuals(cell, planes[plane - 1U].tangent(cell.u / cell.n, cell.v / cell.n));
    if (found < squares) {
      squares = found;
      label = plane;
    }
  }
};

/// The different planes of the 3x3 cells around one of a coarser level.
struct Around {
  std::array<std::uint16_t, 9> labels{};
  std::size_t count = 0;

  Around(Size size, std::span<const std::uint16_t> of_cells, std::int32_t x, std::int32_t y) noexcept {
    const std::int32_t left = std::max(x - 1, 0), right = std::min(x + 1, size.width - 1);
    for (std::int32_t j = std::max(y - 1, 0); j <= std::min(y + 1, size.height - 1); ++j) {
      const std::uint16_t* row = of_cells.data() + static_cast<std::ptrdiff_t>(j) * size.width;
      for (std::int32_t i = left; i <= right; ++i) add(row[i]);
    }
  }
  void add(std::uint16_t label) noexcept {
    if (label == 0 || (count > 0 && labels[count - 1] == label)) return;
    for (std::size_t k = 0; k + 1 < count; ++k) {
      if (labels[k] == label) return;
    }
    labels[count++] = label;
  }
};

std::uint16_t label_of(const InverseDepthMoments& cell, std::span<const std::uint16_t> around,
                       const PlaneGate& gate, int level, std::span<const BentPlane> planes) noexcept {
  const double noise = gate.inverse_noise(cell.q / cell.n);
  const double unit = cell.n * noise * noise;
  Best best;
  for (const std::uint16_t label : around) best.offer(label, cell, planes);
  if (best.squares < pure_of_neighbour[static_cast<std::size_t>(level)] * unit) return best.label;
  for (std::size_t k = 1; k <= planes.size(); ++k) best.offer(static_cast<std::uint16_t>(k), cell, planes);
  return best.squares < pure * unit ? best.label : std::uint16_t{0};
}

/// The labels of one level; a block of 2x2 cells lies in one coarser cell and shares what is around.
struct Level {
  const DepthCells& cells;
  std::span<const BentPlane> planes;
  const PlaneGate& gate;
  const CellLabels& labels;
  int level;

  void block(std::int32_t x, std::int32_t y) const noexcept {
    const Size size = cells.size(level);
    const bool coarsest = level + 1 == DepthCells::levels;
    const Around around =
        coarsest ? Around({}, {}, 0, 0)
                 : Around(cells.size(level + 1), labels[static_cast<std::size_t>(level) + 1], x / 2, y / 2);
    const std::int32_t side = DepthCells::side << level;
    const double least = least_share * side * side;
    for (std::int32_t j = y; j < std::min(y + 2, size.height); ++j) {
      for (std::int32_t i = x; i < std::min(x + 2, size.width); ++i) {
        const auto place =
            static_cast<std::size_t>(j) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(i);
        const InverseDepthMoments& cell = cells.level(level)[place];
        std::uint16_t label = 0;
        if (cell.n >= least) {
          label = label_of(cell, std::span(around.labels).first(around.count), gate, level, planes);
        }
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
