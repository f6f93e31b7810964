// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "io/scalar.hpp"
#include "io/text_lines.hpp"

namespace straightedge::io {

enum class PlyEncoding : std::uint8_t { ascii, binary_little_endian, binary_big_endian };

struct PlyProperty {
  std::string_view name;
  ScalarType type = ScalarType::float32;  ///< of the value, or of a list's values
  std::optional<ScalarType> list_length;  ///< its type; none: a single value
};

struct PlyElement {
  std::string_view name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  bool has_lists() const noexcept;
  /// Bytes of one, taking its lists to be empty.
  std::uint64_t least_size() const noexcept;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
};

/// Takes the lines up to end_header. Names point into the text. Throws CloudBreach.
PlyHeader read_ply_header(TextLines& lines);

}  // namespace straightedge::io
