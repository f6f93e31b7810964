// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/detail/has_table.hpp"
#include "straightedge/plane_gate.hpp"
#include "straightedge/ransac_kernels.hpp"

namespace straightedge {

/// One hypothesis of a search.
struct RansacEvent {
  std::uint32_t plane = 0;              ///< which plane is looked for, from 0
  std::uint32_t iteration = 0;          ///< from 0; a triple on a line is drawn again and not told
  std::uint32_t triple[3] = {0, 0, 0};  ///< points or pixels (row by row) that make it
  std::uint32_t inliers = 0;            ///< in the subset, after local optimisation; 0 unless it is the best
  float cost = 0;                       ///< MSAC cost in the subset as drawn
  bool best = false;                    ///< made the cheapest plane so far
};

/// Watches a run. `event` returns false to stop it, which gives `cancelled`.
struct RansacTrace {
  bool (*event)(void* user, const RansacEvent&) = nullptr;
  void* user = nullptr;

  bool operator()(const RansacEvent& e) const noexcept { return event == nullptr || event(user, e); }
};

/// A number that is NaN or outside its range gives `invalid_option`.
struct RansacOptions {
  PlaneGate gate = {};
  std::uint32_t subset = 2048;  ///< readings on which hypotheses are scored, [16, 65536]
  double near_radius = 0;       ///< pixels, or metres for points, of the second and third reading from
                                ///< the first, [0, 1e6]; 0: anywhere
  double confidence = 0.999;    ///< (0, 1), that the best plane was hit; see ransac_stop.hpp
  std::uint32_t max_iterations = 5000;  ///< hypotheses for one plane, [1, 10 000 000]
  std::uint32_t max_planes = 1;         ///< [1, 65535]
  std::uint32_t min_inliers = 100;      ///< readings of a plane, >= 3
  double min_share = 0.02;              ///< of all readings, [0, 1]; a plane has both
  bool split = false;                   ///< planes into connected pieces; those below the minimum leave
  double piece_cell_m = 0.1;            ///< metres, above 0, at most 1000: points in cells of this size that
                                        ///< touch are connected (pixels: those that touch)
  std::uint64_t seed = 1;
  RansacTrace trace = {};
  const RansacKernels* kernels = &plain_ransac_kernels;  ///< not null
};

namespace detail {

constexpr bool valid(const RansacOptions& o) noexcept {
  return o.gate.valid() && o.subset >= 16 && o.subset <= 65536 && o.near_radius >= 0 &&
         o.near_radius <= 1e6 && o.confidence > 0 && o.confidence < 1 && o.max_iterations >= 1 &&
         o.max_iterations <= 10'000'000 && o.max_planes >= 1 && o.max_planes <= 65535 && o.min_inliers >= 3 &&
         o.min_share >= 0 && o.min_share <= 1 && o.piece_cell_m > 0 && o.piece_cell_m <= 1000 &&
         has_table(o.kernels);
}

}  // namespace detail
}  // namespace straightedge
