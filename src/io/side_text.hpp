// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <optional>
#include <string_view>

#include "straightedge/host/line_map.hpp"
#include "straightedge/host/plane_map.hpp"

namespace straightedge::io {

/// On which sides of a feature something is, relative to its normal: unknown, plus, minus, both.
template <class Side>
concept SideOfNormal = std::same_as<Side, FreeSide> || std::same_as<Side, SeenSide>;

/// The value of the attributes `free` and `seen`; empty for unknown, when the attribute is left out.
template <SideOfNormal Side>
constexpr const char* to_text(Side side) noexcept {
  switch (side) {
    case Side::unknown:
      return "";
    case Side::plus:
      return "+";
    case Side::minus:
      return "-";
    case Side::both:
      return "both";
  }
  return "";
}

template <SideOfNormal Side>
constexpr std::optional<Side> side_from_text(std::string_view text) noexcept {
  for (const Side side : {Side::plus, Side::minus, Side::both}) {
    if (text == to_text(side)) return side;
  }
  return {};
}

}  // namespace straightedge::io
