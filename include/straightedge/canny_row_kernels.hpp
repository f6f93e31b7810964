// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "straightedge/thresholds.hpp"

/// The inner loops of the forms of Canny that keep rows instead of planes (canny_fused.hpp, canny_rows.hpp):
/// one table of functions, each making one row. The plain table is always there; others hold faster twins,
/// which give the same numbers. Which of them this machine can run, the application must know
/// (host/kernels.hpp asks the processor): a table's functions stop a program that has not the instructions.
///
/// What all rows have in common
///   - `width` elements, at least 1, and none of the rows overlap.
///   - All rows may be read, and rows that are made may be written, up to the next multiple of
///     `canny_row_step` elements: what lies there is anything, and nobody looks at what it becomes, except
///     that classes beyond the width stay or become none.
///   - Where a function reads neighbours along the row, the elements left and right of it are there.
namespace straightedge {

/// Rows are allocated in multiples of this many elements: as many as the widest kernels take at once.
#if defined(__x86_64__)
inline constexpr std::size_t canny_row_step = 32;
#else
inline constexpr std::size_t canny_row_step = 4;
#endif

/// Three rows of magnitudes M around the row that is looked at, and its gradient.
template <class M>
struct MagnitudeRows {
  const M* above = nullptr;  ///< one neighbour on both sides, as all three
  const M* here = nullptr;
  const M* below = nullptr;
  const std::int16_t* dx = nullptr;
  const std::int16_t* dy = nullptr;
};

struct CannyRowKernels {
  /// Blur, down the columns: sums[x] = taps[0] rows[0][x] + taps[1] rows[1][x] + ... `tap_count` is odd and
  /// at least 3; the taps are symmetric and add up to 256.
  void (*blur_down)(const std::uint8_t* const* rows, const std::uint16_t* taps, std::int32_t tap_count,
                    std::uint16_t* sums, std::int32_t width) noexcept;

  /// Blur, along the row: blurred[x] = (taps[0] sums[x − m] + ... + taps[2 m] sums[x + m] + 32768) / 65536,
  /// m = tap_count / 2.
  void (*blur_along)(const std::uint16_t* sums, const std::uint16_t* taps, std::int32_t tap_count,
                     std::uint8_t* blurred, std::int32_t width) noexcept;

  /// Sobel's operator of side 3, 5 and 7 on as many rows, each with side / 2 neighbours on both sides, and
  /// the magnitude: |dx| + |dy|, at most 24 480, or dx² + dy², below 2^29. Side 7 in sixteenths, as
  /// `GradientScale::sixteenth`. `scratch` is room for 2 (width + side − 1) numbers; null for side 3.
  template <class M>
  using Gradient = void (*)(const std::uint8_t* const* rows, std::int16_t* scratch, std::int16_t* dx,
                            std::int16_t* dy, M* magnitude, std::int32_t width) noexcept;
  Gradient<std::uint16_t> gradient_l1[3];
  Gradient<std::uint32_t> gradient_l2[3];

  /// Suppression with the double threshold: a row of `EdgeClass` (suppress.hpp). Gives back how many pixels
  /// are strong. Negative thresholds act like 0. For gradients of a Sobel operator, at most 12 240, and 0
  /// only where the magnitude is.
  template <class M>
  using Suppress = std::uint32_t (*)(const MagnitudeRows<M>& rows, MagnitudeThresholds limits,
                                     std::uint8_t* classes, std::int32_t width) noexcept;
  Suppress<std::uint16_t> suppress_l1;
  Suppress<std::uint32_t> suppress_l2;

  /// A row of classes as words of 64 pixels: 8 bytes with a bit for each that is weak or strong, 8 with one
  /// for each that is strong, in the machine's order of bytes, the leftmost pixel in the lowest bit. Reads
  /// classes up to the next multiple of 64.
  void (*pack_classes)(const std::uint8_t* classes, std::uint8_t* words, std::int32_t width) noexcept;

  /// The other way: 255 where the second bit of the pixel is set, else 0. Gives back how many are. `words`
  /// may begin where `edges` does: works from the last word to the first.
  std::uint32_t (*spread_edges)(const std::uint8_t* words, std::uint8_t* edges, std::int32_t width) noexcept;
};

/// Portable loops; what every other table is compared with.
extern const CannyRowKernels plain_canny_row_kernels;

#if defined(__x86_64__)
extern const CannyRowKernels sse2_canny_row_kernels;
extern const CannyRowKernels avx2_canny_row_kernels;    ///< needs AVX2 and POPCNT
extern const CannyRowKernels avx512_canny_row_kernels;  ///< needs AVX-512 F, BW, DQ, VL and POPCNT
#endif

/// What the row forms need to know besides `CannyOptions`.
struct CannyRowOptions {
  /// Pixels that may wait for the flood fill, at least 1; 4 bytes each. The result does not depend on it,
  /// the time of pictures full of branching edges does.
  std::uint32_t worklist = 512;
  const CannyRowKernels* kernels = &plain_canny_row_kernels;  ///< not null
  /// Parts of the picture that `FusedCanny` works on one by one or, by `run_with`, at the same time, at least
  /// 1; each has its own rows and worklist. Edges are the same for any number.
  std::int32_t stripes = 1;
};

}  // namespace straightedge
