// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace straightedge {

/// Width and height in pixels. Both are at least 1 for an image with content.
struct Size {
  std::int32_t width = 0;
  std::int32_t height = 0;

  constexpr bool operator==(const Size&) const noexcept = default;
};

/// A picture in somebody else's memory: rows of `width` elements, `stride` bytes from one row to the
/// next. The stride may be any multiple of the element's alignment that is at least one row long.
/// Pixel (x, y) is column x of row y; row 0 is the top.
template <class T>
struct ImageView {
  T* data = nullptr;
  std::int32_t width = 0;
  std::int32_t height = 0;
  std::ptrdiff_t stride = 0;  ///< bytes

  constexpr ImageView() noexcept = default;
  constexpr ImageView(T* pixels, Size size) noexcept
      : ImageView(pixels, size, static_cast<std::ptrdiff_t>(sizeof(T)) * size.width) {}
  constexpr ImageView(T* pixels, Size size, std::ptrdiff_t stride_bytes) noexcept
      : data(pixels), width(size.width), height(size.height), stride(stride_bytes) {}

  /// A view that may write serves where one that reads is wanted.
  constexpr operator ImageView<const T>() const noexcept
    requires(!std::is_const_v<T>)
  {
    return {data, size(), stride};
  }

  constexpr Size size() const noexcept { return {width, height}; }

  T* row(std::int32_t y) const noexcept {
    using Byte = std::conditional_t<std::is_const_v<T>, const unsigned char, unsigned char>;
    return reinterpret_cast<T*>(reinterpret_cast<Byte*>(data) + y * stride);
  }
  T& at(std::int32_t x, std::int32_t y) const noexcept { return row(y)[x]; }
  bool contains(std::int32_t x, std::int32_t y) const noexcept {
    return x >= 0 && y >= 0 && x < width && y < height;
  }

  /// Has pixels, and rows that do not overlap.
  constexpr bool valid() const noexcept {
    return data != nullptr && width > 0 && height > 0 &&
           stride >= static_cast<std::ptrdiff_t>(sizeof(T)) * width &&
           stride % static_cast<std::ptrdiff_t>(alignof(T)) == 0;
  }
};

using GrayView = ImageView<const std::uint8_t>;  ///< 8-bit gray, read only

}  // namespace straightedge
