// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "io/scalar.hpp"

/// Files of points, built byte by byte and apart from the code that reads them.
namespace cloud_maker {

using straightedge::io::ByteOrder;
using straightedge::io::ScalarType;

template <class Number>
std::string bytes_of_number(double value, ByteOrder order) {
  const auto number = static_cast<Number>(value);
  std::string bytes(sizeof number, '\0');
  std::memcpy(bytes.data(), &number, sizeof number);
  const bool turned = (std::endian::native == std::endian::big) != (order == ByteOrder::big);
  if (turned) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

inline std::string scalar(double value, ScalarType type, ByteOrder order = ByteOrder::little) {
  switch (type) {
    case ScalarType::int8:
      return bytes_of_number<std::int8_t>(value, order);
    case ScalarType::uint8:
      return bytes_of_number<std::uint8_t>(value, order);
    case ScalarType::int16:
      return bytes_of_number<std::int16_t>(value, order);
    case ScalarType::uint16:
      return bytes_of_number<std::uint16_t>(value, order);
    case ScalarType::int32:
      return bytes_of_number<std::int32_t>(value, order);
    case ScalarType::uint32:
      return bytes_of_number<std::uint32_t>(value, order);
    case ScalarType::int64:
      return bytes_of_number<std::int64_t>(value, order);
    case ScalarType::uint64:
      return bytes_of_number<std::uint64_t>(value, order);
    case ScalarType::float32:
      return bytes_of_number<float>(value, order);
    case ScalarType::float64:
      return bytes_of_number<double>(value, order);
  }
  return {};
}

/// LZF with literals, and runs of the byte before where there are any: the shortest code that has both.
inline std::string lzf_compress(const std::string& bytes) {
  std::string packed;
  std::string literals;
  const auto flush = [&] {
    if (!literals.empty()) packed += static_cast<char>(literals.size() - 1) + literals;
    literals.clear();
  };
  for (std::size_t i = 0; i < bytes.size();) {
    std::size_t run = 0;
    while (i > 0 && run < 264 && i + run < bytes.size() && bytes[i + run] == bytes[i - 1]) ++run;
    if (run < 3) {
      literals += bytes[i++];
      if (literals.size() == 32) flush();
      continue;
    }
    flush();
    if (run < 9) {
      packed += static_cast<char>((run - 2) << 5);
    } else {
      packed += static_cast<char>(7 << 5);
      packed += static_cast<char>(run - 9);
    }
    packed += '\0';
    i += run;
  }
  flush();
  return packed;
}

struct Field {
  std::string name;
  char letter = 'F';
  std::size_t size = 4;
  std::size_t count = 1;

  ScalarType type() const {
    const int power = size == 1 ? 0 : size == 2 ? 1 : size == 4 ? 2 : 3;
    if (letter == 'F') return size == 8 ? ScalarType::float64 : ScalarType::float32;
    return static_cast<ScalarType>(2 * power + (letter == 'U' ? 1 : 0));
  }
};

/// Value k of point i: small whole numbers, negative ones in signed types alone.
inline double value_at(std::size_t i, std::size_t k, char letter) {
  const auto value = static_cast<double>((i * 7 + k * 31) % 100);
  return letter != 'U' && i % 2 == 1 ? -value : value;
}

struct Pcd {
  std::vector<Field> fields{{"x"}, {"y"}, {"z"}};
  std::size_t width = 6, height = 2;
  std::string viewpoint = "0 0 0 1 0 0 0";
  std::string encoding = "ascii";
  std::string line_end = "\n";

  std::size_t points() const { return width * height; }

  std::string header() const {
    std::string names, sizes, types, counts;
    for (const Field& field : fields) {
      names.append(" ").append(field.name);
      sizes.append(" ").append(std::to_string(field.size));
      types.append(" ").append(1, field.letter);
      counts.append(" ").append(std::to_string(field.count));
    }
    std::string text;
    for (const std::string& line :
         {std::string("# .PCD v0.7 - Point Cloud Data file format"), std::string("VERSION 0.7"),
          "FIELDS" + names, "SIZE" + sizes, "TYPE" + types, "COUNT" + counts,
          "WIDTH " + std::to_string(width), "HEIGHT " + std::to_string(height), "VIEWPOINT " + viewpoint,
          "POINTS " + std::to_string(points()), "DATA " + encoding}) {
      text += line + line_end;
    }
    return text;
  }

  std::string ascii() const {
    std::string text;
    for (std::size_t i = 0; i < points(); ++i) {
      std::size_t k = 0;
      for (const Field& field : fields) {
        for (std::size_t c = 0; c < field.count; ++c, ++k) {
          if (k > 0) text += ' ';
          text += std::to_string(static_cast<int>(value_at(i, k, field.letter)));
        }
      }
      text += line_end;
    }
    return text;
  }

  /// Point after point, or with `by_field` field after field.
  std::string binary(bool by_field) const {
    std::vector<std::string> columns(by_field ? fields.size() : 1);
    for (std::size_t i = 0; i < points(); ++i) {
      std::size_t k = 0;
      for (std::size_t f = 0; f < fields.size(); ++f) {
        for (std::size_t c = 0; c < fields[f].count; ++c, ++k) {
          columns[by_field ? f : 0] += scalar(value_at(i, k, fields[f].letter), fields[f].type());
        }
      }
    }
    std::string bytes;
    for (const std::string& column : columns) bytes += column;
    return bytes;
  }

  std::string bytes() const {
    if (encoding == "ascii") return header() + ascii();
    if (encoding == "binary") return header() + binary(false);
    const std::string data = binary(true);
    const std::string packed = lzf_compress(data);
    return header() + scalar(static_cast<double>(packed.size()), ScalarType::uint32) +
           scalar(static_cast<double>(data.size()), ScalarType::uint32) + packed;
  }
};

}  // namespace cloud_maker
