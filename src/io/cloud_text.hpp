// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "io/text_lines.hpp"
#include "straightedge/host/cloud.hpp"

/// What the readers of PCD and of PLY files share.
namespace straightedge::io {

/// Thrown while a cloud is read, caught where the reading began: the formats then read as they are laid out.
struct CloudBreach {
  std::string sentence;
};

/// The sentence begins with the number of the line that was taken last.
[[noreturn]] void refuse_line(const TextLines& lines, const std::string& what);

/// Above this many points a file is refused.
inline constexpr std::uint64_t max_cloud_points = std::uint64_t{1} << 31;
void check_point_count(std::uint64_t count);

/// Whether the bytes hold so many values of that size; overflow means that they do not.
constexpr bool can_hold(std::string_view bytes, std::uint64_t count, std::uint64_t size) noexcept {
  return size == 0 || count <= bytes.size() / size;
}

/// The value of a word that must be a whole number from 0 up.
std::uint64_t whole_number(const TextLines& lines, std::string_view word);
/// "nan" and "inf" are values here.
float coordinate_from_text(const TextLines& lines, std::string_view word);

}  // namespace straightedge::io
