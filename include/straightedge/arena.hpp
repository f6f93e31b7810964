// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace straightedge {

/// Hands out pieces of the caller's bytes, one after another, each aligned to 64 bytes. Used in
/// `prepare` alone: `run` never takes memory. There is nothing to give back.
///
/// Sizing and taking are one text: run the same calls on `Arena::measure()` and `used()` is the
/// number of bytes that a real arena needs (with room for an unaligned start).
class Arena {
 public:
  static constexpr std::size_t alignment = 64;

  /// An arena over the caller's memory.
  explicit Arena(std::span<std::byte> bytes) noexcept : next_(bytes.data()), left_(bytes.size()) {
    const auto address = reinterpret_cast<std::uintptr_t>(next_);
    const std::size_t skip = (alignment - address % alignment) % alignment;
    used_ = skip;
    if (skip > left_) {
      failed_ = true;
      return;
    }
    next_ += skip;
    left_ -= skip;
  }

  /// An arena that only counts; every span it hands out is empty.
  static constexpr Arena measure() noexcept { return Arena(); }

  /// `count` elements of T, uninitialised. Empty when the memory does not suffice.
  template <class T>
  constexpr std::span<T> take(std::size_t count) noexcept {
    if (count > (SIZE_MAX - alignment) / sizeof(T)) {
      failed_ = true;
      return {};
    }
    const std::size_t bytes = (count * sizeof(T) + alignment - 1) / alignment * alignment;
    used_ += bytes;
    if (measuring_) return {};
    if (bytes > left_) {
      failed_ = true;
      return {};
    }
    T* start = reinterpret_cast<T*>(next_);
    next_ += bytes;
    left_ -= bytes;
    return {start, count};
  }

  constexpr bool failed() const noexcept { return failed_; }
  constexpr std::size_t used() const noexcept { return used_; }

 private:
  constexpr Arena() noexcept : used_(alignment - 1), measuring_(true) {}

  std::byte* next_ = nullptr;
  std::size_t left_ = 0;
  std::size_t used_ = 0;
  bool measuring_ = false;
  bool failed_ = false;
};

}  // namespace straightedge
