// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cell_labels.hpp"

#include <algorithm>
#include <bit>

#include "labels_around.hpp"

namespace straightedge::detail {
namespace {

// A cell is a plane's when the mean square of its residuals is below so many variances of the noise.
// One for pure noise; a small cell's readings share their noise, so that its mean square strays further.
constexpr double pure = 2;
constexpr std::array<double, DepthCells::levels> pure_of_neighbour{4, 3, 2, 2};

// Cells with fewer readings than this share of their pixels are left to the next finer level.
constexpr double least_share = 0.2;

// A cell below this leaves no doubt about the smaller ones in it; one below the other not even about those in
// these.
constexpr double beyond_doubt = 1;
constexpr double settled_below = 0.75;
// A plane that all of a cell is further from than this is nowhere near it.
constexpr double far_away = 16;
constexpr std::uint16_t settled = LabelsAround::mark;
constexpr std::size_t most_planes = 256;

double least_readings(int level) noexcept {
  const std::int32_t side = DepthCells::side_of(level);
  return least_share * side * side;
}

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

/// What the coarser cell of a block says about it.
struct Inherited {
  std::uint16_t label = 0;
  bool settles = false;
};

/// The labels of one level; a block of 2x2 cells lies in one coarser cell and shares what is around, where
/// planes are taken for flat.
struct Level {
  const CellLabeller& work;
  const DepthSurfaces& surfaces;  ///< of the planes
  double middle_u, middle_v;
  const CellLabels& labels;
  int level;

