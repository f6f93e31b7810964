// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "io/pcd_header.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "io/cloud_text.hpp"
#include "io/number_text.hpp"
#include "io/quoted_word.hpp"
#include "io/rotation.hpp"

namespace straightedge::io {
namespace {

constexpr std::string_view keywords[] = {"VERSION", "FIELDS", "COLUMNS",   "SIZE",   "TYPE", "COUNT",
                                         "WIDTH",   "HEIGHT", "VIEWPOINT", "POINTS", "DATA"};

/// The lines as they stand, before they are put together.
struct Lines {
  std::vector<std::string_view> names, types;
  std::vector<std::uint64_t> sizes, counts;
  std::optional<std::uint64_t> width, height, points;
  Pose viewpoint;
  std::optional<PcdEncoding> encoding;
};

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  for (auto word = take_word(text); !word.empty(); word = take_word(text)) words.push_back(word);
  return words;
}

std::vector<std::uint64_t> whole_numbers(const TextLines& lines, std::string_view text) {
  std::vector<std::uint64_t> values;
  for (const std::string_view word : words_of(text)) values.push_back(whole_number(lines, word));
  return values;
}

void check_version(const TextLines& lines, std::string_view word) {
  const auto version = number_from_text<double>(word);
  if (!version || !(*version > 0 && *version <= 0.7)) {
    refuse_line(lines, "the version of the PCD format is " + quoted(word) + ", and up to 0.7 is read");
  }
}

Pose read_viewpoint(const TextLines& lines, std::string_view text) {
  std::array<double, 7> values{};
  const auto words = words_of(text);
  if (words.size() != values.size())
    refuse_line(lines, "VIEWPOINT has not the 7 numbers tx ty tz qw qx qy qz");
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto value = number_from_text<double>(words[i]);
    if (!value || !std::isfinite(*value)) refuse_line(lines, quoted(words[i]) + " is no finite number");
    values[i] = *value;
  }
  Pose pose;
  pose.translation = {values[0], values[1], values[2]};
  const char* trouble = take_rotation(std::array{values[4], values[5], values[6], values[3]}, pose);
  if (trouble != nullptr) refuse_line(lines, std::string("VIEWPOINT: ") + trouble);
  return pose;
}

PcdEncoding read_encoding(const TextLines& lines, std::string_view word) {
  if (word == "ascii") return PcdEncoding::ascii;
  if (word == "binary") return PcdEncoding::binary;
  if (word == "binary_compressed") return PcdEncoding::binary_compressed;
  refuse_line(lines, "DATA is " + quoted(word) + ", none of ascii, binary and binary_compressed");
}

void take_line(const TextLines& lines, std::string_view text, Lines& header) {
  const std::string_view keyword = take_word(text);
  std::string_view rest = text;
  const std::string_view first = take_word(rest);
  if (keyword == "VERSION") {
    check_version(lines, first);
  } else if (keyword == "FIELDS" || keyword == "COLUMNS") {
    header.names = words_of(text);
  } else if (keyword == "SIZE") {
    header.sizes = whole_numbers(lines, text);
  } else if (keyword == "TYPE") {
    header.types = words_of(text);
  } else if (keyword == "COUNT") {
    header.counts = whole_numbers(lines, text);
  } else if (keyword == "WIDTH") {
    header.width = whole_number(lines, first);
  } else if (keyword == "HEIGHT") {
    header.height = whole_number(lines, first);
  } else if (keyword == "VIEWPOINT") {
    header.viewpoint = read_viewpoint(lines, text);
  } else if (keyword == "POINTS") {
    header.points = whole_number(lines, first);
  } else if (keyword == "DATA") {
    header.encoding = read_encoding(lines, first);
  } else {
    refuse_line(lines, quoted(keyword) + " is no keyword of a PCD header");
  }
}

