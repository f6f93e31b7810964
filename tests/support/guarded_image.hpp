// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstring>
#include <vector>

#include "straightedge/image.hpp"

namespace support {

/// An image with a gap after every row and a margin before and behind it, all filled with a pattern that
/// must still be there afterwards: `guards_intact`.
template <class T>
class GuardedImage {
 public:
  explicit GuardedImage(straightedge::Size size, int gap = 5, T value = T{})
      : size_(size),
        stride_((static_cast<std::size_t>(size.width) + static_cast<std::size_t>(gap)) * sizeof(T)),
        bytes_(margin + stride_ * static_cast<std::size_t>(size.height) + margin, pattern) {
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) view().at(x, y) = value;
    }
  }

  straightedge::Size size() const { return size_; }
  straightedge::ImageView<T> view() {
    return {reinterpret_cast<T*>(bytes_.data() + margin), size_, static_cast<std::ptrdiff_t>(stride_)};
  }
  straightedge::ImageView<const T> view() const {
    return {reinterpret_cast<const T*>(bytes_.data() + margin), size_, static_cast<std::ptrdiff_t>(stride_)};
  }
  T& at(int x, int y) { return view().at(x, y); }
  const T& at(int x, int y) const { return view().at(x, y); }

  bool guards_intact() const {
    const std::size_t used = static_cast<std::size_t>(size_.width) * sizeof(T);
    for (std::size_t i = 0; i < bytes_.size(); ++i) {
      const bool outside = i < margin || i >= bytes_.size() - margin || (i - margin) % stride_ >= used;
      if (outside && bytes_[i] != pattern) return false;
    }
    return true;
  }

  bool operator==(const GuardedImage& other) const {
    if (size_ != other.size_) return false;
    for (int y = 0; y < size_.height; ++y) {
      const std::size_t used = static_cast<std::size_t>(size_.width) * sizeof(T);
      if (std::memcmp(view().row(y), other.view().row(y), used) != 0) return false;
    }
    return true;
  }

 private:
  static constexpr std::size_t margin = 64;
  static constexpr unsigned char pattern = 0xA5;

  straightedge::Size size_;
  std::size_t stride_;
  std::vector<unsigned char> bytes_;
};

}  // namespace support
