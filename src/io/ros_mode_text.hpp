// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "straightedge/host/line_map.hpp"

namespace straightedge::io {

constexpr const char* to_text(RosMapMode mode) noexcept {
  switch (mode) {
    case RosMapMode::trinary:
      return "trinary";
    case RosMapMode::scale:
      return "scale";
    case RosMapMode::raw:
      return "raw";
  }
  return "trinary";
}

constexpr std::optional<RosMapMode> ros_mode_from_text(std::string_view text) noexcept {
  for (const RosMapMode mode : {RosMapMode::trinary, RosMapMode::scale, RosMapMode::raw}) {
    if (text == to_text(mode)) return mode;
  }
  return {};
}

}  // namespace straightedge::io
