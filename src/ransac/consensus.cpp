// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/consensus.hpp"

#include "ransac/optimise.hpp"
#include "ransac/triple.hpp"
#include "straightedge/ransac_stop.hpp"
#include "straightedge/square_root.hpp"

namespace straightedge::ransac {
namespace {

/// Triples on a line are drawn again so many times.
constexpr int redraws = 8;
/// Streams of one plane's hypotheses; those of its subset begin above.
constexpr std::uint64_t streams_a_plane = std::uint64_t{1} << 32U;
/// First readings that stand for all in the mean of step 5.
constexpr std::uint32_t near_samples = 64;
/// One of so many readings looks at a hypothesis first, but at least so many.
constexpr std::uint32_t rough_part = 8, least_rough = 128;
/// Three readings make a plane that is worse than it could be: so much of the best score is enough for a look
/// at all of the subset, and standard deviations that chance may have taken from it.
constexpr double worth_a_look = 0.7, rough_sigmas = 2;

/// A plane through three readings, which are kept in its place: few are looked at again.
struct Hypothesis {
  Triple triple;
  bool made = false;
};

struct Search {
  const Subset& subset;
  const RansacOptions& options;
  const RansacKernels& kernels;
  Consensus& found;
  Rows rows, rough;
  std::uint32_t rough_readings = 0;
  float rough_limit = 0;  ///< cost in the rough rows above which a hypothesis is not worth a look

