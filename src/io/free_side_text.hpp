// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "straightedge/host/line_map.hpp"

namespace straightedge::io {

/// The value of the attribute `free`; empty for unknown, when the attribute is left out.
constexpr const char* to_text(FreeSide side) noexcept {
  switch (side) {
    case FreeSide::unknown:
      return "";
    case FreeSide::plus:
      return "+";
    case FreeSide::minus:
      return "-";
    case FreeSide::both:
      return "both";
  }
  return "";
}

constexpr std::optional<FreeSide> free_side_from_text(std::string_view text) noexcept {
  for (const FreeSide side : {FreeSide::plus, FreeSide::minus, FreeSide::both}) {
    if (text == to_text(side)) return side;
  }
  return {};
}

}  // namespace straightedge::io
