// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace straightedge::io {

/// A word of a file for a sentence: short, and without what a terminal would act upon.
inline std::string quoted(std::string_view word) {
  std::string text;
  for (const char c : word.substr(0, 40)) text += c > ' ' && c <= '~' ? c : '?';
  return "'" + text + "'";
}

}  // namespace straightedge::io
