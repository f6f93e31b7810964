// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "ransac/fast/lanes.hpp"
#include "straightedge/ransac_kernels.hpp"

// Whole numbers are summed over bits, one a pixel, by what else has nothing to do: the registers of lanes
// have enough with the sums of residuals.
namespace straightedge::STRAIGHTEDGE_KERNEL_SET {

/// Of the bits of every byte three sums in one number: how many there are, their places among sixteen, and
/// the squares of these.
struct ByteSums {
  static constexpr int places = 24, squares = 44;  ///< the first bits of these sums

  std::uint64_t left[256] = {}, right[256] = {};  ///< of places 0 to 7, 8 to 15

  constexpr ByteSums() noexcept {
    for (std::uint64_t byte = 0; byte < 256; ++byte) {
      for (std::uint64_t i = 0; i < 8; ++i) {
        if ((byte >> i & 1) == 0) continue;
        left[byte] += of_bit(i);
        right[byte] += of_bit(i + 8);
      }
    }
  }
  static constexpr std::uint64_t of_bit(std::uint64_t place) noexcept {
    return 1 + (place << places) + (place * place << squares);
  }
};

inline constexpr ByteSums byte_sums;

/// One bit for each pixel of a row, in groups of sixteen.
class PixelBits {
 public:
  explicit PixelBits(std::int32_t pixels) noexcept : end_((groups_in(pixels) + 1) * in_group) {
    __builtin_memset(bytes_, 0, in_group);
    __builtin_memset(bytes_ + end_, 0, word);
  }
  static std::int32_t groups_in(std::int32_t pixels) noexcept { return (pixels + 15) / 16; }

  /// A group's lanes from `first` on, a multiple of eight.
  std::uint8_t* at(std::ptrdiff_t group, std::int32_t first) noexcept {
    return before(group, first) + in_group;
  }
  /// Those of the group before it; of the first one, none.
  std::uint8_t* before(std::ptrdiff_t group, std::int32_t first) noexcept {
    return bytes_ + in_group * group + first / 8;
  }

  std::uint32_t count() const noexcept {
    std::uint32_t n = 0;
    for (std::int32_t i = in_group; i < end_; i += word) {
      std::uint64_t bits = 0;
      __builtin_memcpy(&bits, bytes_ + i, word);
      n += static_cast<std::uint32_t>(__builtin_popcountll(bits));
    }
    return n;
  }

 private:
  static constexpr std::int32_t in_group = 2, word = 8;  // bytes

  std::int32_t end_;
  std::uint8_t bytes_[in_group + ransac_most_pixels / 8 + word];
};

struct ColumnSums {
  std::uint32_t n = 0, u = 0, uu = 0;  ///< number, column, its square

  void operator+=(const ColumnSums& other) noexcept {
    n += other.n;
    u += other.u;
    uu += other.uu;
  }
};

/// Sums over the columns of a row's bits. Group g of G is added to `once` once, to `times` G - 1 - g times,
/// and to `pairs` as often as there are pairs of groups behind it: no multiplication until the end.
class ColumnCounter {
 public:
  /// The next group: its lanes from `first` on.
  void add(const std::uint8_t* bytes, std::int32_t first) noexcept {
    pairs_ += times_;
    times_ += once_;
    if constexpr (Floats::count == 16) {
      once_ += byte_sums.left[bytes[0]] + byte_sums.right[bytes[1]];
    } else {
      once_ += first == 0 ? byte_sums.left[*bytes] : byte_sums.right[*bytes];
    }
  }

  ColumnSums sums(std::int32_t groups) const noexcept {
    const auto last = static_cast<std::uint64_t>(groups - 1);
    const std::uint64_t n = number(once_), behind = number(times_), squares = 2 * number(pairs_) + behind;
    const std::uint64_t g = last * n - behind, gg = last * (last * n - 2 * behind) + squares;
    const std::uint64_t j = place(once_), gj = last * j - place(times_), jj = once_ >> ByteSums::squares;
    return {static_cast<std::uint32_t>(n), static_cast<std::uint32_t>(16 * g + j),
            static_cast<std::uint32_t>(256 * gg + 32 * gj + jj)};
  }

 private:
  // Of a whole row there are 21 bits of numbers in `pairs`, 18 of places in `times` and 16 of squares in
  // `once`. What else lies above these in `times` and `pairs` runs over; nobody reads it.
  static_assert(ransac_most_pixels <= 768);

  static std::uint64_t number(std::uint64_t sums) noexcept {
    return sums & ((std::uint64_t{1} << ByteSums::places) - 1);
  }
  static std::uint64_t place(std::uint64_t sums) noexcept {
    return sums >> ByteSums::places & ((std::uint64_t{1} << (ByteSums::squares - ByteSums::places)) - 1);
  }

  std::uint64_t once_ = 0, times_ = 0, pairs_ = 0;
};

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
