// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "straightedge/arena.hpp"
#include "straightedge/depth_cells_cell.hpp"
#include "straightedge/depth_kernels.hpp"
#include "straightedge/image.hpp"
#include "straightedge/inverse_depth.hpp"
#include "straightedge/status.hpp"

namespace straightedge {

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
  /// Where cell (x, y) is among so many.
  static constexpr std::size_t place_of(Size cells, std::int32_t x, std::int32_t y) noexcept {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(cells.width) + static_cast<std::size_t>(x);
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
  /// The same row by row, from the first to the last: row y of the finest cells, from the rows of the picture
  /// that they are made of, and the larger cells that are whole with it.
  void build_row(ImageView<const float> inverse_depth, std::int32_t y,
                 const DepthKernels& kernels = plain_depth_kernels) noexcept;
  /// Step 2 alone, after cells of rows [top, bottom) of the finest level were changed.
  void sum_up(std::int32_t top, std::int32_t bottom,
              const DepthKernels& kernels = plain_depth_kernels) noexcept;

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
  void join_up(std::int32_t y, const DepthKernels& kernels) noexcept;

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

}  // namespace straightedge
