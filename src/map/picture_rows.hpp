// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

/// The loops over all pixels by which a line map understands its picture: a table of functions for each
/// instruction set. All tables give the same numbers.
namespace straightedge {

/// The gray `black` and what is darker becomes 0, `black + span` and what is lighter 255.
struct GrayStretch {
  std::int32_t black = 0;
  std::int32_t span = 255;  ///< 1..255
};

/// Neighbours along a row of which the right one is neither black nor white.
struct GrainCount {
  std::int64_t pairs = 0;
  std::int64_t same = 0;  ///< of them those of one gray
};

struct PictureRowKernels {
  void (*stretch)(const std::uint8_t* row, std::int32_t width, GrayStretch rule, std::uint8_t* out) noexcept;

  void (*count_grain)(const std::uint8_t* row, std::int32_t width, GrainCount& count) noexcept;

  /// For pixels 1 to width - 2: 1 where all eight neighbours are lighter by more than the contrast. False:
  /// there is none.
  bool (*find_lone)(const std::uint8_t* above, const std::uint8_t* here, const std::uint8_t* below,
                    std::int32_t width, std::int32_t contrast, std::uint8_t* lone) noexcept;

  /// Medians of 4x4 blocks side by side, `count` of them, from these four rows on; the upper one of the two
  /// in the middle.
  void (*block_medians)(const std::uint8_t* const* rows, std::int32_t count, std::uint8_t* medians) noexcept;
};

extern const PictureRowKernels plain_picture_row_kernels;

#if defined(__x86_64__)
extern const PictureRowKernels avx2_picture_row_kernels;
extern const PictureRowKernels avx512_picture_row_kernels;
#endif

}  // namespace straightedge
