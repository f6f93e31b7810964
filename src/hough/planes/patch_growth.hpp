// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "hough/planes/patch_tree.hpp"

namespace straightedge::hough {

/// Squared distance of a patch from a plane with its uncertainty, in units of both their errors (three degrees of
/// freedom: the mean reading and two slopes); 1e9 where the mean reading itself fails the gate.
double patch_distance(const PatchScene& scene, const HoughPatch& patch, const InverseDepthFit& fit, double known_sigmas) noexcept;
/// Patches farther than this from a plane are not its.
inline constexpr double patch_limit = 16;

/// The sums of some patches.
struct PatchSum {
  InverseDepthMoments moments;
  double pixels = 0;
  std::uint32_t patches = 0;

  void add(const HoughPatch& patch) noexcept {
    moments.add(patch.moments);
    pixels += patch.moments.n;
    ++patches;
  }
};

/// Fits the plane of a sum with the noise that neighbours share. False: there is none.
bool fit_sum(const PatchScene& scene, const PatchSum& sum, InverseDepthFit& fit) noexcept;

/// From a peak to a plane: starting from the largest free patch near the peak, the plane takes in the free patches
/// that agree with it, and is fitted anew, until it has them all. `number` is written into them. False: fewer
/// readings than a candidate needs; the patch will not be tried again.
bool grow(const PatchScene& scene, const Plane& peak, double step_m, std::span<HoughPatch> patches,
          std::uint16_t number, HoughPlaneCandidate& candidate) noexcept;

}  // namespace straightedge::hough
