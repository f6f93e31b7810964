// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/block_medians.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace straightedge {
namespace {

constexpr std::int32_t side = 4;
constexpr std::size_t area = 16;

std::uint8_t median_of_one(GrayView gray, std::int32_t left, std::int32_t top, Size block) {
  std::array<std::uint8_t, area> values{};
  const std::int32_t count = block.width * block.height;
  for (std::int32_t k = 0; k < count; ++k)
    values[static_cast<std::size_t>(k)] = gray.at(left + k % block.width, top + k / block.width);
  const auto middle = values.begin() + count / 2;
  std::nth_element(values.begin(), middle, values.begin() + count);
  return *middle;
}

}  // namespace

void block_medians(GrayView gray, std::int32_t top, Size block, const PictureRowKernels& kernels,
                   std::vector<std::uint8_t>& medians) {
  if (block.width == side && block.height == side) {
    const std::uint8_t* const rows[side] = {gray.row(top), gray.row(top + 1), gray.row(top + 2),
                                            gray.row(top + 3)};
    kernels.block_medians(rows, static_cast<std::int32_t>(medians.size()), medians.data());
    return;
  }
  for (std::size_t i = 0; i < medians.size(); ++i)
    medians[i] = median_of_one(gray, static_cast<std::int32_t>(i) * block.width, top, block);
}

}  // namespace straightedge
