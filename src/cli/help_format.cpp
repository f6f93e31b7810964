// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cli/help_format.hpp"

#include <cstddef>

namespace straightedge::cli {
namespace {

constexpr std::size_t terminal = 100;  // columns

}  // namespace

std::string HelpFormat::make_option_desc(const CLI::Option* option) const {
  std::string text = option->get_description();
  const std::size_t width = terminal - get_column_width();
  for (std::size_t line = 0; text.size() - line > width;) {
    const std::size_t blank = text.rfind(' ', line + width);
    if (blank == std::string::npos || blank <= line) break;
    text[blank] = '\n';
    line = blank + 1;
  }
  return text;
}

}  // namespace straightedge::cli
