// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "hough/part_kernels.hpp"

namespace straightedge {
namespace STRAIGHTEDGE_KERNEL_SET {
namespace {

using Word = unsigned long;  // as wide as the machine's own, on most: no result depends on it
constexpr std::int32_t pixels_in_byte = 4;
constexpr std::int32_t bytes_in_word = sizeof(Word);

/// The states of as many pixels as a word holds, or fewer, the first in the lowest bits.
inline Word word_of(const std::uint8_t* states, std::int32_t bytes) noexcept {
  Word word = 0;
  for (std::int32_t k = 0; k < bytes; ++k) word |= Word{states[k]} << (8 * k);
  return word;
}

/// Appends the columns of a word's pixels. Most words have few: four steps at a time need one branch.
inline std::int32_t list_word(Word word, std::int32_t x, std::uint16_t* columns,
                              std::int32_t count) noexcept {
  constexpr Word end = Word{1} << (8 * bytes_in_word - 1);  // no pixel's bit
  while (word != 0) {
    for (std::int32_t k = 0; k < 4; ++k) {
      columns[count] = static_cast<std::uint16_t>(x + __builtin_ctzl(word | end) / 2);
      count += word != 0 ? 1 : 0;
      word &= word - 1;
    }
  }
  return count;
}

}  // namespace

void mark_edges(const std::uint8_t* row, std::int32_t width, std::uint8_t* __restrict states) noexcept {
  const std::int32_t whole = width / pixels_in_byte;
  for (std::int32_t k = 0; k < whole; ++k) {
    const std::uint8_t* const four = row + pixels_in_byte * k;
    states[k] = static_cast<std::uint8_t>((four[0] != 0 ? 1 : 0) | (four[1] != 0 ? 4 : 0) |
                                          (four[2] != 0 ? 16 : 0) | (four[3] != 0 ? 64 : 0));
  }
  if (whole * pixels_in_byte == width) return;
  std::uint32_t last = 0;
  for (std::int32_t x = whole * pixels_in_byte; x < width; ++x)
    last |= (row[x] != 0 ? 1U : 0U) << (2 * (x % pixels_in_byte));
  states[whole] = static_cast<std::uint8_t>(last);
}

std::int32_t marked_columns(const std::uint8_t* states, std::int32_t width, std::uint16_t* columns) noexcept {
  const std::int32_t bytes = (width + pixels_in_byte - 1) / pixels_in_byte;
  const std::int32_t whole = bytes / bytes_in_word * bytes_in_word;
  std::int32_t count = 0;
  for (std::int32_t k = 0; k < whole; k += bytes_in_word)
    count = list_word(word_of(states + k, bytes_in_word), pixels_in_byte * k, columns, count);
  return list_word(word_of(states + whole, bytes - whole), pixels_in_byte * whole, columns, count);
}

std::int32_t edge_columns(const std::uint8_t* row, std::int32_t width, std::uint16_t* columns) noexcept {
  constexpr std::int32_t piece = 256;
  std::uint8_t states[piece / pixels_in_byte];
  std::int32_t count = 0;
  for (std::int32_t first = 0; first < width; first += piece) {
    const std::int32_t some = width - first < piece ? width - first : piece;
    mark_edges(row + first, some, states);
    const std::int32_t more = marked_columns(states, some, columns + count);
    for (std::int32_t i = count; i < count + more; ++i)
      columns[i] = static_cast<std::uint16_t>(columns[i] + first);
    count += more;
  }
  return count;
}

}  // namespace STRAIGHTEDGE_KERNEL_SET
}  // namespace straightedge
