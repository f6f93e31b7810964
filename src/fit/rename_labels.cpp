// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "rename_labels.hpp"

#include <algorithm>
#include <cstddef>

namespace straightedge::detail {
namespace {

/// Cells [left, right) of a row; none where right is not above left.
struct Part {
  std::int32_t left, right;

  void add(const Part& other) noexcept {
    left = std::min(left, other.left);
    right = std::max(right, other.right);
  }
};

/// The part of row y that holds all cells whose label changes.
Part changing(const LabelCells& cells, std::span<const std::uint16_t> by, std::int32_t y) noexcept {
  Part part{cells.size.width, 0};
  if (y < 0 || y >= cells.size.height) return part;
  const std::uint16_t* row = cells.labels.data() + static_cast<std::ptrdiff_t>(y) * cells.size.width;
  const auto changes = [&](std::int32_t x) noexcept { return by[row[x]] != row[x]; };
  std::int32_t left = 0, right = cells.size.width;
  while (left < right && !changes(left)) ++left;
  while (right > left && !changes(right - 1)) --right;
  if (left < right) part = {left, right};
  return part;
}

}  // namespace

void rename(std::span<std::uint16_t> cells, std::span<const std::uint16_t> by,
            const DepthKernels& kernels) noexcept {
  kernels.rename_row(cells.data(), static_cast<std::int32_t>(cells.size()), by.data(),
                     static_cast<std::int32_t>(by.size()));
}

bool changes_nothing(std::span<const std::uint16_t> by) noexcept {
  for (std::size_t label = 0; label < by.size(); ++label) {
    if (by[label] != label) return false;
  }
  return true;
}

void rename(ImageView<std::uint16_t> labels, const LabelCells& cells, std::span<const std::uint16_t> by,
            const DepthKernels& kernels) noexcept {
  if (changes_nothing(by)) return;
  Part above = changing(cells, by, -1), here = changing(cells, by, 0);
  for (std::int32_t cell = 0; cell < cells.size.height; ++cell) {
    const Part below = changing(cells, by, cell + 1);
    Part part = above;
    part.add(here);
    part.add(below);
    above = here;
    here = below;
    if (part.left >= part.right) continue;
    const std::int32_t left = std::max<std::int32_t>(part.left - 1, 0) * cells.side,
                       right = std::min((part.right + 1) * cells.side, labels.width),
                       bottom = std::min((cell + 1) * cells.side, labels.height);
    for (std::int32_t y = cell * cells.side; y < bottom; ++y) {
      const std::span<std::uint16_t> row(labels.row(y) + left, static_cast<std::size_t>(right - left));
      rename(row, by, kernels);
    }
  }
}

}  // namespace straightedge::detail
