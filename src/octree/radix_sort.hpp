// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "straightedge/octree_point.hpp"

namespace straightedge::octree {

/// Sort keys, each with the index of what it belongs to, in words that lie side by side.
class Pairs {
 public:
  struct Pair {
    std::uint32_t key = 0;
    std::uint32_t index = 0;
  };

  Pairs() = default;
  explicit Pairs(std::span<std::uint32_t> words) noexcept : words_(words) {}

  std::size_t size() const noexcept { return words_.size() / 2; }
  Pair operator[](std::size_t i) const noexcept { return {words_[2 * i], words_[2 * i + 1]}; }
  void set(std::size_t i, const Pair& pair) const noexcept {
    words_[2 * i] = pair.key;
    words_[2 * i + 1] = pair.index;
  }
  bool same_memory(const Pairs& other) const noexcept { return words_.data() == other.words_.data(); }

 private:
  std::span<std::uint32_t> words_;
};

/// One pass: counts, starts of the values' places, each pair to its place. Equal digits keep their order.
inline void sort_by_digit(const Pairs& from, const Pairs& to, unsigned shift, unsigned bits,
                          std::span<std::uint32_t> all_counts) noexcept {
  const std::uint32_t mask = (std::uint32_t{1} << bits) - 1;
  const auto digit = [shift, mask](std::uint32_t key) { return key >> shift & mask; };
  const std::span<std::uint32_t> counts = all_counts.first(std::size_t{mask} + 1);
  const std::size_t n = from.size();
  for (std::uint32_t& count : counts) count = 0;
  for (std::size_t i = 0; i < n; ++i) ++counts[digit(from[i].key)];
  std::uint32_t start = 0;
  for (std::uint32_t& count : counts) {
    const std::uint32_t here = count;
    count = start;
    start += here;
  }
  for (std::size_t i = 0; i < n; ++i) {
    const Pairs::Pair pair = from[i];
    to.set(counts[digit(pair.key)]++, pair);
  }
}

/// Stable, by the bits of the key from the lowest to the highest of `varying`, which has every bit of them in
/// which any two keys differ; least significant digit first. Says in which of the two memories the result is.
inline Pairs radix_sort(Pairs pairs, Pairs other, std::uint32_t varying,
                        std::span<std::uint32_t> counts) noexcept {
  constexpr auto most_bits = static_cast<unsigned>(std::countr_zero(octree_sort_values));
  const auto end = static_cast<unsigned>(std::bit_width(varying));
  unsigned at = 0;
  while (at < end) {
    at += static_cast<unsigned>(std::countr_zero(varying >> at));
    const unsigned passes = (end - at + most_bits - 1) / most_bits;
    const unsigned bits = (end - at + passes - 1) / passes;
    sort_by_digit(pairs, other, at, bits, counts);
    const Pairs sorted = other;
    other = pairs;
    pairs = sorted;
    at += bits;
  }
  return pairs;
}

}  // namespace straightedge::octree
