// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "canny/word_fill.hpp"

#include <algorithm>

#include "canny/fetch_row.hpp"

namespace straightedge {
namespace {

constexpr auto word_step = static_cast<std::ptrdiff_t>(EdgeWord::bytes);

std::uint64_t edges_at(const std::uint8_t* at) noexcept {
  return EdgeWord::load(at).edges;
}

// Pixels that may become edges.
std::uint64_t open_at(const std::uint8_t* at) noexcept {
  const EdgeWord word = EdgeWord::load(at);
  return word.kept & ~word.edges;
}

// A row of words and those above and below it; a row that is not there is the row itself.
class ThreeRows {
 public:
  ThreeRows(const EdgeWords& words, std::int32_t y) noexcept
      : above_(y > 0 ? -words.stride : 0), below_(y + 1 < words.height ? words.stride : 0) {}

  /// Of the word at `at` and of its neighbours above and below.
  std::uint64_t edges(const std::uint8_t* at) const noexcept {
    return edges_at(at) | edges_at(at + above_) | edges_at(at + below_);
  }

 private:
  std::ptrdiff_t above_, below_;
};

// Pixels next to those of the word in the middle, of three in a row.
std::uint64_t beside(std::uint64_t left, std::uint64_t middle, std::uint64_t right) noexcept {
  return middle | (middle << 1U) | (middle >> 1U) | (left >> 63U) | (right << 63U);
}

// Runs of `open` pixels that touch `seeds`, which are some of them, or begin at the lowest bit when `carry`
// is
// 1. It becomes 1 when a run goes on in the word to the right.
std::uint64_t runs_at(std::uint64_t open, std::uint64_t seeds, std::uint64_t& carry) noexcept {
  // To the right: the carry of an addition runs from the lowest seed to the end of the run.
  const std::uint64_t sum = open + seeds, all = sum + carry;
  carry = (sum < open ? 1U : 0U) | (all < sum ? 1U : 0U);
  std::uint64_t filled = open & (~all | seeds);
  // To the left in steps that double: of 1, 2, 4 ... 32 pixels.
  for (unsigned step = 1; step < 64; step *= 2) {
    filled |= open & (filled >> step);
    open &= open >> step;
  }
  return filled;
}

}  // namespace

// Step 1. About one word in three grows, which no processor can foresee: all are grown, most by nothing. From
// one to the next there is only the carry to wait for.
void WordFill::flow_down(std::int32_t y) noexcept {
  const ThreeRows rows(words_, y);
  std::uint8_t* at = words_.at(0, y);
  std::uint64_t left = 0, middle = rows.edges(at), carry = 0;
  for (std::int32_t i = 0; i < words_.words; ++i, at += word_step) {
    const std::uint64_t right = i + 1 < words_.words ? rows.edges(at + word_step) : 0;
    EdgeWord word = EdgeWord::load(at);
    const std::uint64_t open = word.kept & ~word.edges;
    if (open != 0) {
      word.edges |= runs_at(open, open & beside(left, middle, right), carry);
      word.store(at);
    } else {
      carry = 0;
    }
    left = middle;
    middle = right;
  }
}

void WordFill::sweep_up(std::int32_t begin, std::int32_t end) noexcept {
  sweep_begin_ = begin;
  while (sweep_begin_ < end) {
    left_begin_ = words_.height;
    left_end_ = 0;
    for (sweep_y_ = end - 1; sweep_y_ >= sweep_begin_; --sweep_y_) sweep_row();
    sweep_begin_ = left_begin_;
    end = left_end_;
  }
}

// Step 2. Few words are left to grow: what is next to an edge comes from three words of three rows in turn.
void WordFill::sweep_row() noexcept {
  if (sweep_y_ >= fetched_rows_ahead)
    fetch_to_read(words_.row(sweep_y_ - fetched_rows_ahead), words_.row_bytes());
  const ThreeRows rows(words_, sweep_y_);
  const std::uint8_t* at = words_.at(0, sweep_y_);
  std::uint64_t left = 0, middle = rows.edges(at);
  for (sweep_i_ = 0; sweep_i_ < words_.words; ++sweep_i_, at += word_step) {
    const bool last = sweep_i_ + 1 == words_.words;
    std::uint64_t right = last ? 0 : rows.edges(at + word_step);
    const std::uint64_t open = open_at(at);
    const std::uint64_t seeds = open & beside(left, middle, right);
    if (seeds != 0) {
      grow(sweep_i_, sweep_y_, open, seeds);
      empty_worklist();
      middle = rows.edges(at);
      if (!last) right = rows.edges(at + word_step);
    }
    left = middle;
    middle = right;
  }
}

void WordFill::grow(std::int32_t i, std::int32_t y, std::uint64_t open, std::uint64_t seeds) noexcept {
  std::uint8_t* const at = words_.at(i, y);
  EdgeWord word = EdgeWord::load(at);
  std::uint64_t carry = 0;
  const std::uint64_t added = runs_at(open, seeds, carry);
  word.edges |= added;
  word.store(at);
  offer(added, i, y);
}

// Step 3.
void WordFill::offer(std::uint64_t added, std::int32_t i, std::int32_t y) noexcept {
  const std::uint64_t near = beside(0, added, 0);
  const std::uint64_t left = i > 0 ? added << 63U : 0, right = i + 1 < words_.words ? added >> 63U : 0;
  for (std::int32_t v = std::max<std::int32_t>(y - 1, 0); v <= std::min(y + 1, words_.height - 1); ++v) {
    if (v < sweep_y_ && v >= sweep_begin_) continue;  // this sweep will come by
    if (v != y) offer_word(near, i, v);
    if (left != 0) offer_word(left, i - 1, v);
    if (right != 0) offer_word(right, i + 1, v);
  }
}

void WordFill::offer_word(std::uint64_t near, std::int32_t i, std::int32_t y) noexcept {
  if (y == sweep_y_ && i > sweep_i_) return;  // here too
  if ((open_at(words_.at(i, y)) & near) != 0) push(i, y);
}

void WordFill::push(std::int32_t i, std::int32_t y) noexcept {
  if (waiting_ < worklist_.size()) {
    const auto index = static_cast<std::size_t>(y) * static_cast<std::size_t>(words_.words);
    worklist_[waiting_++] = static_cast<std::uint32_t>(index + static_cast<std::size_t>(i));
    return;
  }
  left_begin_ = std::min(left_begin_, y);
  left_end_ = std::max(left_end_, y + 1);
}

// Step 4.
void WordFill::empty_worklist() noexcept {
  const auto length = static_cast<std::uint32_t>(words_.words);
  while (waiting_ > 0) {
    const std::uint32_t index = worklist_[--waiting_];
    const auto y = static_cast<std::int32_t>(index / length);
    const auto i = static_cast<std::int32_t>(index % length);
    const ThreeRows rows(words_, y);
    const std::uint8_t* const at = words_.at(i, y);
    const std::uint64_t left = i > 0 ? rows.edges(at - word_step) : 0;
    const std::uint64_t right = i + 1 < words_.words ? rows.edges(at + word_step) : 0;
    const std::uint64_t open = open_at(at);
    const std::uint64_t seeds = open & beside(left, rows.edges(at), right);
    if (seeds != 0) grow(i, y, open, seeds);
  }
}

}  // namespace straightedge
