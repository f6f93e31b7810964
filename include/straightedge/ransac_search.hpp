// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "straightedge/arena.hpp"
#include "straightedge/frame_planes_search.hpp"
#include "straightedge/image.hpp"
#include "straightedge/ransac_search_options.hpp"
#include "straightedge/status.hpp"

namespace straightedge {

struct RansacSearchResult {
  Status status = Status::not_prepared;
  std::uint32_t candidates = 0;  ///< written, strongest first
  std::uint32_t readings = 0;    ///< cells that have one
  std::uint32_t explained = 0;   ///< of these, how many a candidate owns
  double noise = 1;              ///< the gate was so many times as wide as the options say
  std::uint32_t windows = 0;     ///< searched
  std::uint32_t draws = 0;       ///< triples tried
  std::uint64_t seed = 0;
};

namespace detail {

/// The free readings of a window, ready to be drawn from and scored. Pixels count from (u0, v0). What fills
/// the last group of sixteen up is far from every plane.
struct RansacWindow {
  static constexpr std::uint32_t capacity = 176;
  float u[capacity], v[capacity], q[capacity], w[capacity];
  std::uint32_t count;
  std::int32_t u0, v0;
};

/// A plane whose readings fill the gate, and the window in which it was found.
struct RansacRoughPlane {
  float a, b, c;
  std::int16_t column, row, half;  ///< cells
};

/// Cells in rows with a border of at least one, on the left of sixteen: rows begin where vectors do.
struct RansacSearchMemory {
  std::span<float> u, v, q, w;  ///< a cell's reading: pixel, 1/z, 1 / gate
  std::span<float> free_q;      ///< q of readings that no candidate has taken; at the end costs
  std::span<float> owner;       ///< numbers of candidates
  std::span<float> row;         ///< five of cells
  std::span<std::uint8_t> hit, core, counts, columns;
  std::span<ProposedPlane> candidates;
  std::span<RansacRoughPlane> rough;
  std::span<RansacWindow> window;  ///< one

  static constexpr RansacSearchMemory take(Arena& arena, Size size,
                                           const RansacSearchOptions& options) noexcept {
    const auto cell = static_cast<std::size_t>(options.cell);
    const std::size_t overrun = search_overrun;
    const std::size_t stride = ((static_cast<std::size_t>(size.width) + cell - 1) / cell + 15) / 16 * 16 + 16;
    const std::size_t cells =
        stride * ((static_cast<std::size_t>(size.height) + cell - 1) / cell + 2) + overrun;
    RansacSearchMemory m;
    for (std::span<float>* plane : {&m.u, &m.v, &m.q, &m.w, &m.free_q, &m.owner})
      *plane = arena.take<float>(cells);
    m.row = arena.take<float>(5 * (stride + overrun));
    m.hit = arena.take<std::uint8_t>(cells);
    m.core = arena.take<std::uint8_t>(cells);
    m.counts = arena.take<std::uint8_t>(stride + overrun);
    m.columns = arena.take<std::uint8_t>(stride + overrun);
    m.candidates = arena.take<ProposedPlane>(static_cast<std::size_t>(options.max_candidates));
    m.rough = arena.take<RansacRoughPlane>(2 * static_cast<std::size_t>(options.max_candidates));
    m.window = arena.take<RansacWindow>(1);
    return m;
  }
};

}  // namespace detail

/// Candidate planes of a depth frame, large and small, for a labelling that gives each pixel the best of
/// them.
///
///   1. Draw one reading of every square of cell x cell pixels: the pixel of the square by chance, one
///      draw for sixteen squares side by side; if it has no reading, the next that has. The noise of
///      neighbouring pixels is shared over three to five of them: sixteen readings of a square say
///      little more than one.
///   2. The frame's noise: RANSAC with a wide gate in windows on a grid; the lower quartile of the
///      residuals. A frame that is noisier than gate.inverse_sigma, or bent, gets a wider gate. (Gates
///      in metres stay.)
///   3. Windows of three sizes, large to small, in steps of half a window; none smaller than the
///      smallest plane. In each, RANSAC among the readings that are left: sixteen triples at a time,
///      their MSAC costs in the window, refits of the best with a threshold from wide to narrow, until
///      the stop rule or max_draws. The readings of a window are near one another, so that a face of
///      1000 pixels among 300 000, hopeless for triples from the whole frame, is found in a few draws.
///   4. Grow: refit to the readings within the gate in boxes four times as large each, at last in the
///      frame, until the plane ends inside its box; in the frame again while that doubles it. A
///      reading counts if three of its eight neighbours do too. Refused are planes with less than
///      min_pixels and those whose residuals fill the gate (rms > max_rms, in the window already or in
///      a box): noise of a third of the gate leaves 0.33, the compromise between two surfaces, or a
///      curved one, near 0.58. The others are candidates and their readings leave.
///   5. Planes that were refused for their residuals grow again, with rough_rms in place of max_rms,
///      among what is left: those refused first, at most two for each of max_candidates.
///   6. Contest: each reading goes to the candidate that fits it and its neighbours best, and every
///      candidate is refitted to what it has. Sorted by score.
///
/// Papers: ransac_planes.hpp. Deterministic: the cells of row r are drawn from stream r, window i draws from
/// stream 2^32 + i of the seed; all sums have a fixed order, the same for every table of kernels.
///
/// Time: what a plane costs grows with its extent, what is no plane costs a few microseconds a window; for
/// 640x480 pixels with the defaults a quarter of a millisecond in an empty room to one and a half in clutter.
/// Memory: 30 bytes a cell, and 20 KB. A frame without readings, or with noise alone, has no candidates.
class RansacSearch {
 public:
  /// 0 for a size or options that `prepare` refuses.
  static constexpr std::size_t workspace_bytes(Size size, const RansacSearchOptions& options) noexcept {
    if (!fits(size) || !detail::valid(options)) return 0;
    Arena arena = Arena::measure();
    (void)detail::RansacSearchMemory::take(arena, size, options);
    return arena.used();
  }
  /// invalid_image: a side below 1 or above 2^15; invalid_option; workspace_too_small.
  static Status prepare(RansacSearch& search, Size size, const RansacSearchOptions& options,
                        std::span<std::byte> workspace) noexcept;

  /// `inverse_depth`: 1/z, 0, negative or not finite is no reading. Readings with z beyond the depth at which
  /// the gate reaches infinity (234 m by default) are none either. `mask`: pixels that are not 0 take no
  /// part; a view without data masks nothing. output_full: `out` holds the strongest.
  RansacSearchResult run(ImageView<const float> inverse_depth, ImageView<const std::uint16_t> mask,
                         std::span<ProposedPlane> out) noexcept;

 private:
  static constexpr bool fits(Size size) noexcept {
    return size.width >= 1 && size.height >= 1 && size.width <= 32768 && size.height <= 32768;
  }

  Size size_{};
  RansacSearchOptions options_;
  detail::RansacSearchMemory memory_;
  bool prepared_ = false;
};

/// As FramePlanes takes it. `search` must outlive what is returned.
PlaneSearch plane_search(RansacSearch& search) noexcept;

}  // namespace straightedge
