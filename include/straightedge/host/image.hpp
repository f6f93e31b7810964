// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <utility>
#include <vector>

#include "straightedge/image.hpp"

namespace straightedge {

namespace detail {

/// Elements that are given no value have none, where std::allocator would clear them.
template <class T>
struct UnclearedAllocator : std::allocator<T> {
  template <class U>
  struct rebind {
    using other = UnclearedAllocator<U>;
  };
  using std::allocator<T>::allocator;
  template <class U>
  void construct(U* place) noexcept {
    ::new (static_cast<void*>(place)) U;
  }
  template <class U, class... Values>
  void construct(U* place, Values&&... values) {
    ::new (static_cast<void*>(place)) U(std::forward<Values>(values)...);
  }
};

}  // namespace detail

/// An image that owns its pixels, rows without gaps. Converts to the views that the core takes.
template <class T>
class Image {
 public:
  Image() = default;
  explicit Image(Size size, T value = T{})
      : size_(size),
        pixels_(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height), value) {}

  /// One whose pixels are all to be written: until then they have no value.
  static Image for_overwrite(Size size) {
    Image image;
    image.size_ = size;
    image.pixels_.resize(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
    return image;
  }

  Size size() const noexcept { return size_; }
  std::int32_t width() const noexcept { return size_.width; }
  std::int32_t height() const noexcept { return size_.height; }
  bool empty() const noexcept { return pixels_.empty(); }

  ImageView<T> view() noexcept { return {pixels_.data(), size_}; }
  ImageView<const T> view() const noexcept { return {pixels_.data(), size_}; }
  operator ImageView<const T>() const noexcept { return view(); }

  T& at(std::int32_t x, std::int32_t y) noexcept { return view().at(x, y); }
  const T& at(std::int32_t x, std::int32_t y) const noexcept { return view().at(x, y); }

  bool operator==(const Image&) const = default;

 private:
  Size size_;
  std::vector<T, detail::UnclearedAllocator<T>> pixels_;
};

struct Rgb {
  unsigned char red = 0, green = 0, blue = 0;
  bool operator==(const Rgb&) const = default;
};

}  // namespace straightedge
