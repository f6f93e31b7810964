// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "hough/planes/patch_growth.hpp"

#include "hough/planes/patch_votes.hpp"
#include "straightedge/square_root.hpp"

namespace straightedge::hough {
namespace {

constexpr int most_rounds = 10;
// Chi-square with three degrees of freedom: one patch of a plane in a thousand is lost.
constexpr double most_distance = 16;
// How well a plane must be known where it takes in a patch, standard deviations of a reading.
constexpr double known_sigmas = 1;
constexpr double known_sigmas_near_peak = 3;

/// The sums of some patches.
struct PatchSum {
  InverseDepthMoments moments;
  std::uint32_t patches = 0;

  void add(const PatchScene& scene, const HoughPatch& patch) noexcept {
    moments.add(moments_of(patch.cell, scene.size.width / 2.0, scene.size.height / 2.0));
    ++patches;
  }
};

bool near_peak(const PatchScene& scene, const HoughPatch& patch, const Plane& peak) noexcept {
  // A plane near the camera may stand in the accumulator with its normal turned round.
  const bool turned = dot(peak.normal, patch.space.normal) < 0;
  const Vector3 normal = turned ? -peak.normal : peak.normal;
  // Planes beyond the greatest distance stand in the last cell.
  const double last = scene.options.max_distance_m - scene.step_m / 2;
  const double distance = dot(normal, patch.point);
  const double off = (distance < last ? distance : last) - (turned ? -peak.distance : peak.distance);
  return off <= scene.step_m && off >= -scene.step_m && kernel_distance(patch, normal) < vote_reach_squared;
}

HoughPatchMean* find_seed(const PatchScene& scene, const PatchPool& pool, const Plane& peak) noexcept {
  HoughPatchMean* best = nullptr;
  std::uint32_t most = 0;
  for (HoughPatchMean& mean : pool.free) {
    if (mean.voters <= most || !near_peak(scene, pool.of(mean), peak)) continue;
    best = &mean;
    most = mean.voters;
  }
  return best;
}

/// Chi-square of the slopes' difference, both errors and the bumps of the depth counted.
double slope_distance(const PatchScene& scene, const HoughPatch& patch, const InverseDepthFit& fit) noexcept {
  const double da = fit.plane.a - patch.plane.a, db = fit.plane.b - patch.plane.b;
  const double bend = scene.options.bend_rad / patch.space.distance;
  const double bent_a = bend / scene.camera.fx, bent_b = bend / scene.camera.fy;
  const double aa = fit.covariance[0] + patch.slope_covariance[0] + bent_a * bent_a;
  const double ab = fit.covariance[1] + patch.slope_covariance[1];
  const double bb = fit.covariance[3] + patch.slope_covariance[2] + bent_b * bent_b;
  return (da * da * bb - 2 * da * db * ab + db * db * aa) / (aa * bb - ab * ab);
}

/// Is the plane within the gate at the patch's mean? Cheap, and enough to pass most patches by.
bool passes_gate(const HoughPatchMean& mean, const InverseDepthPlane& plane) noexcept {
  const double off = plane.at(mean.u, mean.v) - mean.q;
  return off <= mean.gate && off >= -mean.gate;
}

/// Step 5's test but for the gate.
bool agrees(const PatchScene& scene, const HoughPatch& patch, const InverseDepthFit& fit,
            double most_known) noexcept {
  const double u = patch.mean_u, v = patch.mean_v;
  const double sigma = patch.gate / scene.gate.sigmas;
  const double variance = sigma * sigma;
  const double off = fit.plane.at(u, v) - patch.mean_q;
  const auto& [aa, ab, ac, bb, bc, cc] = fit.covariance;
  const double known = u * (aa * u + 2 * (ab * v + ac)) + v * (bb * v + 2 * bc) + cc;
  if (!(known <= most_known * most_known * variance)) return false;
  const double warp = scene.options.warp_sigmas * scene.options.warp_sigmas * variance;
  const double mean = off * off / (patch.noise / readings_of(patch) + known + warp);
  return mean <= most_distance && mean + slope_distance(scene, patch, fit) <= most_distance;
}

bool fit_sum(const PatchScene& scene, const InverseDepthMoments& sum, InverseDepthFit& fit) noexcept {
  const double sigma =
      scene.gate.inverse_noise(sum.q / sum.n) * square_root(scene.options.shared_noise_pixels);
  return fit_inverse_depth(sum, sigma, fit) == Status::ok;
}

/// From the seed's plane to that of all patches that agree.
PatchSum grow_from(const PatchScene& scene, const HoughPatch& seed, const Plane& peak,
                   const PatchPool& pool) noexcept {
  PatchSum sum;
  sum.add(scene, seed);
  for (int round = 0; round < most_rounds; ++round) {
    InverseDepthFit fit;
    if (!fit_sum(scene, sum.moments, fit)) break;
    PatchSum next;
    for (const HoughPatchMean& mean : pool.free) {
      if (!passes_gate(mean, fit.plane)) continue;
      const HoughPatch& patch = pool.of(mean);
      const bool good = agrees(scene, patch, fit, known_sigmas) ||
                        (near_peak(scene, patch, peak) && agrees(scene, patch, fit, known_sigmas_near_peak));
      if (good) next.add(scene, patch);
    }
    if (next.patches == 0 || (next.patches == sum.patches && next.moments.n == sum.moments.n)) break;
    sum = next;
  }
  return sum;
}

void widen(const HoughPatch& patch, ProposedPlane& candidate) noexcept {
  if (patch.x < candidate.column0) candidate.column0 = patch.x;
  if (patch.y < candidate.row0) candidate.row0 = patch.y;
  if (patch.x + patch.side > candidate.column1) candidate.column1 = patch.x + patch.side;
  if (patch.y + patch.side > candidate.row1) candidate.row1 = patch.y + patch.side;
}

/// Writes the number into the patches that agree, and takes them out of the pool.
void claim(const PatchScene& scene, std::uint16_t number, PatchPool& pool,
           ProposedPlane& candidate) noexcept {
  const InverseDepthFit& fit = candidate.fit;
  std::size_t kept = 0;
  candidate.column0 = scene.size.width;
  candidate.row0 = scene.size.height;
  candidate.column1 = candidate.row1 = 0;
  for (const HoughPatchMean& mean : pool.free) {
    HoughPatch& patch = pool.of(mean);
    const bool taken = patch.candidate == number ||
                       (passes_gate(mean, fit.plane) && agrees(scene, patch, fit, known_sigmas));
    if (taken) {
      patch.candidate = number;
      widen(patch, candidate);
    } else {
      pool.free[kept++] = mean;
    }
  }
  pool.free = pool.free.first(kept);
}

}  // namespace

PatchPool make_pool(std::span<HoughPatch> patches, std::span<HoughPatchMean> means) noexcept {
  for (std::uint32_t i = 0; i < patches.size(); ++i) {
    const HoughPatch& patch = patches[i];
    const double voters = patch.votes ? readings_of(patch) : 0;
    means[i] = {patch.mean_u, patch.mean_v, patch.mean_q, patch.gate, i, static_cast<std::uint32_t>(voters)};
  }
  return {patches, means.first(patches.size())};
}

bool grow(const PatchScene& scene, const Plane& peak, PatchPool& pool, std::uint16_t number,
          ProposedPlane& candidate) noexcept {
  HoughPatchMean* mean = find_seed(scene, pool, peak);
  if (mean == nullptr) return false;
  HoughPatch* seed = &pool.of(*mean);
  const PatchSum sum = grow_from(scene, *seed, peak, pool);
  if (sum.moments.n < scene.options.min_pixels || !fit_sum(scene, sum.moments, candidate.fit)) {
    seed->votes = false;
    mean->voters = 0;
    return false;
  }
  candidate.readings = static_cast<std::uint32_t>(sum.moments.n);
  candidate.patches = sum.patches;
  seed->candidate = number;
  claim(scene, number, pool, candidate);
  return true;
}

}  // namespace straightedge::hough
