// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "hough/angle_table.hpp"

#include "straightedge/trigonometry.hpp"

namespace straightedge::hough {
namespace {

void fill(HoughMemory& memory, std::size_t n, double theta, float inverse_rho) noexcept {
  const SineCosine at = sine_cosine(theta);
  memory.cosines[n] = static_cast<float>(at.cosine * static_cast<double>(inverse_rho));
  memory.sines[n] = static_cast<float>(at.sine * static_cast<double>(inverse_rho));
}

}  // namespace

void fill_angles_by_adding(HoughJob& job) noexcept {
  const float inverse_rho = 1.0F / job.grid.rho_step;
  auto theta = static_cast<float>(job.options.min_theta);
  for (std::size_t n = 0; n < job.memory.cosines.size(); ++n, theta += job.grid.theta_step)
    fill(job.memory, n, static_cast<double>(theta), inverse_rho);
}

void fill_angles_by_multiplying(HoughJob& job) noexcept {
  const float inverse_rho = 1.0F / job.grid.rho_step;
  const auto angles = static_cast<std::size_t>(job.grid.angles);
  for (std::size_t n = 0; n < angles; ++n)
    fill(job.memory, n, static_cast<double>(n) * static_cast<double>(job.grid.theta_step), inverse_rho);
}

}  // namespace straightedge::hough
