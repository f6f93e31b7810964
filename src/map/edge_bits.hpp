// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "straightedge/image.hpp"

namespace straightedge {

/// Lines of bits in the memory of somebody else.
struct BitLinesView {
  std::uint64_t* words = nullptr;
  std::size_t words_in_line = 0;

  std::uint64_t* line(std::int32_t k) const noexcept {
    return words + static_cast<std::size_t>(k) * words_in_line;
  }
  void set(std::int32_t k, std::int32_t m) const noexcept { word_of(k, m) |= bit(m); }
  void clear(std::int32_t k, std::int32_t m) const noexcept { word_of(k, m) &= ~bit(m); }

 private:
  static std::uint64_t bit(std::int32_t m) noexcept {
    return std::uint64_t{1} << static_cast<std::uint32_t>(m) % 64;
  }
  std::uint64_t& word_of(std::int32_t k, std::int32_t m) const noexcept {
    return line(k)[static_cast<std::uint32_t>(m) / 64];
  }
};

/// Lines of bits, with a word more behind each.
class BitLines {
 public:
  void reset(std::int32_t lines, std::int32_t length) {
    words_in_line_ = static_cast<std::size_t>(length) / 64 + 2;
    words_.assign(static_cast<std::size_t>(lines) * words_in_line_, 0);
  }
  BitLinesView view() noexcept { return {words_.data(), words_in_line_}; }
  const std::uint64_t* line(std::int32_t k) const noexcept {
    return words_.data() + static_cast<std::size_t>(k) * words_in_line_;
  }

 private:
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

  bool contains(std::int32_t x, std::int32_t y) const noexcept { return part(rows_.line(y), x, 1) != 0; }

  /// Where none of the word was set.
  void set_word(std::int32_t number, std::int32_t y, std::uint64_t bits) noexcept {
    rows_.view().line(y)[number] = bits;
    const BitLinesView columns = columns_.view();
    for (; bits != 0; bits &= bits - 1) columns.set(64 * number + std::countr_zero(bits), y);
  }
  void set(std::int32_t x, std::int32_t y) noexcept {
    rows_.view().set(y, x);
    columns_.view().set(x, y);
  }
  void clear(std::int32_t x, std::int32_t y) noexcept {
    rows_.view().clear(y, x);
    columns_.view().clear(x, y);
  }

  /// Rows (not steep: columns).
  BitLinesView lines(bool steep) noexcept { return (steep ? rows_ : columns_).view(); }

  /// Of a line, `count` places from `from` on, at most 63, in the lowest bits. Places before the first have
  /// none, not more than 63; `from` lies before the last.
  static std::uint64_t part(const std::uint64_t* line, std::int32_t from, std::int32_t count) noexcept {
    const std::uint64_t wanted = (std::uint64_t{1} << count) - 1;
    if (from < 0) return line[0] << -from & wanted;
    const auto place = static_cast<std::uint32_t>(from);
    const std::uint64_t* const word = line + place / 64;
    return (word[0] >> place % 64 | word[1] << 1 << (63 - place % 64)) & wanted;
  }

  /// Calls visit(m) for the edge pixels m of row k (not steep: column k) in that part of it.
  template <class Visit>
  void for_each(bool steep, std::int32_t k, std::int32_t from, std::int32_t count,
                const Visit& visit) const noexcept {
    const std::uint64_t* const line = (steep ? rows_ : columns_).line(k);
    for (std::uint64_t bits = part(line, from, count); bits != 0; bits &= bits - 1)
      visit(from + std::countr_zero(bits));
  }

 private:
  Size size_;
  BitLines rows_, columns_;
};

}  // namespace straightedge
