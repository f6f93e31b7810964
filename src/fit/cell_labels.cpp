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
  double mean_square = 1e300;

  void offer(std::uint16_t plane, const InverseDepthMoments& cell,
             std::span<const BentPlane> planes) noexcept {
    const double found =
        squared_residuals(cell, planes[plane - 1U].tangent(cell.u / cell.n, cell.v / cell.n));
    if (found < mean_square) {
      mean_square = found;
      label = plane;
    }
  }
};

/// The best of the planes of the 3x3 coarser cells around a cell.
Best best_around(const InverseDepthMoments& cell, std::int32_t x, std::int32_t y, Size coarse,
                 std::span<const std::uint16_t> labels, std::span<const BentPlane> planes) noexcept {
  Best best;
  std::array<std::uint16_t, 9> tried{};
  std::size_t count = 0;
  for (std::int32_t j = std::max(y - 1, 0); j <= std::min(y + 1, coarse.height - 1); ++j) {
    for (std::int32_t i = std::max(x - 1, 0); i <= std::min(x + 1, coarse.width - 1); ++i) {
      const std::uint16_t label =
          labels[static_cast<std::size_t>(j) * static_cast<std::size_t>(coarse.width) +
                 static_cast<std::size_t>(i)];
      if (label == 0) continue;
      const auto end = tried.begin() + static_cast<std::ptrdiff_t>(count);
      if (std::find(tried.begin(), end, label) != end) continue;
      tried[count++] = label;
      best.offer(label, cell, planes);
    }
  }
  return best;
}

std::uint16_t label_of(const InverseDepthMoments& cell, const Best& around, double variance, int level,
                       std::span<const BentPlane> planes) noexcept {
  const double unit = cell.n * variance;
  if (around.mean_square < pure_of_neighbour[static_cast<std::size_t>(level)] * unit) return around.label;
  Best best;
  for (std::size_t k = 1; k <= planes.size(); ++k) best.offer(static_cast<std::uint16_t>(k), cell, planes);
  return best.mean_square < pure * unit ? best.label : std::uint16_t{0};
}

}  // namespace

void label_cells(const DepthCells& cells, std::span<const BentPlane> planes, const PlaneGate& gate,
                 const CellLabels& labels) noexcept {
  for (int level = DepthCells::levels - 1; level >= 0; --level) {
    const Size size = cells.size(level);
    const std::int32_t pixels = DepthCells::side << level;
    const double least = least_share * pixels * pixels;
    const InverseDepthMoments* cell = cells.level(level).data();
    std::uint16_t* label = labels[static_cast<std::size_t>(level)].data();
    for (std::int32_t y = 0; y < size.height; ++y) {
      for (std::int32_t x = 0; x < size.width; ++x, ++cell, ++label) {
        *label = 0;
        if (cell->n < least) continue;
        Best around;
        if (level + 1 < DepthCells::levels) {
          around = best_around(*cell, x / 2, y / 2, cells.size(level + 1),
                               labels[static_cast<std::size_t>(level) + 1], planes);
        }
        const double noise = gate.inverse_noise(cell->q / cell->n);
        *label = label_of(*cell, around, noise * noise, level, planes);
      }
    }
  }
}

}  // namespace straightedge::detail
