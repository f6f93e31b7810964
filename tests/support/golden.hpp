// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdlib>
#include <string>
#include <string_view>

// Golden files are rows of records, `kind key=value ... bytes=N` and a line feed, then N bytes. The reader
// works on memory, wherever the bytes come from.
namespace support {

struct GoldenRecord {
  std::string_view line;  ///< without its line feed
  std::string_view bytes;

  std::string_view kind() const { return line.substr(0, line.find(' ')); }

  /// The text after `key=`; empty when the record has no such key.
  std::string_view text(std::string_view key) const {
    std::size_t start = 0;
    while ((start = line.find(' ', start)) != std::string_view::npos) {
      ++start;
      const std::string_view word = line.substr(start, line.find(' ', start) - start);
      if (word.size() > key.size() && word.starts_with(key) && word[key.size()] == '=') {
        return word.substr(key.size() + 1);
      }
    }
    return {};
  }
  double number(std::string_view key) const { return std::strtod(std::string(text(key)).c_str(), nullptr); }
  int integer(std::string_view key) const { return static_cast<int>(number(key)); }
};

class GoldenReader {
 public:
  explicit GoldenReader(std::string_view file) : rest_(file) {}

  /// False at the end of the file. A file that is cut short ends with `broken()`.
  bool next(GoldenRecord& record) {
    if (rest_.empty() || broken_) return false;
    const std::size_t end = rest_.find('\n');
    broken_ = end == std::string_view::npos;
    if (broken_) return false;
    record.line = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    const int count = record.integer("bytes");
    broken_ = record.text("bytes").empty() || count < 0 || static_cast<std::size_t>(count) > rest_.size();
    if (broken_) return false;
    record.bytes = rest_.substr(0, static_cast<std::size_t>(count));
    rest_.remove_prefix(record.bytes.size());
    return true;
  }
  bool broken() const { return broken_; }

 private:
  std::string_view rest_;
  bool broken_ = false;
};

/// The pixels of a binary PGM without comments: what follows its four words and one line feed.
inline std::string_view pgm_pixels(std::string_view file) {
  std::size_t at = 0;
  for (int line = 0; line < 3 && at != std::string_view::npos; ++line) at = file.find('\n', at) + 1;
  return file.starts_with("P5\n") ? file.substr(at) : std::string_view();
}

}  // namespace support
