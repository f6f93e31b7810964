// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

#include "io/scalar.hpp"
#include "io/xml_text.hpp"
#include "straightedge/host/label_picture.hpp"
#include "straightedge/vector3.hpp"

namespace straightedge::io {

inline constexpr std::string_view ply_head = "ply\nformat binary_little_endian 1.0\n";

/// The properties that append_vertex writes.
inline constexpr std::string_view ply_vertex_properties =
    "property float x\nproperty float y\nproperty float z\n"
    "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uint label\n";
inline constexpr std::size_t ply_vertex_size = 19;

/// A line of the header; what would end the line becomes a blank.
inline std::string ply_comment(std::string_view text) {
  return std::string("comment ").append(text_for_xml(text)).append("\n");
}

inline void append_word(std::string& bytes, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 255);
}

inline void append_vertex(std::string& bytes, const Vector3& point, std::uint32_t label) {
  for (const double value : {point.x, point.y, point.z}) {
    append_word(bytes, std::bit_cast<std::uint32_t>(coordinate_from(value)));
  }
  const Rgb colour = plane_colour(label);
  for (const unsigned char value : {colour.red, colour.green, colour.blue}) bytes += static_cast<char>(value);
  append_word(bytes, label);
}

}  // namespace straightedge::io
