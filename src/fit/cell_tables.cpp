// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cell_tables.hpp"

#include <algorithm>

namespace straightedge::detail {
namespace {

/// Whether four labels equal the four from `other` on.
bool same_four(const std::uint16_t* labels, const std::uint16_t* other) noexcept {
  return std::equal(labels, labels + 4, other);
}

}  // namespace

void count_contacts(Size size, std::span<const std::uint16_t> labels,
                    std::span<std::uint32_t> contacts) noexcept {
  std::fill(contacts.begin(), contacts.end(), 0U);
  const auto count = [&](std::uint16_t a, std::uint16_t b) noexcept {
    if (a != b && a != 0 && b != 0) ++of_pair(contacts, a - 1U, b - 1U);
  };
  const std::uint16_t* row = labels.data();
  for (std::int32_t y = 0; y < size.height; ++y, row += size.width) {
    const std::uint16_t* below = y + 1 < size.height ? row + size.width : row;
    for (std::int32_t x = 0; x < size.width; ++x) {
      // Nearly everywhere nothing changes.
      while (x + 4 < size.width && same_four(row + x, row + x + 1) && same_four(row + x, below + x)) x += 4;
      if (x + 1 < size.width) count(row[x], row[x + 1]);
      count(row[x], below[x]);
    }
  }
}

void count_cells(std::span<const std::uint16_t> labels, std::span<std::uint32_t> first,
                 std::span<std::uint32_t> count) noexcept {
  std::fill(count.begin(), count.end(), 0U);
  for (std::size_t i = 0; i < labels.size();) {
    const std::size_t begin = i;
    const std::uint16_t label = labels[i++];
    // As the one before, four at a time.
    while (i + 4 < labels.size() && same_four(labels.data() + i, labels.data() + i - 1)) i += 4;
    while (i < labels.size() && labels[i] == label) ++i;
    if (label == 0) continue;
    if (count[label - 1U] == 0) first[label - 1U] = static_cast<std::uint32_t>(begin);
    count[label - 1U] += static_cast<std::uint32_t>(i - begin);
  }
}

}  // namespace straightedge::detail
