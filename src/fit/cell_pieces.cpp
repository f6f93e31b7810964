// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cell_pieces.hpp"

#include <algorithm>
#include <utility>

#include "base/lowest_bit.hpp"
#include "four_labels.hpp"

namespace straightedge::detail {
namespace {

// Longer ones are cut in parts.
constexpr std::int32_t longest_run = 0xFFFF;

}  // namespace

std::int32_t CellPieces::root(std::int32_t run) const noexcept {
  while (at(run) >= 0) {
    // On the way every second one is led past the next.
    const std::int32_t next = at(run);
    if (at(next) >= 0) at(run) = at(next);
    run = next;
  }
  return run;
}

void CellPieces::join(std::int32_t a, std::int32_t b) const noexcept {
  a = root(a);
  b = root(b);
  if (a == b) return;
  if (at(a) > at(b)) std::swap(a, b);  // to the piece with more cells
  at(a) += at(b);
  at(b) = a;
}

void CellPieces::find_runs(std::int32_t row) const noexcept {
  const std::int32_t last = row + size.width - 1;
  std::int32_t begin = row;
  const auto end_at = [&](std::int32_t end) noexcept {
    const std::int32_t first = begin;
    for (; begin < end; begin += length[static_cast<std::size_t>(begin)]) {
      const std::int32_t part = std::min(end - begin, longest_run);
      length[static_cast<std::size_t>(begin)] = static_cast<std::uint16_t>(part);
      at(begin) = -part;
      if (begin > first) join(first, begin);
    }
  };
  std::int32_t i = row;
  for (; i + 4 <= last; i += 4) {
    const std::uint16_t* here = labels.data() + i;
    std::uint32_t ends = lowest_of(not_zero(four(here) ^ four(here + 1)) >> 15U);
    for (; ends != 0; ends &= ends - 1) end_at(i + static_cast<std::int32_t>(lowest_bit(ends)) + 1);
  }
  for (; i < last; ++i) {
    if (label_at(i) != label_at(i + 1)) end_at(i + 1);
  }
  end_at(last + 1);
}

/// The runs of a row with those above.
void CellPieces::join_rows(std::int32_t row) const noexcept {
  const std::int32_t width = size.width;
  for (std::int32_t above = row - width, here = row; here < row + width;) {
    const std::uint16_t label = label_at(here);
    if (label != 0 && label == label_at(above)) join(above, here);
    const std::int32_t above_end = end_of(above) + width, end = end_of(here);
    if (above_end <= end) above = above_end - width;
    if (end <= above_end) here = end;
  }
}

void CellPieces::find() const noexcept {
  for (std::int32_t row = 0; row < size.width * size.height; row += size.width) {
    find_runs(row);
    if (row > 0) join_rows(row);
  }
}

}  // namespace straightedge::detail
