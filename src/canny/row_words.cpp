// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>

#include "canny/edge_words.hpp"
#include "canny/row_kernels.hpp"
#include "straightedge/suppress.hpp"

namespace straightedge::plain {
namespace {

constexpr std::uint64_t lowest_bits = 0x0101010101010101U;

// Eight bytes, the first the lowest on every machine.
std::uint64_t load_eight_bytes(const std::uint8_t* bytes) noexcept {
  std::uint64_t word = 0;
  std::memcpy(&word, bytes, sizeof word);
  if constexpr (std::endian::native == std::endian::big) word = __builtin_bswap64(word);
  return word;
}

// The lowest bits of eight bytes as eight bits: the product brings each to its place in the highest byte, and
// no two meet.
std::uint64_t eight_bits(std::uint64_t bytes) noexcept {
  return (bytes * 0x0102040810204080U) >> 56U;
}

// The other way: each byte keeps one bit of the eight and becomes 255 if it is set.
std::uint64_t eight_bytes(std::uint64_t bits) noexcept {
  const std::uint64_t own = ((bits & 0xFFU) * lowest_bits) & 0x8040201008040201U;
  return (((own + 0x7F7F7F7F7F7F7F7FU) | own) >> 7U & lowest_bits) * 255U;
}

std::uint32_t count_bits(std::uint64_t word) noexcept {
  word -= (word >> 1U) & 0x5555555555555555U;
  word = (word & 0x3333333333333333U) + ((word >> 2U) & 0x3333333333333333U);
  return static_cast<std::uint32_t>((((word + (word >> 4U)) & 0x0F0F0F0F0F0F0F0FU) * lowest_bits) >> 56U);
}

void spread(std::uint64_t edges, std::uint8_t* pixels) noexcept {
  for (unsigned k = 0; k < 8; ++k) {
    std::uint64_t eight = eight_bytes(edges >> (8 * k));
    if constexpr (std::endian::native == std::endian::big) eight = __builtin_bswap64(eight);
    std::memcpy(pixels + 8 * k, &eight, sizeof eight);
  }
}

}  // namespace

void pack_classes(const std::uint8_t* classes, std::uint8_t* words, std::int32_t width) noexcept {
  static_assert(weak_edge == 1 && strong_edge == 2);
  for (std::int32_t x = 0; x < width; x += 64, words += EdgeWord::bytes) {
    EdgeWord word;
    for (unsigned k = 0; k < 8; ++k) {
      const std::uint64_t eight = load_eight_bytes(classes + x + 8 * k);
      if (eight == 0) continue;
      const std::uint64_t strong = (eight >> 1U) & lowest_bits;
      word.kept |= eight_bits((eight & lowest_bits) | strong) << (8 * k);
      word.edges |= eight_bits(strong) << (8 * k);
    }
    word.store(words);
  }
}

std::uint32_t spread_edges(const std::uint8_t* words, std::uint8_t* edges, std::int32_t width) noexcept {
  std::uint32_t count = 0;
  for (std::int32_t x = (width - 1) / 64 * 64; x >= 0; x -= 64) {
    const std::uint64_t word = EdgeWord::load(words + x / 64 * static_cast<int>(EdgeWord::bytes)).edges;
    count += count_bits(word);
    std::uint8_t pixels[64];
    spread(word, pixels);
    std::memcpy(edges + x, pixels, static_cast<std::size_t>(std::min<std::int32_t>(64, width - x)));
  }
  return count;
}

}  // namespace straightedge::plain
