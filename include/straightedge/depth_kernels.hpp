// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

/// The inner loops of DepthCells and FramePlanes: one table of functions. The plain table is always there;
/// others are made from the same text for more instructions, and give the same bits. Which of them this
/// machine can run, the application must know (host/kernels.hpp asks the processor): a table's functions
/// stop a program that has not the instructions.
namespace straightedge {

/// Rows of 1/z; strides count elements.
struct DepthRows {
  const float* first = nullptr;
  std::ptrdiff_t stride = 0;
};

/// Cells one after another, a row of numbers for each kind: readings, means of u, v and q, and the sums of
/// products of the deviations from these means, in the order of DepthCell (depth_cells.hpp).
struct DepthCellRows {
  static constexpr std::int32_t kinds = 10;
  float* first = nullptr;
  std::ptrdiff_t apart = 0;  ///< from one kind to the next
};

/// What sixteen cells may take. Plane k is surface k.
struct DepthCellTask {
  static constexpr std::int32_t cells = 16, most_asked = 30;
  DepthCellRows at;         ///< the first one's; all sixteen must be there to be read
  std::uint32_t open = 0;   ///< bit i: cell i may take a plane, if it has readings enough
  std::uint32_t given = 0;  ///< of these: it takes the one that it asks for
  float least = 0;          ///< readings
  std::int32_t planes = 0;  ///< that are tried where none of those asked fits; 0: the cell stays undecided
  std::int32_t asked = 0;   ///< planes that some of them try first
  std::uint16_t plane[most_asked];
  std::uint16_t of[most_asked];  ///< bit i: by cell i
  /// Deviation of 1/z as in DepthChoice; what follows are mean squared residuals in its squares.
  float noise = 0, noise_of_square = 0;
  float pure_of_asked = 0;  ///< below this the best of those asked is the cell's
  float pure = 0;           ///< else the best of all is, below this
};

/// A rectangle of pixels whose only plane is at + along x + down y, x and y from its corner.
struct DepthBlock {
  static constexpr std::int32_t widest = 256;
  DepthRows rows;
  std::int32_t width = 0, height = 0;
  double at = 0, along = 0, down = 0;  ///< 1/metre
  float limit = 0;                     ///< the gate, 1/metre
  std::uint16_t label = 0;
};

/// Planes to choose from for 4x4 pixels: plane k is at[k] + along[k] x + down[k] y, x and y from their
/// corner.
struct DepthChoice {
  static constexpr std::int32_t side = 4, pixels = side * side, most_planes = 9;
  DepthRows around;  ///< the pixels with one more on every side; 0 is no reading
  float at[most_planes], along[most_planes], down[most_planes];
  std::uint16_t label[most_planes];
  std::int32_t planes;
  /// Deviation of 1/z where it is q: the larger of noise and noise_of_square q²; the gate is `sigmas` of it.
  float noise, noise_of_square, sigmas;
};

/// Planes as DepthSurface (depth_cells.hpp), an array for each coefficient.
struct DepthSurfaces {
  float *c = nullptr, *x = nullptr, *y = nullptr, *xx = nullptr, *xy = nullptr, *yy = nullptr;
};

/// Cells one after another, and what takes a plane's cell for wholly the plane's.
struct DepthWholeCells {
  /// Several planes are around a cell; `inner_border`: one that is wholly its own plane's, as far as the
  /// others around do not matter.
  static constexpr std::uint16_t border = 0xFFFF, inner_border = 0xFFFE;
  static constexpr std::uint16_t mark = 0x4000;
  DepthCellRows at;
  const std::uint16_t* own = nullptr;  ///< the cells' labels
  std::int32_t cells = 0;
  float readings = 0;  ///< all of a cell's pixels
  /// Deviation of 1/z as in DepthChoice; the mean squared residual lies below `most` of its squares.
  float noise = 0, noise_of_square = 0, most = 0;
};

struct DepthCellPlanes {
  static constexpr std::uint16_t undecided = 0xFFFF;
  std::uint16_t label[DepthCellTask::cells];  ///< 1 + the plane, 0: none
  float mean[DepthCellTask::cells];           ///< squared residual from it, in squares of the deviation
};

struct DepthKernels {
  /// scale / raw, rounded once; 0 where raw is 0.
  void (*invert)(const std::uint16_t* raw, std::int32_t width, float scale, float* inverse) noexcept;

  /// A row's readings, which are above 0 and at most `most`, as they are, and 0 for the rest and where the
  /// mask (which may be null) is not 0.
  void (*keep_readings)(const float* inverse, const std::uint16_t* mask, std::int32_t width, float most,
                        float* kept) noexcept;
  /// The squares of side 4, 8 or 16 that lie in a row from the corner on, which is at (left, top) from the
  /// picture's middle. What is not above 0 is no reading. `counts`: readings, 255 at most.
  void (*build_cells)(const DepthRows& corner, std::int32_t side, std::int32_t cells, double left, double top,
                      const DepthCellRows& out, std::uint8_t* counts) noexcept;
  /// Each cell from two beside one another of one row and of the next, which lies `below` further on.
  void (*join_cells)(const DepthCellRows& from, std::ptrdiff_t below, std::int32_t cells,
                     const DepthCellRows& out) noexcept;
  /// Cells that are not open get no label.
  void (*choose_planes)(const DepthCellTask& task, const DepthSurfaces& surfaces,
                        DepthCellPlanes& planes) noexcept;

  /// Adds DepthWholeCells::mark to the labels of cells that are wholly the plane's; such a `border` cell
  /// becomes `inner_border`, others stay.
  void (*mark_whole)(const DepthWholeCells& task, const DepthSurfaces& surfaces,
                     std::uint16_t* labels) noexcept;
  /// A row of pixels from a row of labels with such marks: the label where the mark is, and 0 elsewhere.
  void (*spread_labels)(const std::uint16_t* cells, std::int32_t side, std::int32_t width,
                        std::uint16_t* labels) noexcept;

  /// Readings within the gate get the label, all others 0; how many got it.
  std::int32_t (*label_block)(const DepthBlock& block, std::uint16_t* labels, std::ptrdiff_t stride) noexcept;

  /// Each label k of a row becomes by[k]. Both are below `names`.
  void (*rename_row)(std::uint16_t* labels, std::int32_t count, const std::uint16_t* by,
                     std::int32_t names) noexcept;

  /// What the labels of cells and of those around them in three rows are: 0, the only one beside 0, or 65535:
  /// several. Outside of the rows there are none.
  void (*look_around)(const std::uint16_t* above, const std::uint16_t* here, const std::uint16_t* below,
                      std::int32_t width, std::uint16_t* around) noexcept;

  /// The label of the nearest plane within the gate for each of the 4x4 pixels, row by row, or 0. Where two
  /// planes are nearly as near (4 deviations), the mean of the 3x3 pixels of the pixel's own surface (8
  /// deviations) decides.
  void (*choose)(const DepthChoice& square, std::uint16_t* labels) noexcept;
};

/// What the firmware runs and what every other table is compared with.
extern const DepthKernels plain_depth_kernels;

#if defined(__x86_64__)
extern const DepthKernels avx2_depth_kernels;    ///< needs AVX2 and POPCNT
extern const DepthKernels avx512_depth_kernels;  ///< needs AVX-512 F, BW, DQ, VL and POPCNT
#endif

}  // namespace straightedge
