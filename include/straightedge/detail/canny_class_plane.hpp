// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "straightedge/image.hpp"

// Classes of edges at two bits a pixel: sixteen pixels a word, the leftmost in the lowest bits. Each row
// begins with a word of its own and ends with one pixel or more that are always none, and so are a row above
// the picture and one below: neighbours can be looked at without asking where the picture ends.
namespace straightedge::detail {

constexpr std::size_t class_words_in_row(std::int32_t width) noexcept {
  return (static_cast<std::size_t>(width) + 16) / 16;
}

/// One word more, because three neighbours are read from two words.
constexpr std::size_t class_words_in_all(Size size) noexcept {
  return class_words_in_row(size.width) * (static_cast<std::size_t>(size.height) + 2) + 1;
}

}  // namespace straightedge::detail
