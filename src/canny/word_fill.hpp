// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "canny/edge_words.hpp"

namespace straightedge {

/// Hysteresis in place, 64 pixels at a time, with a worklist of any size: `edges` of each word becomes what
/// hangs together with it through `kept`.
///
/// To grow a word is to add the kept pixels next to an edge, in the word itself or in the eight around it,
/// and the runs of kept pixels that those belong to.
///   1. Down, row by row, while the words are still in the cache: grow each word of a row as soon as the
///      words of the row below are there. Most edges are whole after this.
///   2. Sweep up, in every row from left to right: grow every word that can.
///   3. When a word has grown, those around it that can now grow, and that the sweep has passed already, go
///      onto the worklist.
///   4. Take a word from the worklist and grow it. Until it is empty.
///   5. If the worklist was full, sweep again over the rows of the words that found no place.
/// What is reached does not depend on the order. A word that grows sends eight others onto the worklist at
/// most, so before every sweep but the first `worklist` / 8 words had grown, or more: at most 1 + 8 edges /
/// worklist sweeps.
class WordFill {
 public:
  WordFill(const EdgeWords& words, std::span<std::uint32_t> worklist) noexcept
      : words_(words), worklist_(worklist) {}

  /// Step 1 for row y: all rows, from the first to the last.
  void flow_down(std::int32_t y) noexcept;
  /// The other steps, when all words that can grow are in rows begin to end − 1: after step 1 these are all
  /// rows.
  void sweep_up(std::int32_t begin, std::int32_t end) noexcept;

 private:
  void sweep_row() noexcept;
  void grow(std::int32_t i, std::int32_t y, std::uint64_t open, std::uint64_t seeds) noexcept;
  void offer(std::uint64_t added, std::int32_t i, std::int32_t y) noexcept;
  void offer_word(std::uint64_t near, std::int32_t i, std::int32_t y) noexcept;
  void push(std::int32_t i, std::int32_t y) noexcept;
  void empty_worklist() noexcept;

  EdgeWords words_;
  std::span<std::uint32_t> worklist_;
  std::size_t waiting_ = 0;
  std::int32_t sweep_y_ = 0;
  std::int32_t sweep_i_ = 0;
  std::int32_t sweep_begin_ = 0;
  std::int32_t left_begin_ = 0;  ///< rows of words that found no place on the worklist
  std::int32_t left_end_ = 0;
};

}  // namespace straightedge