  double score(float cost) const noexcept {
    return static_cast<double>(subset.count) - static_cast<double>(cost);
  }
};

/// False: no plane.
bool plane_of(const Subset& subset, const Triple& triple, LinearPlane& plane) noexcept {
  return plane_through(subset.coordinates(triple.of[0]), subset.coordinates(triple.of[1]),
                       subset.coordinates(triple.of[2]), subset.readings.in_space(), plane);
}

/// Step 2. False: no plane.
bool draw_hypothesis(const Subset& subset, double near_radius, Pcg32& random, Hypothesis& h,
                     LinearPlane& plane) noexcept {
  for (int i = 0; i < redraws; ++i) {
    if (near_radius > 0) {
      h.triple.of[0] = random.below(subset.count);
      const std::uint32_t near = find_near(subset, h.triple.of[0], near_radius);
      if (near < 2) continue;
      std::uint32_t second = 0, third = 0;
      draw_two(random, near, second, third);
      h.triple.of[1] = subset.memory.near[second];
      h.triple.of[2] = subset.memory.near[third];
    } else {
      h.triple = draw_three(random, subset.count);
    }
    if (plane_of(subset, h.triple, plane)) return true;
  }
  return false;
}

inline float residual(const Subset& subset, std::uint32_t i, const Coefficients& k) noexcept {
  const detail::RansacPlanesMemory& m = subset.memory;
  return (k.x * m.x[i] + k.y * m.y[i]) + (k.z * m.z[i] + k.w * m.w[i]);
}

/// Within a gate of one another at the readings that made them.
bool alike(const Subset& subset, const Candidate& a, const Candidate& b) noexcept {
  const Coefficients ka = coefficients(a.plane), kb = coefficients(b.plane);
  for (const Triple* const triple : {&a.triple, &b.triple}) {
    for (const std::uint32_t i : triple->of) {
      const float apart = residual(subset, i, ka) - residual(subset, i, kb);
      if (!(apart * apart < 1)) return false;
    }
  }
  return true;
}

/// Step 5, for second and third readings near the first.
double near_probability(const Search& s, const LinearPlane& best, double radius) noexcept {
  const Subset& subset = s.subset;
  const Coefficients k = coefficients(best);
  const std::uint32_t inliers = s.found.inliers;
  const std::uint32_t samples = inliers < near_samples ? inliers : near_samples;
  double sum = 0;
  std::uint32_t inlier = 0, sampled = 0;
  for (std::uint32_t i = 0; i < subset.count && sampled < samples; ++i) {
    const float e = residual(subset, i, k);
    if (!(e * e < 1)) continue;
    // Number s of the sample is inlier s · inliers / samples.
    if (std::uint64_t{inlier++} * samples < std::uint64_t{sampled} * inliers) continue;
    ++sampled;
    const std::uint32_t near = find_near(subset, i, radius);
    std::uint32_t inside = 0;
    for (std::uint32_t j = 0; j < near; ++j) {
      const float other = residual(subset, subset.memory.near[j], k);
      inside += other * other < 1 ? 1U : 0U;
    }
    if (inside >= 2) sum += (inside * (inside - 1.0)) / (near * (near - 1.0));
  }
  return sampled == 0 ? 0 : inliers / static_cast<double>(subset.count) * (sum / sampled);
}

/// Of the readings that look first a share as large as that of all, less what chance may have taken: the
/// least x with x + sigmas √x >= the share.
float rough_limit(const Search& s, float best_cost) noexcept {
  const double share = worth_a_look * s.score(best_cost) * s.rough_readings / s.subset.count;
  const double half = rough_sigmas / 2;
  const double root = square_root(half * half + share) - half;
  return static_cast<float>(s.rough_readings - root * root);
}

/// A new best. Returns how many draws are needed now.
std::uint32_t accept(Search& s, std::uint32_t index) noexcept {
  const Candidate& best = s.found.candidates[index];
  s.found.best = index;
  s.found.inliers = s.kernels.count_rows(s.rows, coefficients(best.plane)) - (s.rows.count - s.subset.count);
  s.rough_limit = rough_limit(s, best.cost);
  // Step 5.
  const double radius = s.options.near_radius;
  s.found.probability = radius > 0 ? near_probability(s, best.plane, radius)
                                   : triple_probability(s.found.inliers, s.subset.count);
  return draws_needed(s.found.probability, s.options.confidence, s.options.max_iterations);
}

/// Step 4, and where the plane belongs among the candidates: in place of one that is like it, of none, or of
/// the dearest. Returns its index, or Consensus::most: nowhere.
std::uint32_t offer(Search& s, const Candidate& drawn) noexcept {
  Consensus& found = s.found;
  Candidate made = drawn;
  std::uint32_t dearest = 0, like = found.count;
  for (std::uint32_t i = 0; i < found.count; ++i) {
    if (found.candidates[i].cost > found.candidates[dearest].cost) dearest = i;
    if (alike(s.subset, made, found.candidates[i])) like = i;
  }
  if (like < found.count && !(drawn.cost < found.candidates[like].cost)) return Consensus::most;
  made.cost = optimise(s.subset, s.kernels, drawn.cost, made.plane);
  for (std::uint32_t i = 0; like == found.count && i < found.count; ++i)
    if (alike(s.subset, made, found.candidates[i])) like = i;
  std::uint32_t at = like;
  if (at == found.count && at == Consensus::most) at = dearest;
  if (at < found.count && !(made.cost < found.candidates[at].cost)) return Consensus::most;
  if (at == found.count) ++found.count;
  found.candidates[at] = made;
  return at;
}

RansacEvent event_of(const Subset& subset, const Triple& triple, std::uint32_t plane, std::uint32_t iteration,
                     float cost) noexcept {
  RansacEvent event{.plane = plane, .iteration = iteration, .cost = cost};
  for (int i = 0; i < 3; ++i) event.triple[i] = subset.memory.reading[triple.of[i]];
  return event;
}

/// Step 2 for the next sixteen hypotheses.
void draw_batch(const Search& s, std::uint64_t first_stream, Hypothesis* batch,
                RansacBatch& planes) noexcept {
  for (std::uint32_t h = 0; h < ransac_lanes; ++h) {
    Pcg32 random(s.options.seed, first_stream + h);
    LinearPlane plane;
    batch[h].made = draw_hypothesis(s.subset, s.options.near_radius, random, batch[h], plane);
    const Coefficients k = coefficients(plane);
    planes.x[h] = k.x;
    planes.y[h] = k.y;
    planes.z[h] = k.z;
    planes.w[h] = k.w;
  }
}

/// Steps 3 to 5 for one of them. Returns how many are needed now; 0 when the trace stops.
std::uint32_t try_hypothesis(Search& s, const Hypothesis& h, float rough_cost, std::uint32_t plane,
                             std::uint32_t needed) noexcept {
  // Step 3.
  const bool worth = rough_cost <= s.rough_limit;
  if (!worth && s.options.trace.event == nullptr) return needed;
  Candidate drawn{{}, h.triple, 0};
  (void)plane_of(s.subset, h.triple, drawn.plane);
  drawn.cost = s.kernels.row_cost(s.rows, coefficients(drawn.plane));
  RansacEvent event = event_of(s.subset, h.triple, plane, s.found.iterations, drawn.cost);
  const double best = s.found.count == 0 ? 0 : s.score(s.found.candidates[s.found.best].cost);
  if (worth && s.score(drawn.cost) > worth_a_look * best) {
    // Step 4.
    const bool first = s.found.count == 0;
    const std::uint32_t at = offer(s, drawn);
    if (at < Consensus::most &&
        (first || s.found.candidates[at].cost < s.found.candidates[s.found.best].cost ||
         at == s.found.best)) {
      needed = accept(s, at);
      event.best = true;
      event.inliers = s.found.inliers;
    }
  }
  return s.options.trace(event) ? needed : 0;
}

}  // namespace

Consensus find_consensus(const Subset& subset, const RansacOptions& options, std::uint32_t plane) noexcept {
  Consensus found;
  if (subset.count < 3) return found;
  Search s{.subset = subset,
           .options = options,
           .kernels = *options.kernels,
           .found = found,
           .rows = subset.rows(),
           .rough = subset.rows()};
  const std::uint32_t part =
      subset.count / rough_part > least_rough ? subset.count / rough_part : least_rough;
  s.rough_readings = part < subset.count ? part : subset.count;
  s.rough.count = s.rough_readings;
  s.rough_limit = static_cast<float>(s.rough_readings);
  Hypothesis batch[ransac_lanes];
  RansacBatch planes;
  float costs[ransac_lanes];
  std::uint32_t needed = options.max_iterations;
  while (found.iterations < needed) {
    draw_batch(s, plane * streams_a_plane + found.iterations, batch, planes);
    s.kernels.batch_costs(s.rough, planes, costs);
    for (std::uint32_t h = 0; h < ransac_lanes && found.iterations < needed; ++h) {
      if (batch[h].made) needed = try_hypothesis(s, batch[h], costs[h], plane, needed);
      if (needed == 0) break;
      ++found.iterations;
    }
  }
  found.cancelled = needed == 0;
  return found;
}

}  // namespace straightedge::ransac
