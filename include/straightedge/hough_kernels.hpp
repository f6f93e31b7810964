// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

/// The inner loops of the progressive Hough transform that votes ahead (hough_progressive.hpp): a table of
/// functions for each instruction set. All tables give the same numbers. Which of them this machine can run,
/// the application must know (host/kernels.hpp asks the processor).
namespace straightedge {

/// The rows of the accumulator, one for each angle, by `cell(n, x, y)`: x times the cosine plus y times the
/// sine plus 1.5 * 2^23, all in float; the sum's bits plus the row's offset are the number of the cell.
struct HoughRows {
  const float* cosines = nullptr;
  const float* sines = nullptr;
  const std::uint32_t* offsets = nullptr;
  std::int32_t angles = 0;
};

/// Pixels that vote together.
inline constexpr std::size_t hough_batch_room = 64;

/// Room for 64, of which `count` are used; the rest is anything finite.
struct HoughBatch {
  float x[hough_batch_room] = {};
  float y[hough_batch_room] = {};
  std::int32_t count = 0;
};

/// The first of the angles that has the most votes; `angle` negative: none has enough.
struct HoughCandidate {
  std::int32_t votes = 0;
  std::int32_t angle = -1;
};

/// For accumulators whose cells are of type Cell.
template <class Cell>
struct HoughCellKernels {
  /// One more vote in the cells of all pixels of the batch, for every angle. most[i], of which there are
  /// `hough_batch_room`: the most votes that one of pixel i's cells has, after its own vote and those of the
  /// pixels before it.
  void (*cast)(Cell* cells, const HoughRows& rows, const HoughBatch& batch, Cell* most) noexcept;

  /// One vote less.
  void (*take_off)(Cell* cells, const HoughRows& rows, const HoughBatch& batch) noexcept;

  /// What pixel `at` of the batch found when it voted, though those behind it have voted as well: their
  /// votes do not count. The first angle with the most votes, if these are more than `best` has, else `best`.
  HoughCandidate (*find)(const Cell* cells, const HoughRows& rows, const HoughBatch& batch, std::int32_t at,
                         HoughCandidate best) noexcept;
};

struct HoughKernels {
  HoughCellKernels<std::uint8_t> bytes;
  HoughCellKernels<std::int16_t> words;

  /// The columns of the edge pixels of a row, ascending, and how many. `columns` has room for width + 8.
  std::int32_t (*edge_columns)(const std::uint8_t* row, std::int32_t width, std::uint16_t* columns) noexcept;
};

/// Portable loops; what every other table is compared with.
extern const HoughKernels plain_hough_kernels;

#if defined(__x86_64__)
extern const HoughKernels avx2_hough_kernels;    ///< needs AVX2 and POPCNT
extern const HoughKernels avx512_hough_kernels;  ///< needs AVX-512 F, BW, DQ, VL and POPCNT
#endif

}  // namespace straightedge
