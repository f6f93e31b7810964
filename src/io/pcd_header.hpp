// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "io/scalar.hpp"
#include "io/text_lines.hpp"
#include "straightedge/host/pose.hpp"

namespace straightedge::io {

enum class PcdEncoding : std::uint8_t { ascii, binary, binary_compressed };

/// Where a coordinate stands in a point of the file.
struct PcdCoordinate {
  ScalarType type = ScalarType::float32;
  std::size_t offset = 0;        ///< bytes before it in a point
  std::size_t field_size = 0;    ///< bytes of its whole field, more than one value with COUNT above 1
  std::size_t words_before = 0;  ///< values before it in a point
};

struct PcdHeader {
  std::array<PcdCoordinate, 3> coordinates;  ///< x, y, z
  std::size_t point_size = 0;                ///< bytes
  std::size_t point_words = 0;               ///< values
  std::uint64_t points = 0;
  std::int32_t width = 0;  ///< of an organised cloud; 0: no order
  Pose viewpoint;
  PcdEncoding encoding = PcdEncoding::ascii;
};

bool is_pcd_keyword(std::string_view word) noexcept;

/// Takes the lines up to DATA and checks that they fit together. Throws CloudBreach.
PcdHeader read_pcd_header(TextLines& lines);

}  // namespace straightedge::io
