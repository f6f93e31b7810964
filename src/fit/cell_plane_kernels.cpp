// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "base/lanes.hpp"
#include "depth_cell_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

constexpr float in_a_row = 1.0F / 64;

struct CellLanes {
  Lanes n, u, v, q, uu, uv, vv, uq, vq, qq;

  explicit CellLanes(const float* first, std::ptrdiff_t apart) noexcept
      : n(load(first)),
        u(load(first + apart)),
        v(load(first + 2 * apart)),
        q(load(first + 3 * apart)),
        uu(load(first + 4 * apart)),
        uv(load(first + 5 * apart)),
        vv(load(first + 6 * apart)),
        uq(load(first + 7 * apart)),
        vq(load(first + 8 * apart)),
        qq(load(first + 9 * apart)) {}

  /// Residual of the means from surface k.
  Lanes off(const DepthSurfaces& s, std::int32_t k) const noexcept {
    const Lanes bend = (s.xx[k] * (u * u) + s.xy[k] * (u * v)) + s.yy[k] * (v * v);
    return q - (((s.c[k] + s.x[k] * u) + s.y[k] * v) + bend);
  }
  /// Squared residuals of all readings from surface k.
  Lanes squares(const DepthSurfaces& s, std::int32_t k) const noexcept {
    // What a search proposes is flat.
    const bool is_flat = (s.xx[k] == 0) & (s.xy[k] == 0) & (s.yy[k] == 0);
    if (is_flat) return squares_of(q - ((s.c[k] + s.x[k] * u) + s.y[k] * v), s.x[k], s.y[k]);
    const Lanes a = (s.x[k] + (2 * s.xx[k]) * u) + s.xy[k] * v;
    const Lanes b = (s.y[k] + s.xy[k] * u) + (2 * s.yy[k]) * v;
    return squares_of(off(s, k), a, b);
  }
  /// From the residual of the means and the slopes.
  template <class Slope>
  Lanes squares_of(const Lanes& r, const Slope& a, const Slope& b) const noexcept {
    const Lanes none = all(0), mixed = a * uq + b * vq;
    const Lanes square = a * (a * uu + (b + b) * uv) + (b * b) * vv;
    const Lanes sum = n * (r * r) + ((qq - (mixed + mixed)) + square);
    return sum < none ? none : sum;
  }
  /// Those that some plane may come nearer than a limit: the squared residuals of its own best one are below.
  Marks is_flat(const Lanes& limit) const noexcept {
    const Lanes product = uu * vv, determinant = product - uv * uv;
    const Lanes explained = uq * (uq * vv - vq * uv) + vq * (vq * uu - uq * uv);
    // Readings nearly in a row tell nothing.
    return (determinant <= product * in_a_row) | ((qq - limit) * determinant <= explained);
  }
};

#if STRAIGHTEDGE_LANES == 1
Marks marks_of(std::uint32_t bits, std::int32_t first) noexcept {
  return (bits >> static_cast<std::uint32_t>(first) & 1U) != 0;
}
#else
/// From a bit for each cell.
Marks marks_of(std::uint32_t bits, std::int32_t first) noexcept {
  constexpr std::int32_t each[DepthCellTask::cells] = {1,       1 << 1,  1 << 2,  1 << 3, 1 << 4,  1 << 5,
                                                       1 << 6,  1 << 7,  1 << 8,  1 << 9, 1 << 10, 1 << 11,
                                                       1 << 12, 1 << 13, 1 << 14, 1 << 15};
  Marks bit;
  std::memcpy(&bit, each + first, sizeof bit);
  return ((Marks{} + static_cast<std::int32_t>(bits)) & bit) != Marks{};
}
#endif

struct Best {
  Lanes squares, label;

  void offer(const Lanes& found, const Marks& mark, std::int32_t plane) noexcept {
    const auto better = (found < squares) & mark;
    squares = better ? found : squares;
    label = better ? all(static_cast<float>(plane + 1)) : label;
  }
};

/// Worth a question where a cell comes alone.
bool is_far([[maybe_unused]] const Lanes& off, [[maybe_unused]] const Lanes& limit) noexcept {
#if STRAIGHTEDGE_LANES == 1
  return off * off > limit;
#else
  return false;
#endif
}

/// What some of the sixteen cells take.
void choose_some(const DepthCellTask& task, const DepthSurfaces& s, std::int32_t first,
                 DepthCellPlanes& planes) noexcept {
  const Lanes none = all(0), one = all(1), zero_noise = all(task.noise);
  const CellLanes cell(task.at.first + first, task.at.apart);
  const Lanes of_square = task.noise_of_square * (cell.q * cell.q);
  const Lanes noise = of_square > zero_noise ? of_square : zero_noise;
  const Lanes variance = noise * noise, unit = cell.n * variance;
  const Marks open = (cell.n >= all(task.least)) & marks_of(task.open, first);
  Best best{all(1e30F), none};
  for (std::int32_t i = 0; i < task.asked; ++i) {
    const std::uint32_t some = (task.of[i] >> static_cast<std::uint32_t>(first)) & ((1U << lanes) - 1U);
    if (some == 0) continue;
    best.offer(cell.squares(s, task.plane[i]), marks_of(task.of[i], first), task.plane[i]);
  }
  const Marks pure = (best.squares < task.pure_of_asked * unit) | marks_of(task.given, first);
  const Marks left = open & (pure == Marks{}) & cell.is_flat(task.pure_of_asked * unit);
  if (task.planes > 0 && any(left)) {
    // The squares are at least those of the means: a plane far from these cannot become a cell's.
    const Lanes limit = task.pure * variance;
    for (std::int32_t k = 0; k < task.planes; ++k) {
      if (is_far(cell.off(s, k), limit)) continue;
      best.offer(cell.squares(s, k), left, k);
    }
  }
  const auto fits = task.planes > 0 ? pure | (best.squares < task.pure * unit) : pure;
  const Lanes otherwise = task.planes > 0 ? none : left ? all(DepthCellPlanes::undecided) : none;
  best.label = fits ? best.label : otherwise;
  best.label = open ? best.label : none;
  const Lanes mean = best.squares / (unit > none ? unit : one);
  float labels[lanes];
  store(labels, best.label);
  for (std::int32_t i = 0; i < lanes; ++i) planes.label[first + i] = static_cast<std::uint16_t>(labels[i]);
  store(planes.mean + first, mean);
}

}  // namespace

void choose_planes(const DepthCellTask& task, const DepthSurfaces& surfaces,
                   DepthCellPlanes& planes) noexcept {
  for (std::int32_t first = 0; first < DepthCellTask::cells; first += lanes) {
    if ((task.open >> static_cast<std::uint32_t>(first) & ((1U << lanes) - 1U)) == 0) {
      for (std::int32_t i = 0; i < lanes; ++i) {
        planes.label[first + i] = 0;
        planes.mean[first + i] = 0;
      }
      continue;
    }
    choose_some(task, surfaces, first, planes);
  }
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
