// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cell_tables.hpp"

#include <algorithm>

#include "base/lowest_bit.hpp"
#include "four_labels.hpp"

namespace straightedge::detail {
namespace {

constexpr std::int32_t at_once = 16;

/// Bit i: cell i touches the other of its place. Both are some plane's, and not the same.
std::uint32_t bits_of_touching(const std::uint16_t* labels, const std::uint16_t* others) noexcept {
  std::uint32_t touching = 0;
  for (std::int32_t i = 0; i < at_once; i += 4) {
    const std::uint64_t a = four(labels + i), b = four(others + i);
    touching |= lowest_of((not_zero(a) & not_zero(b) & not_zero(a ^ b)) >> 15U) << i;
  }
  return touching;
}

}  // namespace

void count_contacts(Size size, std::span<const std::uint16_t> labels,
                    std::span<std::uint32_t> contacts) noexcept {
  std::fill(contacts.begin(), contacts.end(), 0U);
  const auto count = [&](std::uint16_t a, std::uint16_t b) noexcept {
    if (a != b && a != 0 && b != 0) ++of_pair(contacts, a - 1U, b - 1U);
  };
  const auto count_sixteen = [&](const std::uint16_t* a, const std::uint16_t* b) noexcept {
    for (std::uint32_t some = bits_of_touching(a, b); some != 0; some &= some - 1) {
      const std::uint32_t i = lowest_bit(some);
      ++of_pair(contacts, a[i] - 1U, b[i] - 1U);
    }
  };
  const std::uint16_t* row = labels.data();
  for (std::int32_t y = 0; y < size.height; ++y, row += size.width) {
    const std::uint16_t* below = y + 1 < size.height ? row + size.width : row;
    std::int32_t x = 0;
    for (; x + at_once < size.width; x += at_once) {
      count_sixteen(row + x, row + x + 1);
      count_sixteen(row + x, below + x);
    }
    for (; x < size.width; ++x) {
      if (x + 1 < size.width) count(row[x], row[x + 1]);
      count(row[x], below[x]);
    }
  }
}

}  // namespace straightedge::detail
