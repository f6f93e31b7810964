// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "join_planes.hpp"

#include <algorithm>

#include "inverse_noise.hpp"

namespace straightedge::detail {
namespace {

// One true pair in a hundred lies further apart (chi-square, 3 degrees of freedom).
constexpr double chi_square_gate = 11.34;
// Two planes that share the cells of one surface part them by the sign of their noise, and so lie about one
// standard deviation apart; real ones so near cannot be told apart. Root mean square over the smaller one.
constexpr double floor_deviations = 1.5;

/// What it costs, in squared residuals, that both have one plane instead of their own.
bool are_one(const ProposedPlane& a, const InverseDepthMoments& of_a, const ProposedPlane& b,
             const InverseDepthMoments& of_b, const FramePlanesOptions& options,
             InverseDepthFit& both) noexcept {
  InverseDepthMoments sum = of_a;
  sum.add(of_b);
  const double noise = inverse_noise(options.gate, sum.q / sum.n);
  if (fit_inverse_depth(sum, noise, both) != Status::ok) return false;
  const double apart = squared_residuals(of_a, a.fit.plane) + squared_residuals(of_b, b.fit.plane);
  const double cost = (squared_residuals(sum, both.plane) - apart) / (noise * noise);
  const double floor = floor_deviations * floor_deviations * of_a.n * of_b.n / sum.n;
  return cost < chi_square_gate * options.noise_pixels + floor;
}

}  // namespace

void join_planes(std::span<ProposedPlane> planes, std::span<InverseDepthMoments> moments,
                 const FramePlanesOptions& options, std::span<std::uint16_t> becomes) noexcept {
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (becomes[i] != i) continue;
    for (std::size_t j = i + 1; j < planes.size(); ++j) {
      InverseDepthFit both;
      if (becomes[j] != j || !are_one(planes[i], moments[i], planes[j], moments[j], options, both)) continue;
      planes[i].fit = both;
      planes[i].score += planes[j].score;
      planes[i].confidence = std::max(planes[i].confidence, planes[j].confidence);
      planes[i].iterations += planes[j].iterations;
      moments[i].add(moments[j]);
      becomes[j] = static_cast<std::uint16_t>(i);
      j = i;  // the joined plane has moved: those that were refused may fit now
    }
  }
}

}  // namespace straightedge::detail