  std::span<std::uint16_t> labels_of(int which) const noexcept {
    return labels[static_cast<std::size_t>(which)];
  }
  LabelsAround around(std::int32_t x, std::int32_t y) const noexcept {
    if (level + 1 == DepthCells::levels) return {};
    return LabelsAround(work.cells.size(level + 1), labels_of(level + 1), x / 2, y / 2);
  }
  std::uint16_t label_of(const InverseDepthMoments& cell, const LabelsAround& near,
                         std::span<const InverseDepthPlane> flat) const noexcept {
    const double q = cell.q / cell.n;
    const double noise = work.gate.inverse_noise(q);
    const double unit = cell.n * noise * noise;
    Best best;
    for (std::size_t k = 0; k < near.count; ++k) best.offer(near.labels[k], squared_residuals(cell, flat[k]));
    if (best.squares < pure_of_neighbour[static_cast<std::size_t>(level)] * unit) return best.label;
    offer_all(cell, noise, best);
    return best.squares < pure * unit ? best.label : std::uint16_t{0};
  }
  void offer_all(const InverseDepthMoments& cell, double noise, Best& best) const noexcept {
    const double u = cell.u / cell.n, v = cell.v / cell.n;
    // The squares are at least those of the means: a plane far from them cannot become the cell's.
    std::array<std::uint32_t, most_planes / DepthSurfaces::step> near;
    work.kernels.near(surfaces, static_cast<float>(u - middle_u), static_cast<float>(v - middle_v),
                      static_cast<float>(cell.q / cell.n), static_cast<float>(2 * pure * noise * noise),
                      near.data());
    const auto rows = static_cast<std::size_t>(surfaces.count / DepthSurfaces::step);
    for (std::size_t row = 0; row < rows; ++row) {
      for (std::uint32_t bits = near[row]; bits != 0; bits &= bits - 1) {
        const std::size_t k = row * DepthSurfaces::step + static_cast<std::size_t>(std::countr_zero(bits));
        best.offer(static_cast<std::uint16_t>(k + 1), squared_residuals(cell, work.planes[k].tangent(u, v)));
      }
    }
  }
  /// The plane of the coarser cell of a block, if it fits so well, and the others around so badly, that no
  /// part of the cell can be another's; else 0.
  Inherited inherited(std::int32_t x, std::int32_t y, const LabelsAround& near) const noexcept {
    if (near.count == 0) return {};
    const std::size_t place = place_of(work.cells.size(level + 1), x / 2, y / 2);
    const InverseDepthMoments& cell = work.cells.level(level + 1)[place];
    const std::uint16_t label = labels_of(level + 1)[place];
    if (label == 0) return {};
    const double u = cell.u / cell.n, v = cell.v / cell.n;
    const double noise = work.gate.inverse_noise(cell.q / cell.n), unit = cell.n * noise * noise;
    const double squares = squared_residuals(cell, work.planes[label - 1U].tangent(u, v));
    const bool settles = squares < settled_below * unit;
    if (!settles && (near.count > 1 || !(squares < beyond_doubt * unit))) return {};
    for (std::size_t k = 0; near.count > 1 && k < near.count; ++k) {
      if (near.labels[k] == label) continue;
      const InverseDepthPlane other = work.planes[near.labels[k] - 1U].tangent(u, v);
      if (!(squared_residuals(cell, other) > far_away * unit)) return {};
    }
    return {label, settles};
  }
  /// Gives the label to a block, and to the smallest cells in it.
  void settle(std::int32_t x, std::int32_t y, std::uint16_t label) const noexcept {
    for_square(level, x, y, 2, [&](std::size_t place) noexcept {
      labels_of(level)[place] = static_cast<std::uint16_t>(label | settled);
    });
    const auto least = static_cast<std::int32_t>(least_readings(level - 1));
    const std::uint8_t* counts = work.cells.counts().data();
    std::uint16_t* out = labels_of(level - 1).data();
    for_square(level - 1, 2 * x, 2 * y, 4, [=](std::size_t place) noexcept {
      out[place] = counts[place] > least ? label : std::uint16_t{0};
    });
  }
  template <class Visit>
  void for_square(int which, std::int32_t x, std::int32_t y, std::int32_t side,
                  const Visit& visit) const noexcept {
    const Size size = work.cells.size(which);
    const std::int32_t right = std::min(x + side, size.width), bottom = std::min(y + side, size.height);
    const auto across = static_cast<std::size_t>(right - x), apart = static_cast<std::size_t>(size.width);
    std::size_t row = place_of(size, x, y);
    for (std::int32_t j = y; j < bottom; ++j, row += apart) {
      for (std::size_t i = 0; i < across; ++i) visit(row + i);
    }
  }
  bool reads(std::size_t place) const noexcept {
    const double least = least_readings(level);
    if (level == work.cells.finest()) return work.cells.counts()[place] >= least;
    return work.cells.level(level)[place].n >= least;
  }
  void block(std::int32_t x, std::int32_t y) const noexcept {
    const LabelsAround near = around(x, y);
    const Inherited given = inherited(x, y, near);
    if (given.settles && level == work.cells.finest() + 1) {
      settle(x, y, given.label);
      return;
    }
    const std::int32_t side = DepthCells::side_of(level);
    std::array<InverseDepthPlane, 9> flat;
    for (std::size_t k = 0; given.label == 0 && k < near.count; ++k) {
      flat[k] = work.planes[near.labels[k] - 1U].tangent((x + 1) * side, (y + 1) * side);
    }
    for_square(level, x, y, 2, [&](std::size_t place) noexcept {
      std::uint16_t label = given.label;
      if (!reads(place)) {
        label = 0;
      } else if (label == 0) {
        label = label_of(work.cells.level(level)[place], near, flat);
      }
      labels_of(level)[place] = label;
    });
  }
  bool is_settled(std::int32_t x, std::int32_t y) const noexcept {
    if (level != work.cells.finest() || level + 1 == DepthCells::levels) return false;
    return (labels_of(level + 1)[place_of(work.cells.size(level + 1), x / 2, y / 2)] & settled) != 0;
  }
};

/// Writes the planes into the arrays; what fills them up is far from everything.
DepthSurfaces fill_surfaces(std::span<const BentPlane> planes, double u0, double v0,
                            const DepthSurfaces& room) noexcept {
  DepthSurfaces s = room;
  const auto count = static_cast<std::int32_t>(planes.size());
  s.count = (count + DepthSurfaces::step - 1) / DepthSurfaces::step * DepthSurfaces::step;
  for (std::int32_t k = 0; k < s.count; ++k) {
    s.c[k] = 1e18F;
    s.x[k] = s.y[k] = s.xx[k] = s.xy[k] = s.yy[k] = 0;
  }
  for (std::int32_t k = 0; k < count; ++k) {
    const BentPlane& plane = planes[static_cast<std::size_t>(k)];
    const InverseDepthPlane flat = plane.tangent(u0, v0);
    s.c[k] = static_cast<float>(plane.at(u0, v0));
    s.x[k] = static_cast<float>(flat.a);
    s.y[k] = static_cast<float>(flat.b);
    s.xx[k] = static_cast<float>(plane.uu);
    s.xy[k] = static_cast<float>(plane.uv);
    s.yy[k] = static_cast<float>(plane.vv);
  }
  return s;
}

}  // namespace

void CellLabeller::label(const CellLabels& labels) const noexcept {
  const Size small = cells.size(cells.finest());
  const double half = DepthCells::side_of(cells.finest()) / 2.0;
  const double middle_u = half * small.width, middle_v = half * small.height;
  const DepthSurfaces filled = fill_surfaces(planes, middle_u, middle_v, surfaces);
  for (int level = DepthCells::levels - 1; level >= cells.finest(); --level) {
    const Level work{*this, filled, middle_u, middle_v, labels, level};
    const Size size = cells.size(level);
    for (std::int32_t y = 0; y < size.height; y += 2) {
      for (std::int32_t x = 0; x < size.width; x += 2) {
        if (!work.is_settled(x, y)) work.block(x, y);
      }
    }
  }
  if (cells.finest() + 1 == DepthCells::levels) return;
  for (std::uint16_t& label : labels[static_cast<std::size_t>(cells.finest()) + 1]) {
    label = static_cast<std::uint16_t>(label & ~settled);
  }
}

}  // namespace straightedge::detail
