// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace straightedge::io {

/// The number types of point cloud files.
enum class ScalarType : std::uint8_t {
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  int64,
  uint64,
  float32,
  float64
};

constexpr std::size_t size_of(ScalarType type) noexcept {
  constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

constexpr bool is_whole(ScalarType type) noexcept {
  return type < ScalarType::float32;
}

enum class ByteOrder : std::uint8_t { little, big };

/// The bytes as an unsigned number, whatever the machine's own order.
constexpr std::uint64_t read_unsigned(const char* bytes, std::size_t count, ByteOrder order) noexcept {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = order == ByteOrder::big ? i : count - 1 - i;
    value = value << 8 | static_cast<unsigned char>(bytes[at]);
  }
  return value;
}

constexpr double read_scalar(const char* bytes, ScalarType type, ByteOrder order) noexcept {
  const std::uint64_t value = read_unsigned(bytes, size_of(type), order);
  switch (type) {
    case ScalarType::int8:
      return static_cast<std::int8_t>(value);
    case ScalarType::int16:
      return static_cast<std::int16_t>(value);
    case ScalarType::int32:
      return static_cast<std::int32_t>(value);
    case ScalarType::int64:
      return static_cast<double>(static_cast<std::int64_t>(value));
    case ScalarType::float32:
      return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(value)));
    case ScalarType::float64:
      return std::bit_cast<double>(value);
    default:
      return static_cast<double>(value);
  }
}

/// Clouds hold floats. A number beyond their range becomes infinite, which is no reading.
constexpr float coordinate_from(double value) noexcept {
  constexpr auto largest = static_cast<double>(std::numeric_limits<float>::max());
  if (value > largest) return std::numeric_limits<float>::infinity();
  if (value < -largest) return -std::numeric_limits<float>::infinity();
  return static_cast<float>(value);
}

/// One coordinate of all points in a file's bytes.
struct Column {
  const char* first = nullptr;
  std::size_t stride = 0;  ///< bytes from one point to the next
  ScalarType type = ScalarType::float32;
  ByteOrder order = ByteOrder::little;
};

inline std::vector<float> coordinates_of(const Column& column, std::size_t count) {
  std::vector<float> values(count);
  const char* at = column.first;
  for (float& value : values) {
    value = coordinate_from(read_scalar(at, column.type, column.order));
    at += column.stride;
  }
  return values;
}

}  // namespace straightedge::io
