// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/edge_table.hpp"

#include <cstddef>

namespace straightedge {

void EdgePoints::find(GrayView edges, const GradientField& field, const KernelSet& kernels) {
  constexpr std::size_t beyond = 8;  // that the kernel may write behind the row's last column
  if (numbers_.size() != edges.size()) numbers_ = Image<std::uint32_t>::for_overwrite(edges.size());
  points_.clear();
  std::vector<std::uint16_t> columns(static_cast<std::size_t>(edges.width) + beyond);
  GradientField bare = field;
  bare.table = nullptr;
  for (std::int32_t y = 0; y < edges.height; ++y) {
    const std::int32_t count = kernels.hough->edge_columns(edges.row(y), edges.width, columns.data());
    std::uint32_t* const numbers = numbers_.view().row(y);
    for (std::int32_t i = 0; i < count; ++i) {
      const std::int32_t x = columns[static_cast<std::size_t>(i)];
      numbers[x] = static_cast<std::uint32_t>(points_.size());
      points_.push_back(edge_point(bare, x, y));
    }
  }
  table_ = {numbers_, points_.data()};
}

}  // namespace straightedge
