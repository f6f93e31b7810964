// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "io/number_lines.hpp"

#include <algorithm>
#include <cmath>

#include "io/number_text.hpp"
#include "io/quoted_word.hpp"

namespace straightedge::io {
namespace {

std::vector<std::string_view> words_of(std::string_view text) {
  constexpr std::string_view blanks = " \t\v\f";
  std::vector<std::string_view> words;
  for (std::size_t at = text.find_first_not_of(blanks); at != std::string_view::npos;
       at = text.find_first_not_of(blanks, at)) {
    const std::size_t end = std::min(text.find_first_of(blanks, at), text.size());
    words.push_back(text.substr(at, end - at));
    at = end;
  }
  return words;
}

}  // namespace

std::vector<WordLine> word_lines(std::string_view text) {
  std::vector<WordLine> lines;
  std::size_t line = 1;
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // byte order mark
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    const std::string_view content = text.substr(0, end);
    auto words = words_of(content.substr(0, content.find('#')));
    if (!words.empty()) lines.push_back({line, std::move(words)});
    text.remove_prefix(std::min(end + (text.substr(end).starts_with("\r\n") ? 2 : 1), text.size()));
    ++line;
  }
  return lines;
}

Result<double> finite_number(std::string_view word, std::size_t line, const std::string& name) {
  const auto value = number_from_text<double>(word);
  if (value && std::isfinite(*value)) return *value;
  return Failure{Problem::bad_content, name + ": line " + std::to_string(line) + ": " + quoted(word) +
                                           (value ? " is not finite" : " is no number")};
}

Result<std::vector<NumberLine>> number_lines(std::string_view text, const std::string& name) {
  std::vector<NumberLine> lines;
  for (const WordLine& words : word_lines(text)) {
    NumberLine numbers{words.line, {}};
    for (const std::string_view word : words.words) {
      const auto number = finite_number(word, words.line, name);
      if (!number) return number.failure();
      numbers.numbers.push_back(*number);
    }
    lines.push_back(std::move(numbers));
  }
  return lines;
}

}  // namespace straightedge::io
