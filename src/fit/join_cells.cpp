// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
// Step 2 of depth_cells.hpp.
#include <algorithm>
#include <array>
#include <cstddef>

#include "straightedge/depth_cells.hpp"

namespace straightedge {
namespace {

/// Up to two rows of up to two cells that make one at the picture's border.
struct CornerCells {
  std::array<float, std::size_t{4} * DepthCellRows::kinds> of{};

  CornerCells(const DepthCellRows& from, std::int32_t width, std::int32_t across,
              std::int32_t down) noexcept {
    for (std::ptrdiff_t kind = 0; kind < DepthCellRows::kinds; ++kind) {
      for (std::int32_t y = 0; y < down; ++y) {
        for (std::int32_t x = 0; x < across; ++x) {
          of[static_cast<std::size_t>(4 * kind + 2 * y + x)] = from.first[kind * from.apart + y * width + x];
        }
      }
    }
  }
  DepthCellRows rows() noexcept { return {of.data(), 4}; }
};

}  // namespace

void join_cells(const DepthCellRows& fine, Size from, const DepthCellRows& coarse,
                const DepthKernels& kernels) noexcept {
  const Size to{(from.width + 1) / 2, (from.height + 1) / 2};
  const auto at = [](const DepthCellRows& all, std::size_t place) noexcept {
    return DepthCellRows{all.first + place, all.apart};
  };
  for (std::int32_t y = 0; y < to.height; ++y) {
    const std::int32_t down = std::min<std::int32_t>(2, from.height - 2 * y),
                       whole = down == 2 ? from.width / 2 : 0;
    kernels.join_cells(at(fine, DepthCells::place_of(from, 0, 2 * y)), from.width, whole,
                       at(coarse, DepthCells::place_of(to, 0, y)));
    for (std::int32_t x = whole; x < to.width; ++x) {
      CornerCells corner(at(fine, DepthCells::place_of(from, 2 * x, 2 * y)), from.width,
                         std::min<std::int32_t>(2, from.width - 2 * x), down);
      kernels.join_cells(corner.rows(), 2, 1, at(coarse, DepthCells::place_of(to, x, y)));
    }
  }
}

void DepthCells::join_up(std::int32_t y, const DepthKernels& kernels) noexcept {
  // While the rows of cells are in the processor's nearest memory.
  for (int fine = finest_; fine + 1 < levels; ++fine, y /= 2) {
    const Size from = size(fine), to = size(fine + 1);
    const bool is_last = y + 1 == from.height;
    if (y % 2 == 0 && !is_last) return;
    const std::int32_t top = y / 2 * 2;
    join_cells(rows(fine, place_of(from, 0, top)), {from.width, y + 1 - top},
               rows(fine + 1, place_of(to, 0, y / 2)), kernels);
  }
}

void DepthCells::sum_up(std::int32_t top, std::int32_t bottom, const DepthKernels& kernels) noexcept {
  for (int fine = finest_; fine + 1 < levels; ++fine) {
    const Size from = size(fine), to = size(fine + 1);
    top /= 2;
    bottom = (bottom + 1) / 2;
    const Size band{from.width, std::min(2 * bottom, from.height) - 2 * top};
    join_cells(rows(fine, place_of(from, 0, 2 * top)), band, rows(fine + 1, place_of(to, 0, top)), kernels);
  }
}

}  // namespace straightedge
