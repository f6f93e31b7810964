// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/consensus.hpp"

#include "ransac/triple.hpp"
#include "straightedge/ransac_stop.hpp"

namespace straightedge::ransac {
namespace {

/// Triples on a line are drawn again so many times.
constexpr int redraws = 8;
/// Streams of one plane's hypotheses; those of its subset begin above.
constexpr std::uint64_t streams_a_plane = std::uint64_t{1} << 32U;
/// First readings that stand for all in the mean of step 5.
constexpr std::uint32_t near_samples = 64;

/// Step 2. False: no plane.
bool draw_hypothesis(const Subset& subset, double near_radius, Pcg32& random, Triple& triple,
                     LinearPlane& plane) noexcept {
  const bool in_space = subset.readings.in_space();
  for (int i = 0; i < redraws; ++i) {
    if (near_radius > 0) {
      triple.of[0] = random.below(subset.count);
      const std::uint32_t near = find_near(subset, triple.of[0], near_radius);
      if (near < 2) continue;
      std::uint32_t second = 0, third = 0;
      draw_two(random, near, second, third);
      triple.of[1] = subset.memory.near[second];
      triple.of[2] = subset.memory.near[third];
    } else {
      triple = draw_three(random, subset.count);
    }
    if (plane_through(subset.coordinates(triple.of[0]), subset.coordinates(triple.of[1]),
                      subset.coordinates(triple.of[2]), in_space, plane))
      return true;
  }
  return false;
}

inline float residual(const Subset& subset, std::uint32_t i, const Coefficients& k) noexcept {
  const detail::RansacPlanesMemory& m = subset.memory;
  return (k.x * m.x[i] + k.y * m.y[i]) + (k.z * m.z[i] + k.w * m.w[i]);
}

/// Step 4.
float optimised(const Subset& subset, float cost, LinearPlane& plane) noexcept {
  const bool in_space = subset.readings.in_space();
  for (const float gates : {2.0F, 1.5F, 1.0F}) {
    const Coefficients k = coefficients(plane);
    ModelSums sums;
    for (std::uint32_t i = 0; i < subset.count; ++i) {
      const float e = residual(subset, i, k);
      if (e * e < gates * gates) sums.add(subset.coordinates(i), in_space);
    }
    LinearPlane refitted;
    if (!fit_model(sums, subset.readings, refitted)) continue;
    const float refitted_cost = msac_cost(subset.rows(), coefficients(refitted));
    if (!(refitted_cost < cost)) continue;
    cost = refitted_cost;
    plane = refitted;
  }
  return cost;
}

/// Step 5, for second and third readings near the first.
double near_probability(const Subset& subset, const Consensus& best, double radius) noexcept {
  const Coefficients k = coefficients(best.plane);
  const std::uint32_t samples = best.inliers < near_samples ? best.inliers : near_samples;
  double sum = 0;
  std::uint32_t inlier = 0, sampled = 0;
  for (std::uint32_t i = 0; i < subset.count && sampled < samples; ++i) {
    const float e = residual(subset, i, k);
    if (!(e * e < 1)) continue;
    // Number s of the sample is inlier s · inliers / samples.
    if (std::uint64_t{inlier++} * samples < std::uint64_t{sampled} * best.inliers) continue;
    ++sampled;
    const std::uint32_t near = find_near(subset, i, radius);
    std::uint32_t inside = 0;
    for (std::uint32_t j = 0; j < near; ++j) {
      const float other = residual(subset, subset.memory.near[j], k);
      inside += other * other < 1 ? 1U : 0U;
    }
    if (inside >= 2) sum += (inside * (inside - 1.0)) / (near * (near - 1.0));
  }
  return sampled == 0 ? 0 : best.inliers / static_cast<double>(subset.count) * (sum / sampled);
}

RansacEvent event_of(const Subset& subset, const Triple& triple, std::uint32_t plane, std::uint32_t iteration,
                     float cost) noexcept {
  RansacEvent event{.plane = plane, .iteration = iteration, .cost = cost};
  for (int i = 0; i < 3; ++i) event.triple[i] = subset.memory.reading[triple.of[i]];
  return event;
}

}  // namespace

Consensus find_consensus(const Subset& subset, const RansacOptions& options, std::uint32_t plane) noexcept {
  Consensus best;
  best.cost = static_cast<float>(subset.count);
  std::uint32_t needed = subset.count < 3 ? 0 : options.max_iterations;
  for (; best.iterations < needed; ++best.iterations) {
    // Step 2.
    Pcg32 random(options.seed, plane * streams_a_plane + best.iterations);
    Triple triple;
    LinearPlane hypothesis;
    if (!draw_hypothesis(subset, options.near_radius, random, triple, hypothesis)) continue;
    // Step 3.
    const float cost = msac_cost(subset.rows(), coefficients(hypothesis));
    RansacEvent event = event_of(subset, triple, plane, best.iterations, cost);
    if (cost < best.cost) {
      // Step 4.
      best.cost = optimised(subset, cost, hypothesis);
      best.plane = hypothesis;
      best.inliers = count_inliers(subset.rows(), subset.count, coefficients(hypothesis));
      // Step 5.
      best.probability = options.near_radius > 0 ? near_probability(subset, best, options.near_radius)
                                                 : triple_probability(best.inliers, subset.count);
      needed = draws_needed(best.probability, options.confidence, options.max_iterations);
      event.best = true;
      event.inliers = best.inliers;
    }
    if (options.trace(event)) continue;
    best.cancelled = true;
    break;
  }
  return best;
}

}  // namespace straightedge::ransac
