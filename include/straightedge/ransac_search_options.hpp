// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/detail/has_table.hpp"
#include "straightedge/frame_planes_options.hpp"
#include "straightedge/plane_gate.hpp"
#include "straightedge/plane_search_kernels.hpp"

namespace straightedge {

/// A number that is NaN or outside its range gives `invalid_option`.
struct RansacSearchOptions {
  PlaneGate gate = {};
  std::int32_t cell = 4;          ///< side of the smallest cells that are looked at, pixels: 4, 8 or 16
  std::int32_t min_pixels = 480;  ///< half of the smallest plane's, >= 1: of thin ones few are in whole cells
  std::int32_t max_candidates = 64;  ///< [1, 65535]
  double max_rms = 0.5;         ///< residual of a smooth plane's cells, gates of means, (0, 1]; see step 4
  double rough_rms = 1;         ///< of a rough plane's, [0, 1]; 0: smooth planes alone
  double most_noise = 3;        ///< the gate is widened at most so many times for a noisy frame, [1, 100]
  double confidence = 0.99;     ///< (0, 1), of a window's search, see ransac_stop.hpp
  std::int32_t max_draws = 16;  ///< triples drawn from one window, [1, 65535], sixteen at a time
  std::uint64_t seed = 1;
  const PlaneSearchKernels* kernels = &plain_plane_search_kernels;  ///< not null
};

/// The options for a search of FramePlanes with these: its gate, and planes as small as it wants.
constexpr RansacSearchOptions for_frame(RansacSearchOptions search, Size size,
                                        const FramePlanesOptions& frame) noexcept {
  const std::uint32_t least = least_pixels(size, frame);
  search.gate = widened(frame);
  if (search.cell == 4 || search.cell == 8) search.cell = search.cell < frame.cell ? frame.cell : search.cell;
  if (search.min_pixels > 0 && least < static_cast<std::uint32_t>(search.min_pixels))
    search.min_pixels = static_cast<std::int32_t>(least);
  return search;
}

namespace detail {

constexpr bool valid(const RansacSearchOptions& o) noexcept {
  return o.gate.valid() && (o.cell == 4 || o.cell == 8 || o.cell == 16) && o.min_pixels >= 1 &&
         o.max_candidates >= 1 && o.max_candidates <= 65535 && o.max_rms > 0 && o.max_rms <= 1 &&
         o.rough_rms >= 0 && o.rough_rms <= 1 && o.most_noise >= 1 && o.most_noise <= 100 &&
         o.confidence > 0 && o.confidence < 1 && o.max_draws >= 1 && o.max_draws <= 65535 &&
         has_table(o.kernels);
}

/// Levels of DepthCells that are looked at: three, if there are.
constexpr int finest_level(const RansacSearchOptions& o) noexcept {
  return o.cell == 4 ? 0 : o.cell == 8 ? 1 : 2;
}
constexpr int coarsest_level(const RansacSearchOptions& o) noexcept {
  return o.cell == 4 ? 2 : 3;
}

}  // namespace detail
}  // namespace straightedge
