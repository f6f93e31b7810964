// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "straightedge/image.hpp"

namespace straightedge::ransac {

/// The labels of all readings, a frame's row by row, a cloud's in one row. Without data nobody asks for them
/// and none is looked at: the search is for one plane.
struct Labels {
  std::uint16_t* data = nullptr;
  std::size_t width = 0, height = 0;
  std::ptrdiff_t row_bytes = 0;

  bool kept() const noexcept { return data != nullptr; }
  std::uint16_t* row(std::size_t v) const noexcept {
    return reinterpret_cast<std::uint16_t*>(reinterpret_cast<unsigned char*>(data) +
                                            static_cast<std::ptrdiff_t>(v) * row_bytes);
  }
  bool free(std::size_t column, std::size_t v) const noexcept { return !kept() || row(v)[column] == 0; }
  /// Changes every label: `changed(old)`.
  template <class Changed>
  void change(Changed changed) const noexcept {
    if (!kept()) return;
    for (std::size_t v = 0; v < height; ++v) {
      std::uint16_t* const here = row(v);
      for (std::size_t u = 0; u < width; ++u) here[u] = changed(here[u]);
    }
  }
};

}  // namespace straightedge::ransac
