// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "canny/word_fill.hpp"

#include <algorithm>
#include <cstddef>

namespace straightedge {
namespace {

// Runs of `open` pixels that touch `seeds`, which are some of them.
std::uint64_t runs_at(std::uint64_t open, std::uint64_t seeds) noexcept {
  // To the right: the carry of an addition runs from the lowest seed to the end of the run.
  std::uint64_t filled = open & (~(open + seeds) | seeds);
  // To the left in steps that double: of 1, 2, 4 ... 32 pixels.
  for (unsigned step = 1; step < 64; step *= 2) {
    filled |= open & (filled >> step);
    open &= open >> step;
  }
  return filled;
}

class WordFill {
 public:
  WordFill(const EdgeWords& words, std::span<std::uint32_t> worklist) noexcept
      : words_(words), worklist_(worklist) {}

  // Steps 1 and 4.
  void run() noexcept {
    std::int32_t begin = 0;
    sweep_end_ = words_.height;
    while (begin < sweep_end_) {
      left_begin_ = words_.height;
      left_end_ = 0;
      for (sweep_y_ = begin; sweep_y_ < sweep_end_; ++sweep_y_) {
        for (sweep_i_ = 0; sweep_i_ < words_.words; ++sweep_i_) {
          if (grow(sweep_i_, sweep_y_)) empty_worklist();
        }
      }
      begin = left_begin_;
      sweep_end_ = left_end_;
    }
  }

 private:
  bool grow(std::int32_t i, std::int32_t y) noexcept {
    std::uint8_t* const at = words_.at(i, y);
    EdgeWord word = EdgeWord::load(at);
    const std::uint64_t open = word.kept & ~word.edges;
    if (open == 0) return false;
    const std::uint64_t seeds = open & around(at, i, y);
    if (seeds == 0) return false;
    const std::uint64_t added = runs_at(open, seeds);
    word.edges |= added;
    word.store(at);
    offer(added, i, y);
    return true;
  }

  // Step 2.
  void offer(std::uint64_t added, std::int32_t i, std::int32_t y) noexcept {
    const std::uint64_t near = added | (added << 1U) | (added >> 1U);
    const std::int32_t top = std::max<std::int32_t>(y - 1, 0), bottom = std::min(y + 1, words_.height - 1);
    for (std::int32_t v = top; v <= bottom; ++v) {
      if (v != y) offer_word(near, i, v);
      if ((added & 1U) != 0 && i > 0) offer_word(std::uint64_t{1} << 63U, i - 1, v);
      if ((added >> 63U) != 0 && i + 1 < words_.words) offer_word(1, i + 1, v);
    }
  }

  void offer_word(std::uint64_t near, std::int32_t i, std::int32_t y) noexcept {
    const bool ahead = y == sweep_y_ ? i > sweep_i_ : y > sweep_y_ && y < sweep_end_;
    if (ahead) return;  // this sweep will come by
    const EdgeWord word = EdgeWord::load(words_.at(i, y));
    if ((word.kept & ~word.edges & near) != 0) push(i, y);
  }

  // Edges of three rows and the pixels next to them.
  std::uint64_t around(const std::uint8_t* at, std::int32_t i, std::int32_t y) const noexcept {
    std::uint64_t near = beside(at, i);
    if (y > 0) near |= beside(at - words_.stride, i);
    if (y + 1 < words_.height) near |= beside(at + words_.stride, i);
    return near;
  }

  std::uint64_t beside(const std::uint8_t* at, std::int32_t i) const noexcept {
    constexpr auto step = static_cast<std::ptrdiff_t>(EdgeWord::bytes);
    const std::uint64_t edges = EdgeWord::load(at).edges;
    std::uint64_t near = edges | (edges << 1U) | (edges >> 1U);
    if (i > 0) near |= EdgeWord::load(at - step).edges >> 63U;
    if (i + 1 < words_.words) near |= EdgeWord::load(at + step).edges << 63U;
    return near;
  }

  void push(std::int32_t i, std::int32_t y) noexcept {
    if (waiting_ < worklist_.size()) {
      const auto index = static_cast<std::size_t>(y) * static_cast<std::size_t>(words_.words);
      worklist_[waiting_++] = static_cast<std::uint32_t>(index + static_cast<std::size_t>(i));
      return;
    }
    left_begin_ = std::min(left_begin_, y);
    left_end_ = std::max(left_end_, y + 1);
  }

  // Step 3.
  void empty_worklist() noexcept {
    const auto length = static_cast<std::uint32_t>(words_.words);
    while (waiting_ > 0) {
      const std::uint32_t index = worklist_[--waiting_];
      const std::uint32_t y = index / length;
      grow(static_cast<std::int32_t>(index - y * length), static_cast<std::int32_t>(y));
    }
  }

  EdgeWords words_;
  std::span<std::uint32_t> worklist_;
  std::size_t waiting_ = 0;
  std::int32_t sweep_y_ = 0;
  std::int32_t sweep_i_ = 0;
  std::int32_t sweep_end_ = 0;
  std::int32_t left_begin_ = 0;  ///< rows of words that found no place on the worklist
  std::int32_t left_end_ = 0;
};

}  // namespace

void fill_words(const EdgeWords& words, std::span<std::uint32_t> worklist) noexcept {
  WordFill(words, worklist).run();
}

}  // namespace straightedge
