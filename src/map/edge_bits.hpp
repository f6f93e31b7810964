// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "straightedge/image.hpp"

namespace straightedge {

/// Lines of bits, with a word more behind each.
class BitLines {
 public:
  void reset(std::int32_t lines, std::int32_t length) {
    words_in_line_ = static_cast<std::size_t>(length) / 64 + 2;
    words_.assign(static_cast<std::size_t>(lines) * words_in_line_, 0);
  }
  const std::uint64_t* line(std::int32_t k) const noexcept {
    return words_.data() + static_cast<std::size_t>(k) * words_in_line_;
  }
  std::uint64_t& word(std::int32_t k, std::int32_t number) noexcept {
    return words_[static_cast<std::size_t>(k) * words_in_line_ + static_cast<std::size_t>(number)];
  }
  void set(std::int32_t k, std::int32_t m) noexcept { word(k, m / 64) |= bit(m); }
  void clear(std::int32_t k, std::int32_t m) noexcept { word(k, m / 64) &= ~bit(m); }

 private:
  static std::uint64_t bit(std::int32_t m) noexcept { return std::uint64_t{1} << m % 64; }

  std::vector<std::uint64_t> words_;
  std::size_t words_in_line_ = 0;
};

/// Edge pixels as bits along rows and along columns, so that those across a line, flat or steep, are in one
/// word.
class EdgeBits {
 public:
  void reset(Size size) {
    size_ = size;
    rows_.reset(size.height, size.width);
    columns_.reset(size.width, size.height);
  }

  Size size() const noexcept { return size_; }

  /// Rows to go through when a line is steep, columns when it is not; and pixels in each.
  std::int32_t steps(bool steep) const noexcept { return steep ? size_.height : size_.width; }
  std::int32_t places(bool steep) const noexcept { return steep ? size_.width : size_.height; }

  /// Sixty-four pixels of row y, from column 64 * number on, the leftmost in the lowest bit.
  std::uint64_t word(std::int32_t number, std::int32_t y) const noexcept { return rows_.line(y)[number]; }

  bool contains(std::int32_t x, std::int32_t y) const noexcept {
    return (word(x / 64, y) >> x % 64 & 1) != 0;
  }

  /// Where none of the word was set.
  void set_word(std::int32_t number, std::int32_t y, std::uint64_t bits) noexcept {
    rows_.word(y, number) = bits;
    for (; bits != 0; bits &= bits - 1) columns_.set(64 * number + std::countr_zero(bits), y);
  }
  void set(std::int32_t x, std::int32_t y) noexcept {
    rows_.set(y, x);
    columns_.set(x, y);
  }
  void clear(std::int32_t x, std::int32_t y) noexcept {
    rows_.clear(y, x);
    columns_.clear(x, y);
  }

  /// Calls visit(m) for the edge pixels m of row k (not steep: column k), `count` places from `from` on, at
  /// most 63. Places before the first have none; `from` lies before the last.
  template <class Visit>
  void for_each(bool steep, std::int32_t k, std::int32_t from, std::int32_t count,
                const Visit& visit) const noexcept {
    const std::uint64_t* const line = steep ? rows_.line(k) : columns_.line(k);
    std::uint64_t wanted = (std::uint64_t{1} << count) - 1;
    if (from < 0) {
      wanted >>= -from;
      from = 0;
    }
    const std::uint64_t* const word = line + from / 64;
    const int shift = from % 64;
    for (std::uint64_t bits = (word[0] >> shift | word[1] << 1 << (63 - shift)) & wanted; bits != 0;
         bits &= bits - 1)
      visit(from + std::countr_zero(bits));
  }

 private:
  Size size_;
  BitLines rows_, columns_;
};

}  // namespace straightedge
