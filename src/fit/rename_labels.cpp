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

}  // namespace

void rename(std::span<std::uint16_t> cells, std::span<const std::uint16_t> by) noexcept {
  for (std::uint16_t& cell : cells) cell = by[cell];
}

bool changes_nothing(std::span<const std::uint16_t> by) noexcept {
  for (std::size_t label = 0; label < by.size(); ++label) {
    if (by[label] != label) return false;
  }
  return true;
}

void rename(ImageView<std::uint16_t> labels, std::span<const std::uint16_t> by) noexcept {
  constexpr std::size_t few = 3;
  std::array<std::uint16_t, few> changed;
  std::size_t count = 0;
  for (std::size_t label = 0; label < by.size(); ++label) {
    if (by[label] == label) continue;
    if (count < few) changed[count] = static_cast<std::uint16_t>(label);
    ++count;
  }
  if (count == 0) return;
  for (std::int32_t y = 0; y < labels.height; ++y) {
    const std::span<std::uint16_t> row(labels.row(y), static_cast<std::size_t>(labels.width));
    if (count > few) {
      rename(row, by);
    } else {
      rename_some(row, std::span(changed).first(count), by);
    }
  }
}

}  // namespace straightedge::detail