/// Older files may leave out what says "one float each".
void complete_fields(Lines& header) {
  const std::size_t fields = header.names.size();
  if (fields == 0) throw CloudBreach{"its header has no FIELDS"};
  if (header.sizes.empty()) header.sizes.assign(fields, 4);
  if (header.types.empty()) header.types.assign(fields, "F");
  if (header.counts.empty()) header.counts.assign(fields, 1);
  if (header.sizes.size() != fields || header.types.size() != fields || header.counts.size() != fields) {
    throw CloudBreach{"its header's FIELDS, SIZE, TYPE and COUNT differ in number"};
  }
}

std::optional<ScalarType> scalar_type(std::string_view letter, std::uint64_t size) {
  const auto pick = [size](ScalarType one, ScalarType two, ScalarType four, ScalarType eight) {
    return size == 1 ? one : size == 2 ? two : size == 4 ? four : eight;
  };
  using enum ScalarType;
  if (letter == "I") return pick(int8, int16, int32, int64);
  if (letter == "U") return pick(uint8, uint16, uint32, uint64);
  if (letter == "F" && size >= 4) return size == 4 ? float32 : float64;
  return {};
}

void lay_out_fields(const Lines& lines, PcdHeader& header) {
  constexpr std::uint64_t most_values = std::uint64_t{1} << 28;  // keeps sums and products below 2^64
  constexpr std::string_view axes = "xyz";
  std::array<bool, 3> found{};
  for (std::size_t i = 0; i < lines.names.size(); ++i) {
    const std::uint64_t size = lines.sizes[i], count = lines.counts[i];
    const std::string title = "the field " + quoted(lines.names[i]);
    if (size != 1 && size != 2 && size != 4 && size != 8)
      throw CloudBreach{title + " has a SIZE of none of 1, 2, 4, 8"};
    if (count > most_values) throw CloudBreach{title + " has a COUNT above 2^28"};
    const std::size_t axis = lines.names[i].size() == 1 ? axes.find(lines.names[i]) : std::string_view::npos;
    if (axis != std::string_view::npos && count > 0 && !found[axis]) {
      const auto type = scalar_type(lines.types[i], size);
      if (!type) throw CloudBreach{title + " is of a TYPE and SIZE that is no number"};
      header.coordinates[axis] = {*type, header.point_size, size * count, header.point_words};
      found[axis] = true;
    }
    header.point_size += size * count;
    header.point_words += count;
    if (header.point_words > most_values) throw CloudBreach{"a point has more than 2^28 values"};
  }
  if (!found[0] || !found[1] || !found[2]) throw CloudBreach{"its header has no fields x, y and z"};
}

void count_points(const Lines& lines, PcdHeader& header) {
  const std::uint64_t height = lines.height.value_or(1);
  const auto width = lines.width ? lines.width : lines.points;
  if (!width) throw CloudBreach{"its header has neither WIDTH nor POINTS"};
  if (height > 0)
    check_point_count(*width > max_cloud_points ? *width : *width * std::min(height, max_cloud_points + 1));
  header.points = *width * height;
  if (lines.points) check_point_count(*lines.points);
  if (lines.points && *lines.points != header.points) {
    throw CloudBreach{"its header promises " + std::to_string(*lines.points) +
                      " points, but WIDTH times HEIGHT is " + std::to_string(header.points)};
  }
  if (height > 1 && header.points > 0) header.width = static_cast<std::int32_t>(*width);
}

}  // namespace

bool is_pcd_keyword(std::string_view word) noexcept {
  return std::find(std::begin(keywords), std::end(keywords), word) != std::end(keywords);
}

PcdHeader read_pcd_header(TextLines& lines) {
  Lines read;
  while (!read.encoding) {
    if (lines.at_end()) throw CloudBreach{"its header ends without DATA"};
    const std::string_view line = lines.take();
    if (const std::size_t first = line.find_first_not_of(blanks); first != line.npos && line[first] != '#') {
      take_line(lines, line, read);
    }
  }
  complete_fields(read);
  PcdHeader header;
  header.viewpoint = read.viewpoint;
  header.encoding = *read.encoding;
  lay_out_fields(read, header);
  count_points(read, header);
  return header;
}

}  // namespace straightedge::io
