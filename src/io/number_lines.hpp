// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "straightedge/host/result.hpp"

namespace straightedge::io {

/// The words of one line, and the line's number in its file.
struct WordLine {
  std::size_t line = 0;
  std::vector<std::string_view> words;
};

/// The numbers of one line, all finite.
struct NumberLine {
  std::size_t line = 0;
  std::vector<double> numbers;
};

/// What stands between blanks on each line. Empty lines and what follows a `#` are passed over; lines end
/// by \n, \r\n or \r. The words point into `text`.
std::vector<WordLine> word_lines(std::string_view text);

/// The finite number that a word is, or a sentence with the file's name and the line.
Result<double> finite_number(std::string_view word, std::size_t line, const std::string& name);

/// The same lines as numbers; bad_content at the first word that is no finite number.
Result<std::vector<NumberLine>> number_lines(std::string_view text, const std::string& name);

}  // namespace straightedge::io
