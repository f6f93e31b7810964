// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "io/ply_read.hpp"

#include <array>
#include <string>

#include "io/cloud_text.hpp"
#include "io/number_text.hpp"
#include "io/ply_header.hpp"
#include "io/quoted_word.hpp"

namespace straightedge::io {
namespace {

[[noreturn]] void refuse_truncated(const PlyElement& element) {
  throw CloudBreach{"is truncated: its header promises " + std::to_string(element.count) +
                    " of the element " + quoted(element.name) + ", and it holds fewer"};
}

using Axes = std::array<std::size_t, 3>;

/// Which properties are x, y and z.
Axes axes_of(const PlyElement& vertex) {
  constexpr std::string_view names[] = {"x", "y", "z"};
  Axes axes{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::size_t at = 0;
    while (at < vertex.properties.size() &&
           (vertex.properties[at].name != names[axis] || vertex.properties[at].list_length)) {
      ++at;
    }
    if (at == vertex.properties.size()) throw CloudBreach{"its vertices have no properties x, y and z"};
    axes[axis] = at;
  }
  return axes;
}

void reserve(Cloud& cloud, std::uint64_t count) {
  for (std::vector<float>* values : {&cloud.x, &cloud.y, &cloud.z}) values->reserve(count);
}

void append(Cloud& cloud, const std::array<float, 3>& point) {
  cloud.x.push_back(point[0]);
  cloud.y.push_back(point[1]);
  cloud.z.push_back(point[2]);
}

/// The next line that is not empty.
std::string_view take_values(TextLines& lines, const PlyElement& element) {
  while (!lines.at_end()) {
    const std::string_view line = lines.take();
    if (line.find_first_not_of(blanks) != std::string_view::npos) return line;
  }
  refuse_truncated(element);
}

void skip_ascii(TextLines& lines, const PlyElement& element) {
  if (element.properties.empty()) return;
  for (std::uint64_t i = 0; i < element.count; ++i) (void)take_values(lines, element);
}

std::array<float, 3> read_point(const TextLines& lines, std::string_view line, const PlyElement& vertex,
                                const Axes& axes) {
  std::array<float, 3> point{};
  const auto next = [&] {
    const std::string_view word = take_word(line);
    if (word.empty()) refuse_line(lines, "has fewer values than a vertex has");
    return word;
  };
  for (std::size_t i = 0; i < vertex.properties.size(); ++i) {
    const std::string_view word = next();
    if (vertex.properties[i].list_length) {
      for (std::uint64_t k = whole_number(lines, word); k > 0; --k) (void)next();
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (axes[axis] == i) point[axis] = coordinate_from_text(lines, word);
    }
  }
  if (!take_word(line).empty()) refuse_line(lines, "has more values than a vertex has");
  return point;
}

void read_ascii(TextLines& lines, const PlyElement& vertex, const Axes& axes, Cloud& cloud) {
  // A value takes a digit and a blank or line end, which the last one may lack.
  if (!can_hold(lines.rest(), vertex.count, vertex.properties.size())) refuse_truncated(vertex);
  if (lines.rest().size() + 1 < 2 * vertex.properties.size() * vertex.count) refuse_truncated(vertex);
  reserve(cloud, vertex.count);
  for (std::uint64_t i = 0; i < vertex.count; ++i) {
    const std::string_view line = take_values(lines, vertex);
    append(cloud, read_point(lines, line, vertex, axes));
  }
}

/// Takes one element off the bytes; calls visit(index of the property, its bytes) for each single value.
template <class Visit>
void take_binary(std::string_view& bytes, const PlyElement& element, ByteOrder order, const Visit& visit) {
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    const PlyProperty& property = element.properties[i];
    std::uint64_t count = 1;
    if (property.list_length) {
      const std::size_t size = size_of(*property.list_length);
      if (bytes.size() < size) refuse_truncated(element);
      const double length = read_scalar(bytes.data(), *property.list_length, order);
      bytes.remove_prefix(size);
      if (!(length >= 0)) throw CloudBreach{"the length of a list is negative"};
      if (length > static_cast<double>(bytes.size())) refuse_truncated(element);
      count = static_cast<std::uint64_t>(length);
    }
    if (!can_hold(bytes, count, size_of(property.type))) refuse_truncated(element);
    if (!property.list_length) visit(i, bytes.data());
    bytes.remove_prefix(count * size_of(property.type));
  }
}

void skip_binary(std::string_view& bytes, const PlyElement& element, ByteOrder order) {
  if (!can_hold(bytes, element.count, element.least_size())) refuse_truncated(element);
  if (!element.has_lists()) return bytes.remove_prefix(element.count * element.least_size());
  for (std::uint64_t i = 0; i < element.count; ++i) take_binary(bytes, element, order, [](auto, auto) {});
}

void read_binary(std::string_view bytes, const PlyElement& vertex, ByteOrder order, const Axes& axes,
                 Cloud& cloud) {
  if (!can_hold(bytes, vertex.count, vertex.least_size())) refuse_truncated(vertex);
  if (!vertex.has_lists()) {
    const auto column = [&](std::size_t axis) {
      std::size_t offset = 0;
      for (std::size_t i = 0; i < axes[axis]; ++i) offset += size_of(vertex.properties[i].type);
      return coordinates_of(
          {bytes.data() + offset, vertex.least_size(), vertex.properties[axes[axis]].type, order},
          vertex.count);
    };
    cloud.x = column(0);
    cloud.y = column(1);
    cloud.z = column(2);
    return;
  }
  reserve(cloud, vertex.count);
  for (std::uint64_t i = 0; i < vertex.count; ++i) {
    std::array<float, 3> point{};
    take_binary(bytes, vertex, order, [&](std::size_t property, const char* value) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (axes[axis] != property) continue;
        point[axis] = coordinate_from(read_scalar(value, vertex.properties[property].type, order));
      }
    });
    append(cloud, point);
  }
}

}  // namespace

bool is_ply(std::string_view bytes) noexcept {
  return bytes.size() > 3 && bytes.starts_with("ply") && blanks.find(bytes[3]) != std::string_view::npos;
}

Cloud decode_ply(std::string_view bytes) {
  TextLines lines(bytes);
  const PlyHeader header = read_ply_header(lines);
  const bool ascii = header.encoding == PlyEncoding::ascii;
  const auto order = header.encoding == PlyEncoding::binary_big_endian ? ByteOrder::big : ByteOrder::little;
  std::string_view rest = lines.rest();
  for (const PlyElement& element : header.elements) {
    if (element.name != "vertex") {
      ascii ? skip_ascii(lines, element) : skip_binary(rest, element, order);
      continue;
    }
    check_point_count(element.count);
    const Axes axes = axes_of(element);
    Cloud cloud;
    ascii ? read_ascii(lines, element, axes, cloud) : read_binary(rest, element, order, axes, cloud);
    return cloud;
  }
  throw CloudBreach{"its header has no element `vertex`"};
}

}  // namespace straightedge::io
