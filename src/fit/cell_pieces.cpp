// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cell_pieces.hpp"

#include <utility>

namespace straightedge::detail {

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

/// The runs of a row with those above.
void CellPieces::join_rows(std::int32_t row) const noexcept {
  const std::int32_t width = size.width;
  std::int32_t above = row - width, above_end = end_of_run(above, row);
  for (std::int32_t here = row; here < row + width;) {
    const std::int32_t end = end_of_run(here, row + width);
    if (label_at(here) != 0) at(here) = here - end;
    for (;;) {
      if (label_at(here) != 0 && label_at(above) == label_at(here)) join(above, here);
      if (above_end >= end - width) break;
      above = above_end;
      above_end = end_of_run(above, row);
    }
    if (above_end == end - width && above_end < row) {
      above = above_end;
      above_end = end_of_run(above, row);
    }
    here = end;
  }
}

void CellPieces::find() const noexcept {
  for (std::int32_t begin = 0; begin < size.width;) {
    const std::int32_t end = end_of_run(begin, size.width);
    at(begin) = begin - end;
    begin = end;
  }
  for (std::int32_t row = size.width; row < cells(); row += size.width) join_rows(row);
}

}  // namespace straightedge::detail
