// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace straightedge::io {

/// Line after line of a text that may be followed by binary data. Lines end by \n, by \r\n or, where the
/// first one does, by \r alone.
class TextLines {
 public:
  explicit TextLines(std::string_view bytes) : rest_(bytes) {
    const std::size_t first = bytes.find_first_of("\r\n");
    if (first != std::string_view::npos && bytes[first] == '\r' && !bytes.substr(first).starts_with("\r\n")) {
      end_ = '\r';
    }
  }

  bool at_end() const noexcept { return rest_.empty(); }
  /// What follows the lines that were taken.
  std::string_view rest() const noexcept { return rest_; }
  /// The number of the line that was taken last, from 1.
  std::size_t number() const noexcept { return number_; }

  std::string_view take() noexcept {
    const std::size_t end = std::min(rest_.find(end_), rest_.size());
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    ++number_;
    return line;
  }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
  char end_ = '\n';
};

}  // namespace straightedge::io
