// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace straightedge {

/// Classes of edges, 64 pixels at a time, the leftmost in the lowest bit.
struct EdgeWord {
  std::uint64_t kept = 0;   ///< weak or strong
  std::uint64_t edges = 0;  ///< strong, and later all that hangs together with it

  static constexpr std::size_t bytes = 16;

  static EdgeWord load(const std::uint8_t* at) noexcept {
    EdgeWord word;
    std::memcpy(&word.kept, at, 8);
    std::memcpy(&word.edges, at + 8, 8);
    return word;
  }
  void store(std::uint8_t* at) const noexcept {
    std::memcpy(at, &kept, 8);
    std::memcpy(at + 8, &edges, 8);
  }
};

/// Rows of such words, anywhere in memory and at any distance: they fit into the rows of the picture that the
/// edges go to, unless it is very narrow.
struct EdgeWords {
  std::uint8_t* first = nullptr;
  std::ptrdiff_t stride = 0;  ///< bytes from one row to the next
  std::int32_t words = 0;     ///< in a row
  std::int32_t height = 0;

  /// Some of the rows.
  EdgeWords rows(std::int32_t begin, std::int32_t end) const noexcept {
    return {row(begin), stride, words, end - begin};
  }
  std::int32_t row_bytes() const noexcept { return static_cast<std::int32_t>(EdgeWord::bytes) * words; }
  std::uint8_t* row(std::int32_t y) const noexcept { return first + stride * y; }
  std::uint8_t* at(std::int32_t i, std::int32_t y) const noexcept {
    return row(y) + static_cast<std::ptrdiff_t>(EdgeWord::bytes) * i;
  }
};

}  // namespace straightedge
