// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

/// The inner loops of RansacSearch (ransac_search.hpp): one table of functions. The plain table is always
/// there; others hold the same text compiled for more instructions, which gives the same bits. Which of them
/// this machine can run, the application must know (host/kernels.hpp asks the processor): a table's functions
/// stop a program that has not the instructions.
///
/// Sums are kept in search_lanes partial sums, reading i adding to sum i % 16; they are added up pairwise, 8
/// apart, 4, 2, 1.
namespace straightedge {

inline constexpr std::int32_t search_lanes = 16;

/// Readings one after another: pixel, 1/z, and 1 / gate.
struct SearchReadings {
  const float* u = nullptr;
  const float* v = nullptr;
  const float* q = nullptr;
  const float* w = nullptr;
};

/// 1/z = a u + b v + c.
struct SearchPlane {
  float a = 0, b = 0, c = 0;
};

/// Three readings for each of sixteen planes.
struct SearchTriples {
  float u[3][search_lanes];
  float v[3][search_lanes];
  float q[3][search_lanes];
};

/// Sixteen planes and what they cost: the sum of min((residual / gate)², 1).
struct SearchPlanes {
  float a[search_lanes], b[search_lanes], c[search_lanes];
  float cost[search_lanes];
};

/// Readings near a plane, and the sum of their (residual / gate)².
struct SearchInliers {
  float squares = 0;
  std::uint32_t count = 0;
};

/// Sums over readings; r is the residual from a plane, w 1 / gate.
struct SearchSums {
  float n = 0, u = 0, v = 0, uu = 0, uv = 0, vv = 0;
  float r = 0, ur = 0, vr = 0, rr = 0, ww = 0;
};

/// Cells in rows `stride` apart, the rows whole groups of search_lanes or followed by cells without a
/// reading. Kernels may read, and write into arrays of marks, up to search_overrun cells after a
/// row.
struct SearchBox {
  std::int32_t width = 0, height = 0;
  std::ptrdiff_t stride = 0;
};
inline constexpr std::int32_t search_overrun = 64;

/// Marked cells, and the rows of the box that have some; the rows are [0, 0) without any.
struct SearchMarks {
  std::uint32_t cells = 0;
  std::int32_t first_row = 0, end_row = 0;
};

/// Numbers of cells in the order of DepthCell, each kind `apart` floats from the last.
struct SearchCells {
  const float* first = nullptr;
  std::ptrdiff_t apart = 0;
  float middle_u = 0, middle_v = 0;  ///< from where their pixels count
};

/// The gate of a reading is the larger of `least` and `per_square` q².
struct SearchGate {
  float least = 0, per_square = 0;
  float most_squared = 1;  ///< (residual / gate)²
};

/// Where readings are put together.
struct GatheredReadings {
  float *u = nullptr, *v = nullptr, *q = nullptr, *w = nullptr;
};

struct SearchOutput {
  float *u = nullptr, *v = nullptr, *q = nullptr, *w = nullptr, *squares = nullptr;
};

struct PlaneSearchKernels {
  /// The planes through sixteen triples of readings, and their costs among `count` readings. A triple whose
  /// triangle in the picture has less than 16 square pixels makes a plane that costs as much as none.
  void (*try_triples)(const SearchReadings& readings, std::uint32_t count, const SearchTriples& triples,
                      SearchPlanes& planes) noexcept;

  /// Readings with (residual / gate)² below `most`; `padded` is a multiple of search_lanes.
  SearchInliers (*find_inliers)(const SearchReadings& readings, std::uint32_t padded,
                                const SearchPlane& plane, float most) noexcept;
  /// Their sums.
  void (*sum_inliers)(const SearchReadings& readings, std::uint32_t padded, const SearchPlane& plane,
                      float most, SearchSums& sums) noexcept;

  /// Puts the readings (q above 0) of a row one after another, u and v counted from (u0, v0); how many they
  /// are. Kernels may read up to search_lanes cells after the row, and write as many after what they put
  /// there.
  std::uint32_t (*gather_row)(const SearchReadings& row, std::int32_t columns, float u0, float v0,
                              const GatheredReadings& out) noexcept;

  /// Readings of cells that lie one after another, as DepthCells has them: u, v, q, w of each. A cell is one
  /// if it has readings, at most 1e6, its gate does not reach infinity, and the plane that fits it best
  /// leaves residuals of at most `most_squared` on average. Else q is `none`. `squares`: the sum of
  /// (residual / gate)² of that plane. Kernels may read and write up to the next multiple of search_lanes.
  void (*take_cells)(const SearchCells& cells, std::int32_t count, const SearchGate& gate, float none,
                     const SearchOutput& out) noexcept;

  /// Cells of `side` pixels one beside the other, of which a row of the picture has `labels`: q becomes
  /// `none` where one of the labels of a cell's `rows` rows is not 0. `side` is a multiple of 4.
  void (*mask_cells)(const std::uint16_t* labels, std::ptrdiff_t stride, std::int32_t rows, std::int32_t side,
                     std::int32_t count, float none, float* q) noexcept;

  /// How many of `q` are above 0, in rows up to the next multiple of search_lanes or somewhat less.
  std::uint32_t (*count_readings)(const float* q, const SearchBox& box) noexcept;

  /// 1 for each cell whose (residual / gate)² is below `most`, else 0.
  void (*mark_hits)(const SearchReadings& readings, const SearchBox& box, const SearchPlane& plane,
                    float most, std::uint8_t* hit) noexcept;
  /// `core` is 1 for each hit that has three hits among its eight neighbours, else 0. `columns` gets the OR
  /// over each column; `counts` is room for a row.
  SearchMarks (*keep_dense)(const std::uint8_t* hit, const SearchBox& box, std::uint8_t* core,
                            std::uint8_t* counts, std::uint8_t* columns) noexcept;
  /// q of marked cells becomes `none`.
  void (*empty_marked)(const std::uint8_t* core, const SearchBox& box, float none, float* q) noexcept;
  /// Sums over the marked cells, u and v counted from (u0, v0). `marks` is room for a row.
  void (*sum_marked)(const SearchReadings& readings, const std::uint8_t* core, const SearchBox& box,
                     const SearchPlane& plane, float u0, float v0, float* marks, SearchSums& sums) noexcept;
};

/// Portable loops; what every other table is compared with.
extern const PlaneSearchKernels plain_plane_search_kernels;
#if defined(__x86_64__)
extern const PlaneSearchKernels avx2_plane_search_kernels;    ///< needs AVX2 and POPCNT
extern const PlaneSearchKernels avx512_plane_search_kernels;  ///< needs AVX-512 F, BW, DQ, VL and POPCNT
#endif

}  // namespace straightedge
