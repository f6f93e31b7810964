// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "straightedge/host/image.hpp"

namespace straightedge::io {

/// "#rrggbb", as SVG and CSS have it.
inline std::string hex(Rgb colour) {
  constexpr const char* digits = "0123456789abcdef";
  std::string text = "#";
  for (const unsigned char value : {colour.red, colour.green, colour.blue}) {
    text += digits[value >> 4];
    text += digits[value & 15];
  }
  return text;
}

}  // namespace straightedge::io
