// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "rename_labels.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace straightedge::detail {
namespace {

/// Labels that are not in `changed` stay.
void rename_some(std::span<std::uint16_t> row, std::span<const std::uint16_t> changed,
                 std::span<const std::uint16_t> by) noexcept {
  constexpr std::size_t at_once = 128;
  std::array<std::uint16_t, at_once> before;
  for (std::size_t x = 0; x < row.size(); x += at_once) {
    std::uint16_t* labels = row.data() + x;
    const std::size_t width = std::min(at_once, row.size() - x);
    std::copy(labels, labels + width, before.begin());
    for (const std::uint16_t from : changed) {
      const std::uint16_t to = by[from];
      for (std::size_t i = 0; i < width; ++i) labels[i] = before[i] == from ? to : labels[i];
    }
  }
}

/// Cells [left, right) of a row; none where right is not above left.
struct Part {
  std::int32_t left, right;

  void add(const Part& other) noexcept {
    left = std::min(left, other.left);
    right = std::max(right, other.right);
  }
};

/// The part of row y that holds all cells whose label changes.
Part changing(const LabelCells& cells, std::span<const std::uint16_t> by, std::int32_t y) noexcept {
  Part part{cells.size.width, 0};
  if (y < 0 || y >= cells.size.height) return part;
  const std::uint16_t* row = cells.labels.data() + static_cast<std::ptrdiff_t>(y) * cells.size.width;
  const auto changes = [&](std::int32_t x) noexcept { return by[row[x]] != row[x]; };
  std::int32_t left = 0, right = cells.size.width;
  while (left < right && !changes(left)) ++left;
  while (right > left && !changes(right - 1)) --right;
  if (left < right) part = {left, right};
  return part;
}

}  // namespace

void rename(std::span<std::uint16_t> cells, std::span<const std::uint16_t> by) noexcept {
  constexpr std::size_t at_once = 16;
  std::uint16_t* next = cells.data();
  for (; cells.size() >= at_once; cells = cells.subspan(at_once), next += at_once) {
    // All are read before any is written: then a processor need not ask whether a name was changed.
    std::array<std::uint16_t, at_once> some;
    for (std::size_t i = 0; i < at_once; ++i) some[i] = by[next[i]];
    std::copy(some.begin(), some.end(), next);
  }
  for (std::uint16_t& cell : cells) cell = by[cell];
}

bool changes_nothing(std::span<const std::uint16_t> by) noexcept {
  for (std::size_t label = 0; label < by.size(); ++label) {
    if (by[label] != label) return false;
  }
  return true;
}

void rename(ImageView<std::uint16_t> labels, const LabelCells& cells,
            std::span<const std::uint16_t> by) noexcept {
  constexpr std::size_t few = 3;
  std::array<std::uint16_t, few> changed;
  std::size_t count = 0;
  for (std::size_t label = 0; label < by.size(); ++label) {
    if (by[label] == label) continue;
    if (count < few) changed[count] = static_cast<std::uint16_t>(label);
    ++count;
  }
  if (count == 0) return;
  Part above = changing(cells, by, -1), here = changing(cells, by, 0);
  for (std::int32_t cell = 0; cell < cells.size.height; ++cell) {
    const Part below = changing(cells, by, cell + 1);
    Part part = above;
    part.add(here);
    part.add(below);
    above = here;
    here = below;
    if (part.left >= part.right) continue;
    const std::int32_t left = std::max<std::int32_t>(part.left - 1, 0) * cells.side,
                       right = std::min((part.right + 1) * cells.side, labels.width),
                       bottom = std::min((cell + 1) * cells.side, labels.height);
    for (std::int32_t y = cell * cells.side; y < bottom; ++y) {
      const std::span<std::uint16_t> row(labels.row(y) + left, static_cast<std::size_t>(right - left));
      if (count > few) {
        rename(row, by);
      } else {
        rename_some(row, std::span(changed).first(count), by);
      }
    }
  }
}

}  // namespace straightedge::detail
