// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cell_tables.hpp"

#include <algorithm>

#include "base/lowest_bit.hpp"
#include "four_labels.hpp"

namespace straightedge::detail {
namespace {

/// The top bit of each that touches the other of its place: both are some plane's, and not the same.
constexpr std::uint64_t touching(std::uint64_t labels, std::uint64_t others) noexcept {
  return not_zero(labels) & not_zero(others) & not_zero(labels ^ others);
}

}  // namespace

void count_contacts(Size size, std::span<const std::uint16_t> labels,
                    std::span<std::uint32_t> contacts) noexcept {
  std::fill(contacts.begin(), contacts.end(), 0U);
  const auto count = [&](std::uint16_t a, std::uint16_t b) noexcept {
    if (a != b && a != 0 && b != 0) ++of_pair(contacts, a - 1U, b - 1U);
  };
  const auto count_touching = [&](std::uint64_t top_bits, const std::uint16_t* a,
                                  const std::uint16_t* b) noexcept {
    for (std::uint32_t some = lowest_of(top_bits >> 15U); some != 0; some &= some - 1) {
      const std::uint32_t i = lowest_bit(some);
      ++of_pair(contacts, a[i] - 1U, b[i] - 1U);
    }
  };
  const std::uint16_t* row = labels.data();
  for (std::int32_t y = 0; y < size.height; ++y, row += size.width) {
    const std::uint16_t* below = y + 1 < size.height ? row + size.width : row;
    std::int32_t x = 0;
    for (; x + 4 < size.width; x += 4) {
      const std::uint64_t here = four(row + x);
      count_touching(touching(here, four(row + x + 1)), row + x, row + x + 1);
      count_touching(touching(here, four(below + x)), row + x, below + x);
    }
    for (; x < size.width; ++x) {
      if (x + 1 < size.width) count(row[x], row[x + 1]);
      count(row[x], below[x]);
    }
  }
}

}  // namespace straightedge::detail
