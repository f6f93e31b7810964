// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/block_medians.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace straightedge {
namespace {

constexpr std::size_t side = 4;
constexpr std::size_t area = side * side;
constexpr std::size_t lanes = 64;  // blocks that are sorted at the same time

/// One place of each block.
using Lane = std::array<std::uint8_t, lanes>;

void put_in_order(Lane& low, Lane& high) {
  for (std::size_t i = 0; i < lanes; ++i) {
    const std::uint8_t a = low[i], b = high[i];
    low[i] = a < b ? a : b;
    high[i] = a < b ? b : a;
  }
}

/// Batcher's network: it compares the same places whatever is there, so that many blocks go through it
/// together. K. E. Batcher, "Sorting networks and their applications", 1968, doi:10.1145/1468075.1468121.
void sort_places(std::array<Lane, area>& places) {
  for (std::size_t p = 1; p < area; p *= 2) {
    for (std::size_t k = p; k >= 1; k /= 2) {
      for (std::size_t j = k % p; j + k < area; j += 2 * k) {
        for (std::size_t i = 0; i < k && i + j + k < area; ++i) {
          if ((i + j) / (2 * p) == (i + j + k) / (2 * p)) put_in_order(places[i + j], places[i + j + k]);
        }
      }
    }
  }
}

void medians_of_many(GrayView gray, std::int32_t top, std::size_t first, std::size_t count,
                     std::uint8_t* medians) {
  std::array<Lane, area> places{};
  for (std::size_t r = 0; r < side; ++r) {
    const std::uint8_t* const row = gray.row(top + static_cast<std::int32_t>(r)) + side * first;
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t c = 0; c < side; ++c) places[r * side + c][i] = row[side * i + c];
  }
  sort_places(places);
  std::copy_n(places[area / 2].begin(), count, medians);
}

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

void block_medians(GrayView gray, std::int32_t top, Size block, std::vector<std::uint8_t>& medians) {
  if (block.width != static_cast<std::int32_t>(side) || block.height != static_cast<std::int32_t>(side)) {
    for (std::size_t i = 0; i < medians.size(); ++i)
      medians[i] = median_of_one(gray, static_cast<std::int32_t>(i) * block.width, top, block);
    return;
  }
  for (std::size_t first = 0; first < medians.size(); first += lanes) {
    const std::size_t count = std::min(lanes, medians.size() - first);
    medians_of_many(gray, top, first, count, medians.data() + first);
  }
}

}  // namespace straightedge
