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
  std::int32_t window = 0;  ///< angles of a gradient window, below `angles`; behind the last angle, the first
                            ///< come again: window + hough_rows_more of them
};

/// Windows are read so many angles at a time.
inline constexpr std::size_t hough_rows_more = 16;

/// Pixels that vote together.
inline constexpr std::size_t hough_batch_room = 128;

/// Room for hough_batch_room, of which `count` are used; the rest is anything finite.
struct HoughBatch {
  float x[hough_batch_room] = {};
  float y[hough_batch_room] = {};
  std::int32_t count = 0;
};

/// For each pixel of a batch the first of the angles at which its cell has the most votes; 0 votes where none
/// has enough of them.
struct HoughSeen {
  std::int16_t votes[hough_batch_room] = {};
  std::uint16_t angles[hough_batch_room] = {};
};

/// A pixel's turn. Those of the batch behind it have voted, and those that leave have not taken their votes
/// off yet; neither count.
struct HoughTurn {
  const HoughBatch* voting = nullptr;
  std::int32_t at = 0;  ///< the pixel's number
  const HoughBatch* leaving = nullptr;
};

/// A line that a pixel may lie on.
struct HoughCandidate {
  std::int32_t votes = 0;
  std::int32_t angle = -1;  ///< negative: no angle has enough votes
};

/// For accumulators whose cells are of type Cell.
template <class Cell>
struct HoughCellKernels {
  /// One more vote in the cells of all pixels of the batch, at every angle. What each has seen, if that is
  /// `threshold` votes or more: its own vote and those of the pixels before it count.
  void (*cast)(Cell* cells, const HoughRows& rows, const HoughBatch& batch, std::int32_t threshold,
               HoughSeen& seen) noexcept;

  /// One vote less.
  void (*take_off)(Cell* cells, const HoughRows& rows, const HoughBatch& batch) noexcept;

  /// What a pixel sees when it is its turn: the first angle with the most votes, at least `threshold`. `seen`
  /// is what it saw when it voted, and cells have only lost votes since.
  HoughCandidate (*find)(const Cell* cells, const HoughRows& rows, const HoughTurn& turn, HoughCandidate seen,
                         std::int32_t threshold) noexcept;

  /// One pixel of the batch after the other, from number `from` on, votes for the angles of its window, which
  /// begins at its `firsts`, until one sees `threshold` votes or more: its number, and the first angle with
  /// the most votes. The batch's count, when none does.
  std::int32_t (*cast_in_windows)(Cell* cells, const HoughRows& rows, const HoughBatch& batch,
                                  const std::uint16_t* firsts, std::int32_t from, std::int32_t threshold,
                                  HoughCandidate& seen) noexcept;

  /// One vote less in the window of each.
  void (*take_off_in_windows)(Cell* cells, const HoughRows& rows, const HoughBatch& batch,
                              const std::uint16_t* firsts) noexcept;
};

/// How the angle at which a pixel's gradient window begins follows from its gradient.
struct HoughWindowRule {
  double half_window = 0;      ///< radians
  double theta_step = 1;       ///< radians
  std::int32_t half_turn = 1;  ///< angles in pi, below 65535
};

/// Stands for the whole circle, where the gradient is null.
inline constexpr std::uint16_t hough_no_direction = 65535;

/// Directions that are found together.
inline constexpr std::int32_t hough_some_directions = 16;

struct HoughKernels {
  HoughCellKernels<std::uint8_t> bytes;
  HoughCellKernels<std::int16_t> words;

  /// The states (pixel_states.hpp) of a row's pixels: waiting where there is an edge, else gone.
  void (*mark_edges)(const std::uint8_t* row, std::int32_t width, std::uint8_t* states) noexcept;

  /// The columns of the pixels that are marked so, ascending, and how many. `columns` has room for width + 8.
  std::int32_t (*marked_columns)(const std::uint8_t* states, std::int32_t width,
                                 std::uint16_t* columns) noexcept;

  /// The columns of the edge pixels of a row, ascending, and how many. `columns` has room for width + 8.
  std::int32_t (*edge_columns)(const std::uint8_t* row, std::int32_t width, std::uint16_t* columns) noexcept;

  /// For each of `count` gradients (dx, dy): the first angle of the window round it, in [0, half_turn), or
  /// `hough_no_direction`. All three have room for a whole number of times `hough_some_directions`.
  void (*first_angles)(const std::int16_t* dx, const std::int16_t* dy, std::int32_t count,
                       const HoughWindowRule& rule, std::uint16_t* first) noexcept;
};

/// Portable loops; what every other table is compared with.
extern const HoughKernels plain_hough_kernels;

#if defined(__x86_64__)
extern const HoughKernels avx2_hough_kernels;    ///< needs AVX2 and POPCNT
extern const HoughKernels avx512_hough_kernels;  ///< needs AVX-512 F, BW, DQ, VL and POPCNT
#endif

}  // namespace straightedge
