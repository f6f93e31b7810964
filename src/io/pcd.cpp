// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "io/pcd.hpp"

#include <string>
#include <vector>

#include "io/cloud_text.hpp"
#include "io/lzf.hpp"
#include "io/number_text.hpp"
#include "io/pcd_header.hpp"

namespace straightedge::io {
namespace {

[[noreturn]] void refuse_truncated(std::uint64_t promised) {
  throw CloudBreach{"is truncated: its header promises " + std::to_string(promised) +
                    " points, and it holds fewer"};
}

/// The next line with values; empty at the end.
std::string_view take_values(TextLines& lines) {
  while (!lines.at_end()) {
    const std::string_view line = lines.take();
    const std::size_t first = line.find_first_not_of(blanks);
    if (first != std::string_view::npos && line[first] != '#') return line;
  }
  return {};
}

void read_ascii(TextLines& lines, const PcdHeader& header, Cloud& cloud) {
  // A value takes a digit and a blank or line end, which the last one may lack.
  if (lines.rest().size() + 1 < 2 * header.point_words * header.points) refuse_truncated(header.points);
  const std::array<std::vector<float>*, 3> outputs{&cloud.x, &cloud.y, &cloud.z};
  for (std::vector<float>* output : outputs) output->reserve(header.points);
  for (std::uint64_t i = 0; i < header.points; ++i) {
    std::string_view rest = take_values(lines);
    if (rest.empty()) refuse_truncated(header.points);
    std::array<float, 3> point{};
    std::size_t words = 0;
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest), ++words) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (words == header.coordinates[axis].words_before) point[axis] = coordinate_from_text(lines, word);
      }
    }
    if (words != header.point_words) {
      refuse_line(lines, "has " + std::to_string(words) + " values where a point has " +
                             std::to_string(header.point_words));
    }
    for (std::size_t axis = 0; axis < 3; ++axis) outputs[axis]->push_back(point[axis]);
  }
}

/// Point after point.
void read_binary(std::string_view bytes, const PcdHeader& header, Cloud& cloud) {
  if (!can_hold(bytes, header.points, header.point_size)) refuse_truncated(header.points);
  const auto column = [&](std::size_t axis) {
    const PcdCoordinate& at = header.coordinates[axis];
    return coordinates_of({bytes.data() + at.offset, header.point_size, at.type, ByteOrder::little},
                          header.points);
  };
  cloud.x = column(0);
  cloud.y = column(1);
  cloud.z = column(2);
}

/// Two lengths, then all points' first field, all points' second field and so on, compressed as one.
void read_compressed(std::string_view bytes, const PcdHeader& header, Cloud& cloud) {
  if (header.points == 0) return;
  if (bytes.size() < 8) refuse_truncated(header.points);
  const std::uint64_t packed = read_unsigned(bytes.data(), 4, ByteOrder::little);
  const std::uint64_t unpacked = read_unsigned(bytes.data() + 4, 4, ByteOrder::little);
  bytes.remove_prefix(8);
  if (packed > bytes.size()) refuse_truncated(header.points);
  if (unpacked / header.points != header.point_size || unpacked % header.points != 0) {
    throw CloudBreach{"its compressed data is said to hold " + std::to_string(unpacked) +
                      " bytes, which is not what its header promises"};
  }
  // Before memory is taken for what so few bytes cannot hold.
  if (unpacked > packed * lzf_largest_ratio) refuse_truncated(header.points);
  std::vector<char> data(unpacked);
  if (!lzf_decompress(bytes.substr(0, packed), data)) throw CloudBreach{"its compressed data is broken"};
  const auto column = [&](std::size_t axis) {
    const PcdCoordinate& at = header.coordinates[axis];
    return coordinates_of(
        {data.data() + at.offset * header.points, at.field_size, at.type, ByteOrder::little}, header.points);
  };
  cloud.x = column(0);
  cloud.y = column(1);
  cloud.z = column(2);
}

}  // namespace

bool is_pcd(std::string_view bytes) noexcept {
  TextLines lines(bytes);
  while (!lines.at_end()) {
    std::string_view line = lines.take();
    const std::string_view word = take_word(line);
    if (!word.empty() && word[0] != '#') return is_pcd_keyword(word);
  }
  return false;
}

Cloud decode_pcd(std::string_view bytes) {
  TextLines lines(bytes);
  const PcdHeader header = read_pcd_header(lines);
  Cloud cloud;
  cloud.width = header.width;
  cloud.viewpoint = header.viewpoint;
  switch (header.encoding) {
    case PcdEncoding::ascii:
      read_ascii(lines, header, cloud);
      break;
    case PcdEncoding::binary:
      read_binary(lines.rest(), header, cloud);
      break;
    case PcdEncoding::binary_compressed:
      read_compressed(lines.rest(), header, cloud);
      break;
  }
  return cloud;
}

}  // namespace straightedge::io
