// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/win.hpp"

#include "straightedge/square_root.hpp"

namespace straightedge::ransac {
namespace {

/// Planes whose scores in the subset differ by less than so many standard deviations look at more readings.
constexpr double contest_sigmas = 3;
/// One of so many rows of a frame, or blocks of a cloud, and how wide the gate of their least squares is.
constexpr std::uint32_t contest_part = 8;
constexpr double contest_gates = 2;

/// Least squares over some of the readings, those of a wider gate: the subset alone leaves a plane tilted.
LinearPlane refined(const Verify& all, const LinearPlane& plane) noexcept {
  std::uint32_t seen = 0;
  LinearPlane found;
  const Verify wide{all.readings, all.labels, all.kernels, contest_gates};
  const ModelSums sums = wide.sum_inliers(plane, contest_part, seen);
  return fit_model(sums, all.readings, found) ? found : plane;
}

}  // namespace

LinearPlane win(const Verify& all, const Subset& subset, const Consensus& found) noexcept {
  const auto score = [&](std::uint32_t i) {
    return static_cast<double>(subset.count) - static_cast<double>(found.candidates[i].cost);
  };
  // Each score is a sum of numbers up to 1, so its variance is at most the score.
  const double best = score(found.best);
  const double least = best - contest_sigmas * square_root(2 * best);
  const auto inliers_of = [&](const LinearPlane& plane) { return all.count_inliers(plane, contest_part); };
  LinearPlane winner = refined(all, found.candidates[found.best].plane);
  std::uint32_t most = 0;
  for (std::uint32_t i = 0; i < found.count; ++i) {
    if (i == found.best || score(i) < least) continue;
    if (most == 0) most = inliers_of(winner);
    const LinearPlane other = refined(all, found.candidates[i].plane);
    const std::uint32_t inliers = inliers_of(other);
    if (inliers <= most) continue;
    most = inliers;
    winner = other;
  }
  return winner;
}

}  // namespace straightedge::ransac
