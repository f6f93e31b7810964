// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/hough_accumulator.hpp"
#include "straightedge/plane_gate.hpp"

namespace straightedge {

enum class HoughPlaneVoting : std::uint8_t {
  standard,    ///< every point votes for every direction
  randomized,  ///< three points cast one vote
};

/// A number that is NaN or outside its range gives `invalid_option`.
struct HoughPlaneOptions {
  HoughPlaneVoting voting = HoughPlaneVoting::randomized;
  HoughAccumulatorOptions accumulator;
  double distance_step_m = 0;  ///< of the distance cells, [0, 1e6]; 0: the cloud's radius by their number
  PlaneGate gate{.fixed_m =
                     0.02};  ///< by default two centimetres; fixed_m = 0 for a depth camera at the origin
  std::uint32_t min_points = 500;  ///< of a plane, >= 3
  std::uint32_t max_planes = 64;   ///< finding ends then, [1, 1024]

  // Standard only.
  std::uint32_t every = 16;  ///< each so-manieth point votes, >= 1

  // Randomized only.
  double triple_min_m = 0.1;  ///< two points of a triple are not nearer, [0, 1e6], below triple_max_m
  double triple_max_m = 1;    ///< nor farther; (0, 1e6], or 0: anywhere
  std::uint32_t triple_threshold = 3;   ///< votes of a cell that make it worth a look, >= 1
  double confidence = 0.99;             ///< (0, 1), that no plane of min_points is left behind
  std::uint32_t max_draws = 1'000'000;  ///< triples; drawing ends here at the latest, >= 1
  std::uint64_t seed = 1;
};

namespace detail {

constexpr bool valid(const HoughPlaneOptions& o) noexcept {
  const bool common = o.voting <= HoughPlaneVoting::randomized &&
                      HoughAccumulator::cell_count(o.accumulator) > 0 && o.distance_step_m >= 0 &&
                      o.distance_step_m <= 1e6 && o.gate.valid() && o.min_points >= 3 && o.max_planes >= 1 &&
                      o.max_planes <= 1024;
  const bool anywhere = o.triple_max_m == 0;
  const bool triples = o.triple_min_m >= 0 && o.triple_min_m <= 1e6 && o.triple_max_m >= 0 &&
                       o.triple_max_m <= 1e6 && (anywhere || o.triple_min_m < o.triple_max_m) &&
                       o.triple_threshold >= 1 && o.confidence > 0 && o.confidence < 1 && o.max_draws >= 1;
  return common && triples && o.every >= 1;
}

}  // namespace detail

}  // namespace straightedge
