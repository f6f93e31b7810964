// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
// Same result as ../row_words.cpp; read that first.
#ifdef STRAIGHTEDGE_KERNEL_SET
#include <cstddef>
#include <cstring>

#include "canny/fast/lanes.hpp"
#include "canny/fast/row_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

void pack_classes(const std::uint8_t* classes, std::uint8_t* words, std::int32_t width) noexcept {
  for (std::int32_t x = 0; x < width; x += 64, words += 16) {
    const std::uint64_t word[2] = {bits_above_0(classes + x), bits_above_1(classes + x)};
    std::memcpy(words, word, sizeof word);
  }
}

std::uint32_t spread_edges(const std::uint8_t* words, std::uint8_t* edges, std::int32_t width) noexcept {
  std::uint32_t count = 0;
  for (std::int32_t x = (width - 1) / 64 * 64; x >= 0; x -= 64) {
    std::uint64_t word = 0;
    std::memcpy(&word, words + x / 4 + 8, sizeof word);
    count += count_of(word);
    if (width - x >= 64) {
      spread_bits(word, edges + x);
      continue;
    }
    std::uint8_t pixels[64];
    spread_bits(word, pixels);
    std::memcpy(edges + x, pixels, static_cast<std::size_t>(width - x));
  }
  return count;
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
#endif
