// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "straightedge/image.hpp"

namespace straightedge::detail {

/// The entry of two planes in a table of pairs.
inline std::uint32_t& of_pair(std::span<std::uint32_t> contacts, std::size_t i, std::size_t j) noexcept {
  const std::size_t low = std::min(i, j), high = std::max(i, j);
  return contacts[high * (high - 1) / 2 + low];
}

/// How many pairs of neighbouring cells belong to planes i and j.
void count_contacts(Size size, std::span<const std::uint16_t> labels,
                    std::span<std::uint32_t> contacts) noexcept;

/// The pairs of neighbouring cells of each two planes, counted when they are asked for.
struct Contacts {
  Size size;
  std::span<const std::uint16_t> labels;
  std::span<std::uint32_t> table;
  std::size_t i = 0, j = 0;  ///< the planes in question
  bool counted = false;

  std::uint32_t of(std::size_t a, std::size_t b) noexcept {
    if (!counted) count_contacts(size, labels, table);
    counted = true;
    return of_pair(table, a, b);
  }
};

}  // namespace straightedge::detail
