// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "io/ply_header.hpp"

#include <algorithm>

#include "io/cloud_text.hpp"
#include "io/number_text.hpp"
#include "io/quoted_word.hpp"

namespace straightedge::io {
namespace {

struct TypeName {
  std::string_view name;
  ScalarType type;
};

/// The names of the first description of the format, and those with sizes that came later.
constexpr TypeName type_names[] = {
    {"char", ScalarType::int8},     {"uchar", ScalarType::uint8},     {"short", ScalarType::int16},
    {"ushort", ScalarType::uint16}, {"int", ScalarType::int32},       {"uint", ScalarType::uint32},
    {"float", ScalarType::float32}, {"double", ScalarType::float64},  {"int8", ScalarType::int8},
    {"uint8", ScalarType::uint8},   {"int16", ScalarType::int16},     {"uint16", ScalarType::uint16},
    {"int32", ScalarType::int32},   {"uint32", ScalarType::uint32},   {"int64", ScalarType::int64},
    {"uint64", ScalarType::uint64}, {"float32", ScalarType::float32}, {"float64", ScalarType::float64}};

ScalarType type_of(const TextLines& lines, std::string_view word) {
  for (const TypeName& known : type_names) {
    if (known.name == word) return known.type;
  }
  refuse_line(lines, quoted(word) + " is no type of a PLY property");
}

PlyEncoding read_format(const TextLines& lines, std::string_view text) {
  const std::string_view name = take_word(text);
  const std::string_view version = take_word(text);
  if (version != "1.0")
    refuse_line(lines, "the PLY format's version is " + quoted(version) + ", and 1.0 is read");
  if (name == "ascii") return PlyEncoding::ascii;
  if (name == "binary_little_endian") return PlyEncoding::binary_little_endian;
  if (name == "binary_big_endian") return PlyEncoding::binary_big_endian;
  refuse_line(lines, quoted(name) + " is none of ascii, binary_little_endian and binary_big_endian");
}

PlyElement read_element(const TextLines& lines, std::string_view text) {
  PlyElement element;
  element.name = take_word(text);
  element.count = whole_number(lines, take_word(text));
  return element;
}

PlyProperty read_property(const TextLines& lines, std::string_view text) {
  PlyProperty property;
  std::string_view word = take_word(text);
  if (word == "list") {
    property.list_length = type_of(lines, take_word(text));
    if (!is_whole(*property.list_length)) refuse_line(lines, "the length of a list is of no whole type");
    word = take_word(text);
  }
  property.type = type_of(lines, word);
  property.name = take_word(text);
  if (property.name.empty()) refuse_line(lines, "a property has no name");
  return property;
}

}  // namespace

bool PlyElement::has_lists() const noexcept {
  return std::any_of(properties.begin(), properties.end(),
                     [](const PlyProperty& property) { return property.list_length.has_value(); });
}

std::uint64_t PlyElement::least_size() const noexcept {
  std::uint64_t size = 0;
  for (const PlyProperty& property : properties)
    size += size_of(property.list_length.value_or(property.type));
  return size;
}

PlyHeader read_ply_header(TextLines& lines) {
  PlyHeader header;
  bool has_format = false;
  (void)lines.take();
  while (true) {
    if (lines.at_end()) throw CloudBreach{"its header ends without end_header"};
    std::string_view text = lines.take();
    const std::string_view keyword = take_word(text);
    if (keyword == "end_header") break;
    if (keyword.empty() || keyword == "comment" || keyword == "obj_info") continue;
    if (keyword == "format") {
      header.encoding = read_format(lines, text);
      has_format = true;
    } else if (keyword == "element") {
      header.elements.push_back(read_element(lines, text));
    } else if (keyword == "property") {
      if (header.elements.empty()) refuse_line(lines, "a property comes before the first element");
      header.elements.back().properties.push_back(read_property(lines, text));
    } else {
      refuse_line(lines, quoted(keyword) + " is no keyword of a PLY header");
    }
  }
  if (!has_format) throw CloudBreach{"its header has no line `format`"};
  return header;
}

}  // namespace straightedge::io
