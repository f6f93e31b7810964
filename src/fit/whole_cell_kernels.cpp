// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "pixel_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

constexpr std::int32_t at_once = 16;

/// The coefficients of one surface: that of all cells, or one cell's own.
struct OneSurface {
  float c, x, y, xx, xy, yy;

  OneSurface(const DepthSurfaces& s, std::int32_t k) noexcept
      : c(s.c[k]), x(s.x[k]), y(s.y[k]), xx(s.xx[k]), xy(s.xy[k]), yy(s.yy[k]) {}
  const OneSurface& of(std::int32_t /*cell*/) const noexcept { return *this; }
};

/// Where cells have different ones.
struct OwnSurfaces {
  const DepthSurfaces& all;
  const std::int32_t* plane;

  OneSurface of(std::int32_t cell) const noexcept { return {all, plane[cell] > 0 ? plane[cell] : 0}; }
};

/// Some cells and the planes that they have, −1 where they have none.
struct LabelledCells {
  const float* first;
  std::ptrdiff_t apart;
  std::int32_t plane[at_once];
  float squares[at_once];

  LabelledCells(const DepthCellRows& at, std::int32_t place) noexcept
      : first(at.first + place), apart(at.apart) {}
  const float* row(std::ptrdiff_t kind) const noexcept { return first + kind * apart; }

  /// Squared residuals of all readings, as squared_residuals in depth_cells_cell.hpp.
  template <class Surfaces>
  void find_squares(const Surfaces& surfaces, std::int32_t count) noexcept {
    const float *n = row(0), *u = row(1), *v = row(2), *q = row(3), *uu = row(4), *uv = row(5), *vv = row(6),
                *uq = row(7), *vq = row(8), *qq = row(9);
    for (std::int32_t i = 0; i < count; ++i) {
      const OneSurface s = surfaces.of(i);
      const float a = (s.x + 2 * s.xx * u[i]) + s.xy * v[i], b = (s.y + s.xy * u[i]) + 2 * s.yy * v[i];
      const float bend = s.xx * u[i] * u[i] + s.xy * u[i] * v[i] + s.yy * v[i] * v[i];
      const float r = q[i] - ((s.c + s.x * u[i] + s.y * v[i]) + bend);
      const float mixed = a * uq[i] + b * vq[i];
      const float square = a * (a * uu[i] + 2 * b * uv[i]) + b * b * vv[i];
      squares[i] = n[i] * r * r + ((qq[i] - 2 * mixed) + square);
    }
  }
};

}  // namespace

void mark_whole(const DepthWholeCells& task, const DepthSurfaces& surfaces, std::uint16_t* labels) noexcept {
  for (std::int32_t first = 0; first < task.cells; first += at_once) {
    const std::int32_t left = task.cells - first, count = left < at_once ? left : at_once;
    LabelledCells cells(task.at, first);
    std::uint16_t* of = labels + first;
    const std::uint16_t* own = task.own + first;
    std::int32_t greatest = 0, differ = 0;
    for (std::int32_t i = 0; i < count; ++i) {
      const std::int32_t label = of[i] == DepthWholeCells::border ? own[i] : of[i];
      cells.plane[i] = label - 1;
      greatest = label > greatest ? label : greatest;
    }
    if (greatest == 0) continue;
    // What cells without a plane are given does not matter.
    for (std::int32_t i = 0; i < count; ++i)
      differ |= cells.plane[i] < 0 ? 0 : cells.plane[i] ^ (greatest - 1);
    if (differ == 0) {
      cells.find_squares(OneSurface(surfaces, greatest - 1), count);
    } else {
      cells.find_squares(OwnSurfaces{surfaces, cells.plane}, count);
    }
    const float *n = cells.row(0), *q = cells.row(3);
    for (std::int32_t i = 0; i < count; ++i) {
      const float of_square = task.noise_of_square * (q[i] * q[i]);
      const float noise = of_square > task.noise ? of_square : task.noise;
      const bool fits = (cells.squares[i] < task.most * (n[i] * (noise * noise))) & (n[i] == task.readings) &
                        (cells.plane[i] >= 0);
      const std::int32_t whole =
          of[i] == DepthWholeCells::border ? DepthWholeCells::inner_border : of[i] | DepthWholeCells::mark;
      of[i] = static_cast<std::uint16_t>(fits ? whole : of[i]);
    }
  }
}

void spread_labels(const std::uint16_t* cells, std::int32_t side, std::int32_t width,
                   std::uint16_t* __restrict labels) noexcept {
  const auto label_of = [](std::uint16_t state) noexcept {
    const bool is_whole = (state >= DepthWholeCells::mark) & (state < DepthWholeCells::inner_border);
    return is_whole ? static_cast<std::uint16_t>(state & ~DepthWholeCells::mark) : std::uint16_t{0};
  };
  std::int32_t x = 0;
  for (; side == 8 && x + 8 <= width; x += 8) {
    const std::uint16_t label = label_of(*cells++);
    for (std::int32_t i = 0; i < 8; ++i) labels[x + i] = label;
  }
  for (; side == 4 && x + 4 <= width; x += 4) {
    const std::uint16_t label = label_of(*cells++);
    for (std::int32_t i = 0; i < 4; ++i) labels[x + i] = label;
  }
  for (; x < width; x += side) {
    const std::uint16_t label = label_of(*cells++);
    for (std::int32_t i = x; i < x + side && i < width; ++i) labels[i] = label;
  }
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
