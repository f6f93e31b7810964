// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "hough/planes/patch_growth.hpp"

#include "hough/planes/patch_votes.hpp"

namespace straightedge::hough {
namespace {

constexpr int growth_rounds = 10;

bool near_peak(const HoughPatch& patch, const Plane& peak, double step_m) noexcept {
  const double off = dot(peak.normal, patch.point) - peak.distance;
  return off <= step_m && off >= -step_m && kernel_distance(patch, peak.normal) < vote_reach_squared;
}

HoughPatch* find_seed(std::span<HoughPatch> patches, const Plane& peak, double step_m) noexcept {
  HoughPatch* best = nullptr;
  for (HoughPatch& patch : patches) {
    if (patch.candidate != 0 || !patch.votes) continue;
    if (best != nullptr && patch.moments.n <= best->moments.n) continue;
    if (near_peak(patch, peak, step_m)) best = &patch;
  }
  return best;
}

}  // namespace

double patch_distance(const PatchScene& scene, const HoughPatch& patch, const InverseDepthFit& fit, double known_sigmas) noexcept {
  const auto& [aa, ab, ac, bb, bc, cc] = fit.covariance;
  const double u = patch.mean_u, v = patch.mean_v;
  const double off = fit.plane.at(u, v) - patch.mean_q;
  const double predicted = u * (aa * u + 2 * (ab * v + ac)) + v * (bb * v + 2 * bc) + cc;
  const double variance = patch.noise / patch.moments.n + predicted;
  const double sigma = scene.sigma(patch.mean_q);
  const double gate = scene.gate.sigmas * sigma;
  if (!(off * off <= gate * gate) || !(predicted <= known_sigmas * known_sigmas * sigma * sigma)) return 1e9;
  const double da = fit.plane.a - patch.plane.a, db = fit.plane.b - patch.plane.b;
  const double bent_a = scene.options.bend_rad / (patch.space.distance * scene.camera.fx);
  const double bent_b = scene.options.bend_rad / (patch.space.distance * scene.camera.fy);
  const double saa = aa + patch.slope_covariance[0] + bent_a * bent_a, sab = ab + patch.slope_covariance[1],
               sbb = bb + patch.slope_covariance[2] + bent_b * bent_b;
  const double determinant = saa * sbb - sab * sab;
  const double slopes = (da * da * sbb - 2 * da * db * sab + db * db * saa) / determinant;
  const double warp = scene.options.warp_sigmas * sigma;
  return off * off / (variance + warp * warp) + slopes;
}

bool fit_sum(const PatchScene& scene, const PatchSum& sum, InverseDepthFit& fit) noexcept {
  const double q = sum.moments.q / sum.moments.n;
  const double sigma = scene.sigma(q) * __builtin_sqrt(scene.options.shared_noise_pixels);
  return fit_inverse_depth(sum.moments, sigma, fit) == Status::ok;
}

bool grow(const PatchScene& scene, const Plane& peak, double step_m, std::span<HoughPatch> patches,
          std::uint16_t number, HoughPlaneCandidate& candidate) noexcept {
  HoughPatch* seed = find_seed(patches, peak, step_m);
  if (seed == nullptr) return false;
  PatchSum sum;
  sum.add(*seed);
  for (int round = 0; round < growth_rounds; ++round) {
    if (!fit_sum(scene, sum, candidate.fit)) break;
    PatchSum next;
    for (const HoughPatch& patch : patches) {
      if (patch.candidate != 0) continue;
      const double known = near_peak(patch, peak, step_m) ? 3 : 1;
      if (patch_distance(scene, patch, candidate.fit, known) <= patch_limit) next.add(patch);
    }
    if (next.patches == 0 || (next.patches == sum.patches && next.pixels == sum.pixels)) break;
    sum = next;
  }
  if (sum.pixels < scene.options.min_pixels || !fit_sum(scene, sum, candidate.fit)) {
    seed->votes = false;
    return false;
  }
  candidate.pixels = static_cast<std::uint32_t>(sum.pixels);
  candidate.patches = sum.patches;
  for (HoughPatch& patch : patches) {
    if (patch.candidate == 0 && patch_distance(scene, patch, candidate.fit, 1) <= patch_limit) {
      patch.candidate = number;
    }
  }
  seed->candidate = number;
  return true;
}

}  // namespace straightedge::hough
