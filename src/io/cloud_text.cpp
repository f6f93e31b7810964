// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "io/cloud_text.hpp"

#include "io/number_text.hpp"
#include "io/quoted_word.hpp"
#include "io/scalar.hpp"

namespace straightedge::io {

void refuse_line(const TextLines& lines, const std::string& what) {
  throw CloudBreach{"line " + std::to_string(lines.number()) + ": " + what};
}

void check_point_count(std::uint64_t count) {
  if (count <= max_cloud_points) return;
  throw CloudBreach{"its header promises " + std::to_string(count) + " points, and at most 2^31 are read"};
}

std::uint64_t whole_number(const TextLines& lines, std::string_view word) {
  const auto value = number_from_text<std::uint64_t>(word);
  if (!value) refuse_line(lines, quoted(word) + " is no whole number from 0 up");
  return *value;
}

float coordinate_from_text(const TextLines& lines, std::string_view word) {
  const auto value = number_from_text<double>(word);
  if (!value) refuse_line(lines, quoted(word) + " is no number");
  return coordinate_from(*value);
}

}  // namespace straightedge::io
