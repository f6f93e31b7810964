// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "straightedge/image.hpp"

namespace same_bits {

/// FNV-1a over 64 bits. Numbers go in byte by byte, lowest first, in their own width; so hash types whose
/// width is the same everywhere, never long or std::size_t. Of structs each member by itself: what lies
/// between them is nobody's.
///
/// NaN is marked, since processors make it with different bits: no result may have one.
class Hash {
 public:
  template <class T>
  void add(const T& value) noexcept {
    if constexpr (std::is_same_v<T, bool>) {
      add_bytes(value ? 1 : 0, 1);
    } else if constexpr (std::is_enum_v<T>) {
      add(static_cast<std::underlying_type_t<T>>(value));
    } else if constexpr (std::is_integral_v<T>) {
      add_bytes(static_cast<std::make_unsigned_t<T>>(value), sizeof(T));
    } else if constexpr (std::is_same_v<T, float>) {
      const auto bits = std::bit_cast<std::uint32_t>(value);
      nan_ = nan_ || (bits & 0x7FFFFFFFU) > 0x7F800000U;
      add_bytes(bits, 4);
    } else if constexpr (std::is_same_v<T, double>) {
      const auto bits = std::bit_cast<std::uint64_t>(value);
      nan_ = nan_ || (bits & 0x7FFFFFFFFFFFFFFFU) > 0x7FF0000000000000U;
      add_bytes(bits, 8);
    } else {
      add_to(*this, value);
    }
  }
  /// One after another. Compilers evaluate arguments in any order: what a call among them changes may stand
  /// beside it by reference only.
  template <class... T>
  requires(sizeof...(T) > 1) void add(const T&... values) noexcept { (add(values), ...); }

  std::uint64_t value() const noexcept { return value_; }
  bool has_nan() const noexcept { return nan_; }

 private:
  void add_bytes(std::uint64_t bits, std::size_t bytes) noexcept {
    for (std::size_t i = 0; i < bytes; ++i) {
      value_ = (value_ ^ (bits & 0xFFU)) * 0x100000001B3U;
      bits >>= 8U;
    }
  }

  std::uint64_t value_ = 0xCBF29CE484222325U;
  bool nan_ = false;
};

template <class T, std::size_t n>
void add_to(Hash& hash, const std::array<T, n>& values) noexcept {
  for (const T& value : values) hash.add(value);
}

/// All that a function wrote: how many, and each.
template <class T>
void add_to(Hash& hash, const std::span<T>& values) noexcept {
  hash.add(static_cast<std::uint64_t>(values.size()));
  for (const T& value : values) hash.add(value);
}

/// The pixels, not what lies between the rows.
template <class T>
void add_to(Hash& hash, const straightedge::ImageView<T>& image) noexcept {
  hash.add(image.width, image.height);
  for (std::int32_t y = 0; y < image.height; ++y) {
    const T* row = image.row(y);
    for (std::int32_t x = 0; x < image.width; ++x) hash.add(row[x]);
  }
}

}  // namespace same_bits
