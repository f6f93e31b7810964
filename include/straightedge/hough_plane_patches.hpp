// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "straightedge/arena.hpp"
#include "straightedge/depth_view.hpp"
#include "straightedge/hough_accumulator.hpp"
#include "straightedge/hough_plane_patch.hpp"
#include "straightedge/hough_plane_peaks.hpp"
#include "straightedge/image.hpp"
#include "straightedge/inverse_depth.hpp"
#include "straightedge/plane_gate.hpp"
#include "straightedge/status.hpp"

namespace straightedge {

struct HoughPatchOptions {
  HoughAccumulatorOptions accumulator;
  double max_distance_m = 8;           ///< of planes from the camera, (0, 1e6]; farther ones share a cell
  std::int32_t largest_patch = 64;     ///< pixels: 8, 16, 32 or 64
  double shared_noise_pixels = 16;     ///< neighbours that share their noise, [1, 1000]; 1: independent
  double max_spread_rad = 0.35;        ///< patches that know their normal less well do not vote, (0, 1]
  double warp_sigmas = 0.5;            ///< bumps of the depth that neighbours share, in units of the gate's sigma, [0, 10]
  double bend_rad = 0.05;              ///< what they do to a patch's normal, [0, 0.5]
  std::uint32_t min_pixels = 300;      ///< a candidate's patches have at least so many readings
  std::int32_t max_candidates = 64;    ///< [1, 1024]
  std::int32_t rounds = 3;             ///< votings; each after the first by what is left, [1, 16]

  constexpr bool operator==(const HoughPatchOptions&) const noexcept = default;
};

/// A plane that many patches share.
struct HoughPlaneCandidate {
  InverseDepthFit fit;         ///< to the readings of its patches
  std::uint32_t votes = 0;     ///< of the accumulator's cell that led to it
  std::uint32_t pixels = 0;    ///< readings of its patches
  std::uint32_t patches = 0;
};

struct HoughPatchResult {
  Status status = Status::not_prepared;
  std::uint32_t candidates = 0;  ///< written
  std::uint32_t readings = 0;
  std::uint32_t patches = 0;
  std::uint32_t votes = 0;  ///< cast by patches, all rounds
};

/// Votes of one patch count 64 a reading.
inline constexpr std::uint32_t hough_patch_vote = 64;
/// Side of the smallest patch, pixels.
inline constexpr std::int32_t hough_patch_side = 8;

class HoughPatchSearch {
 public:
  static constexpr bool valid(const HoughPatchOptions& o) noexcept {
    const bool sizes = o.largest_patch == 8 || o.largest_patch == 16 || o.largest_patch == 32 || o.largest_patch == 64;
    return HoughAccumulator::cell_count(o.accumulator) > 0 && o.max_distance_m > 0 && o.max_distance_m <= 1e6 &&
           sizes && o.shared_noise_pixels >= 1 && o.shared_noise_pixels <= 1000 && o.max_spread_rad > 0 &&
           o.max_spread_rad <= 1 && o.max_candidates >= 1 && o.max_candidates <= 1024 && o.rounds >= 1 &&
           o.rounds <= 16;
  }

  static constexpr std::size_t workspace_bytes(Size size, const HoughPatchOptions& options) noexcept {
    if (!valid(options) || !fits(size)) return 0;
    Arena arena = Arena::measure();
    Memory memory;
    memory.take(arena, size, options);
    return arena.failed() ? 0 : arena.used();
  }

  static Status prepare(HoughPatchSearch& search, Size size, const HoughPatchOptions& options,
                        std::span<std::byte> workspace) noexcept;

  HoughPatchResult run(ImageView<const float> inverse_depth, const PinholeCamera& camera, const PlaneGate& gate,
                       ImageView<const std::uint16_t> mask, std::span<HoughPlaneCandidate> candidates) noexcept;

  std::span<const HoughPatch> patches() const noexcept { return memory_.patches.first(patches_); }
  const HoughAccumulator& accumulator() const noexcept { return memory_.accumulator; }

  struct Memory {
    std::span<InverseDepthMoments> levels[4];
    std::span<HoughPatch> patches;
    std::span<HoughPlanePeak> peaks;
    std::span<HoughPlaneCandidate> candidates;
    HoughAccumulator accumulator;

    constexpr void take(Arena& arena, Size size, const HoughPatchOptions& options) noexcept {
      std::int32_t side = hough_patch_side;
      for (auto& level : levels) {
        level = arena.take<InverseDepthMoments>(cells(size, side));
        side *= 2;
      }
      patches = arena.take<HoughPatch>(cells(size, hough_patch_side));
      peaks = arena.take<HoughPlanePeak>(2 * static_cast<std::size_t>(options.max_candidates));
      candidates = arena.take<HoughPlaneCandidate>(static_cast<std::size_t>(options.max_candidates));
      accumulator.take(arena, options.accumulator);
    }
    static constexpr std::size_t cells(Size size, std::int32_t side) noexcept {
      return static_cast<std::size_t>((size.width + side - 1) / side) *
             static_cast<std::size_t>((size.height + side - 1) / side);
    }
  };

 private:
  static constexpr bool fits(Size size) noexcept {
    return size.width > 0 && size.height > 0 && size.width <= 32767 && size.height <= 32767;
  }

  Size size_;
  HoughPatchOptions options_;
  Memory memory_;
  std::size_t patches_ = 0;
};

}  // namespace straightedge
