// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

/// The loops by which a line map reads its picture, over all pixels, edge pixels, or along a line: a table of
/// functions for each instruction set. All tables give the same numbers.
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

/// Edge pixels whose positions are found together.
struct EdgeBatch {
  static constexpr std::int32_t room = 256;
  static constexpr std::int32_t around = 5;
  std::int32_t count = 0;
  std::int32_t x[room], y[room];
  std::int16_t dx[room], dy[room];
  /// At the pixel, in the middle, and two to both sides of it across the edge; 0 too near to the border.
  std::int32_t magnitude[around][room];
  std::int16_t near_dx[around][room], near_dy[around][room];  ///< gradients there, where those are asked for
  double place_x[room], place_y[room], weight[room];          ///< the results
};

/// A straight way through a picture of at least 2x2 pixels: at step s lies the place
/// (x + s · step_x + aside_x, y + s · step_y + aside_y).
struct SampleWay {
  const std::uint8_t* pixels = nullptr;
  std::ptrdiff_t stride = 0;
  std::int32_t width = 0, height = 0;
  double x = 0, y = 0;
  double step_x = 0, step_y = 0;
  double aside_x = 0, aside_y = 0;
};

/// Edge pixels in or near a strip along a line, looked at together.
struct StripBatch {
  static constexpr std::int32_t room = 128;
  std::int32_t count = 0;
  double x[room], y[room];    ///< of their points
  double dx[room], dy[room];  ///< gradients
  double weight[room];
  // The results.
  std::int64_t inside[room];  ///< 1: in the strip, the gradient towards its light side
  double along[room];
  double weight_x[room], weight_y[room];  ///< about the strip's own point
  double weight_xx[room], weight_xy[room], weight_yy[room];
};

/// As Corridor's members.
struct StripRule {
  double px = 0, py = 0;
  double nx = 1, ny = 0;
  double half_width = 0;
  double cos_max_angle = 0;
};

struct PictureRowKernels {
  void (*stretch)(const std::uint8_t* row, std::int32_t width, GrayStretch rule, std::uint8_t* out) noexcept;

  /// How many pixels, from the first on and in whole steps of 64, have the gray of the first.
  std::int32_t (*count_even)(const std::uint8_t* row, std::int32_t width) noexcept;

  void (*count_grain)(const std::uint8_t* row, std::int32_t width, GrainCount& count) noexcept;

  /// For pixels 1 to width - 2: 1 where all eight neighbours are lighter by more than the contrast. False:
  /// there is none, and nothing may have been written.
  bool (*find_lone)(const std::uint8_t* above, const std::uint8_t* here, const std::uint8_t* below,
                    std::int32_t width, std::int32_t contrast, std::uint8_t* lone) noexcept;

  /// Medians of 4x4 blocks side by side, `count` of them, from these four rows on; the upper one of the two
  /// in the middle.
  void (*block_medians)(const std::uint8_t* const* rows, std::int32_t count, std::uint8_t* medians) noexcept;

  /// The magnitudes of the gradients: |dx| + |dy|, or dx² + dy².
  void (*edge_magnitudes)(EdgeBatch& batch, bool squared) noexcept;

  /// edge_position of every pixel of the batch, and 1 / variance.
  void (*edge_places)(EdgeBatch& batch) noexcept;

  /// Which points lie in the strip, and what a line fit sums over them.
  void (*find_inside)(const StripRule& strip, StripBatch& batch) noexcept;

  /// The gray between the pixels at these steps, bilinear; places beyond the border have the border's.
  void (*sample)(const SampleWay& way, const double* steps, std::int32_t count, double* gray) noexcept;

  /// The pixels in which the places at the steps 0, 1, ... lie, a pixel reaching from its number to the next;
  /// 255 outside the picture. Less than 2^31 from it.
  void (*read_nearest)(const SampleWay& way, std::int32_t count, std::uint8_t* gray) noexcept;
};

extern const PictureRowKernels plain_picture_row_kernels;

#if defined(__x86_64__)
extern const PictureRowKernels avx2_picture_row_kernels;
extern const PictureRowKernels avx512_picture_row_kernels;
#endif

}  // namespace straightedge
