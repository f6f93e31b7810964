// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "straightedge/arena.hpp"
#include "straightedge/depth_kernels.hpp"
#include "straightedge/image.hpp"
#include "straightedge/inverse_depth.hpp"
#include "straightedge/status.hpp"

namespace straightedge {

/// Readings of a square of pixels: what their best plane follows from, and for any plane their squared
/// residuals, without looking at the pixels again. Deviations from the means lose nothing in 32 bits.
struct DepthCell {
  float n = 0;                   ///< readings
  float u = 0, v = 0, q = 0;     ///< their means; u and v from the picture's middle
  float uu = 0, uv = 0, vv = 0;  ///< sums of products of deviations from the means
  float uq = 0, vq = 0, qq = 0;
};

/// The sums of a cell's readings, counted from where the middle is at (middle_u, middle_v).
constexpr InverseDepthMoments moments_of(const DepthCell& cell, double middle_u, double middle_v) noexcept {
  const auto number = [](float x) noexcept { return static_cast<double>(x); };
  const double n = number(cell.n), q = number(cell.q);
  const double u = number(cell.u) + middle_u, v = number(cell.v) + middle_v;
  if (!(n > 0)) return {};
  return {n,
          n * u,
          n * v,
          n * u * u + number(cell.uu),
          n * u * v + number(cell.uv),
          n * v * v + number(cell.vv),
          n * q,
          n * u * q + number(cell.uq),
          n * v * q + number(cell.vq),
          n * q * q + number(cell.qq)};
}

constexpr DepthCell cell_at(const DepthCellRows& r) noexcept {
  return {r.first[0],           r.first[r.apart],     r.first[2 * r.apart], r.first[3 * r.apart],
          r.first[4 * r.apart], r.first[5 * r.apart], r.first[6 * r.apart], r.first[7 * r.apart],
          r.first[8 * r.apart], r.first[9 * r.apart]};
}

/// All cells of one level from those of the next finer one, `from` of them.
void join_cells(const DepthCellRows& fine, Size from, const DepthCellRows& coarse,
                const DepthKernels& kernels) noexcept;

/// The picture of inverse depth as cells of 4, 8, 16 and 32 pixels: a pyramid.
///
/// 1. The sums of 1, u, v, uu, uv, vv, q, uq, vq, qq over the readings of each cell of 4x4 pixels (of the
///    finest level that is wanted), and from these means and deviations.
/// 2. Four cells of one level make one of the next.
///
/// One pass over the picture; 40 bytes a cell, 3.4 bytes a pixel in all. Cells at the right and lower border
/// may be cut off.
class DepthCells {
 public:
  static constexpr int levels = 4;
  static constexpr std::int32_t side = 4;  ///< pixels of a cell of level 0

  static constexpr std::int32_t side_of(int level) noexcept { return side << level; }
  static constexpr Size size_of(Size picture, int level) noexcept {
    const std::int32_t pixels = side_of(level);
    return {(picture.width + pixels - 1) / pixels, (picture.height + pixels - 1) / pixels};
  }
  static constexpr std::size_t cell_count(Size cells) noexcept {
    return static_cast<std::size_t>(cells.width) * static_cast<std::size_t>(cells.height);
  }

  /// Takes its memory; an arena that only counts serves too. Levels below `finest` (0 to 2) are left out:
  /// they have no cells.
  constexpr void take(Arena& arena, Size picture, int finest = 0) noexcept {
    finest_ = finest;
    middle_u_ = picture.width / 2.0;
    middle_v_ = picture.height / 2.0;
    for (int level = finest; level < levels; ++level) {
      const auto i = static_cast<std::size_t>(level);
      sizes_[i] = size_of(picture, level);
      // Kernels read sixteen cells at a time.
      const std::size_t apart = cell_count(sizes_[i]) + DepthCellTask::cells;
      rows_[i] = {arena.take<float>(apart * DepthCellRows::kinds).data(), static_cast<std::ptrdiff_t>(apart)};
    }
    counts_ = arena.take<std::uint8_t>(cell_count(size_of(picture, finest)));
  }

  /// Steps 1 and 2. `inverse_depth` has the size given to `take`.
  void build(ImageView<const float> inverse_depth,
             const DepthKernels& kernels = plain_depth_kernels) noexcept;
  /// Step 1 alone for row y of the finest cells, from the rows of the picture that they are made of; step 2
  /// is due when all are done.
  void build_row(ImageView<const float> inverse_depth, std::int32_t y,
                 const DepthKernels& kernels = plain_depth_kernels) noexcept;
  /// Step 2 alone, after cells of the finest level were changed.
  void sum_up(const DepthKernels& kernels = plain_depth_kernels) noexcept;

  int finest() const noexcept { return finest_; }
  double middle_u() const noexcept { return middle_u_; }
  double middle_v() const noexcept { return middle_v_; }
  /// Readings of each cell of the finest level, 255 at most: what is asked most often, in few bytes.
  std::span<std::uint8_t> counts() const noexcept { return counts_; }
  Size size(int level) const noexcept { return sizes_[static_cast<std::size_t>(level)]; }
  /// The cells from a place on, counted row by row.
  DepthCellRows rows(int level, std::size_t place) const noexcept {
    const DepthCellRows& all = rows_[static_cast<std::size_t>(level)];
    return {all.first + place, all.apart};
  }
  DepthCell at(int level, std::size_t place) const noexcept { return cell_at(rows(level, place)); }
  void set(int level, std::size_t place, const DepthCell& cell) noexcept;
  /// The sums of a cell's readings, u and v from pixel (0, 0).
  InverseDepthMoments moments(int level, std::size_t place) const noexcept {
    return moments_of(at(level, place), middle_u_, middle_v_);
  }

 private:
  int finest_ = 0;
  double middle_u_ = 0, middle_v_ = 0;
  std::span<std::uint8_t> counts_;
  std::array<Size, levels> sizes_{};
  std::array<DepthCellRows, levels> rows_{};
};

namespace detail {

/// Arrays for so many surfaces.
constexpr DepthSurfaces take_surfaces(Arena& arena, std::size_t count) noexcept {
  DepthSurfaces s;
  for (float** coefficient : {&s.c, &s.x, &s.y, &s.xx, &s.xy, &s.yy}) {
    *coefficient = arena.take<float>(count).data();
  }
  return s;
}

}  // namespace detail

/// A plane, or a surface that is bent a little, in 32 bits: c + x X + y Y + xx X² + xy X Y + yy Y², X and Y
/// from the picture's middle.
struct DepthSurface {
  float c = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
};

constexpr float value_at(const DepthSurface& s, float u, float v) noexcept {
  return (s.c + s.x * u + s.y * v) + (s.xx * u * u + s.xy * u * v + s.yy * v * v);
}

/// Sum of the squared residuals of a cell's readings from a surface, taken for flat over the cell, 1/metre².
constexpr float squared_residuals(const DepthCell& cell, const DepthSurface& s) noexcept {
  const float a = (s.x + 2 * s.xx * cell.u) + s.xy * cell.v;
  const float b = (s.y + s.xy * cell.u) + 2 * s.yy * cell.v;
  const float r = cell.q - value_at(s, cell.u, cell.v);
  const float mixed = a * cell.uq + b * cell.vq;
  const float square = a * (a * cell.uu + 2 * b * cell.uv) + b * b * cell.vv;
  const float sum = cell.n * r * r + ((cell.qq - 2 * mixed) + square);
  return sum < 0 ? 0 : sum;  // a surface whose residuals are no number fits nothing
}

}  // namespace straightedge
