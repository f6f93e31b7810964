// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "hough/planes/patch_rivals.hpp"

#include <array>

namespace straightedge::hough {
namespace {

// More rivals than these do not come near one patch.
constexpr std::size_t most_rivals = 8;
// The rivals may be so much worse: the plane was fitted to these readings, they were not.
constexpr double rival_ratio = 1.2;

struct Rivals {
  std::array<InverseDepthPlane, most_rivals> planes;
  std::size_t count = 0;
};

/// Planes of stronger candidates that pass the patch nearby.
Rivals rivals_at(const PatchScene& scene, const HoughPatch& patch, std::span<const ProposedPlane> candidates,
                 std::uint32_t number) noexcept {
  Rivals rivals;
  const double sigma = scene.gate.inverse_noise(patch.mean_q);
  for (std::uint32_t i = 0; i < candidates.size() && rivals.count < most_rivals; ++i) {
    if (i == number || candidates[i].readings <= candidates[number].readings) continue;
    const InverseDepthPlane& plane = candidates[i].fit.plane;
    const double da = plane.a - patch.plane.a, db = plane.b - patch.plane.b;
    const double turn = ((da < 0 ? -da : da) + (db < 0 ? -db : db)) * patch.side / 2;
    const double off = plane.at(patch.mean_u, patch.mean_v) - patch.mean_q;
    const double limit = scene.gate.sigmas * sigma + turn;
    if (off <= limit && off >= -limit) rivals.planes[rivals.count++] = plane;
  }
  return rivals;
}

using Contest = detail::HoughContest;

double squared(const InverseDepthPlane& plane, std::int32_t x, std::int32_t y, double q,
               double most) noexcept {
  const double off = plane.at(x, y) - q;
  return off * off < most ? off * off : most;
}

/// 16 readings of a patch at most, whatever its size.
void add_patch(const PatchScene& scene, const DepthInput& input, const HoughPatch& patch,
               const InverseDepthPlane& own, const Rivals& rivals, Contest& contest) noexcept {
  const std::int32_t step = patch.side / 4;
  const std::int32_t right =
      patch.x + patch.side < scene.size.width ? patch.x + patch.side : scene.size.width;
  const std::int32_t low =
      patch.y + patch.side < scene.size.height ? patch.y + patch.side : scene.size.height;
  const double gate = scene.gate.sigmas * scene.gate.inverse_noise(patch.mean_q);
  const double most = gate * gate;
  const double weight = readings_of(patch);
  Contest sum;
  double readings = 0;
  for (std::int32_t y = patch.y + step / 2; y < low; y += step) {
    for (std::int32_t x = patch.x + step / 2; x < right; x += step) {
      if (!is_reading(input, x, y)) continue;
      const auto q = static_cast<double>(input.inverse_depth.at(x, y));
      double least = most;
      for (std::size_t i = 0; i < rivals.count; ++i) {
        const double r = squared(rivals.planes[i], x, y, q, most);
        if (r < least) least = r;
      }
      sum.own += squared(own, x, y, q, most);
      sum.rival += least;
      ++readings;
    }
  }
  if (readings == 0) return;
  contest.own += sum.own * weight / (readings * most);
  contest.rival += sum.rival * weight / (readings * most);
}

/// Is a candidate as well explained by those with more readings?
bool explained(const Contest& contest) noexcept {
  return contest.rival <= contest.own * rival_ratio;
}

}  // namespace

std::uint32_t drop_explained(const PatchScene& scene, const DepthInput& input,
                             std::span<const HoughPatch> patches, std::span<ProposedPlane> candidates,
                             std::span<Contest> contests) noexcept {
  const auto count = static_cast<std::uint32_t>(candidates.size());
  for (Contest& contest : contests.first(count)) contest = {};
  for (const HoughPatch& patch : patches) {
    if (patch.candidate == 0) continue;
    const std::uint32_t number = patch.candidate - 1U;
    const Rivals rivals = rivals_at(scene, patch, candidates, number);
    add_patch(scene, input, patch, candidates[number].fit.plane, rivals, contests[number]);
  }
  std::uint32_t last = 0;
  for (std::uint32_t turn = 0; turn < count; ++turn) {
    // The one with fewest readings among those with more than the last one had. One that left has none: it
    // had fewer than those whose turn is to come, and was nobody's rival any more.
    std::uint32_t next = count;
    for (std::uint32_t i = 0; i < count; ++i) {
      if (candidates[i].readings <= last) continue;
      if (next == count || candidates[i].readings < candidates[next].readings) next = i;
    }
    if (next == count) break;
    last = candidates[next].readings;
    if (explained(contests[next])) candidates[next].readings = 0;
  }
  std::uint32_t left = 0;
  for (const ProposedPlane& candidate : candidates) {
    if (candidate.readings != 0) candidates[left++] = candidate;
  }
  return left;
}

}  // namespace straightedge::hough
