// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/window.hpp"

#include "ransac/triple.hpp"
#include "straightedge/ransac_stop.hpp"

namespace straightedge::ransac {
namespace {

/// Twice the area of a triangle of pixels below which its plane is chance: the noise of the three readings
/// tilts it at will.
constexpr double least_area = 32;

Rows rows_of(const Window& w) noexcept {
  return {w.x, w.y, w.z, w.w, padded(w.count)};
}

void append(const Lattice& lattice, std::size_t cell, float widening, Window& w) noexcept {
  const std::uint32_t k = w.count++;
  const float inverse_gate = lattice.memory.w[cell] / widening;
  w.u[k] = lattice.memory.u[cell] - static_cast<float>(w.u0);
  w.v[k] = lattice.memory.v[cell] - static_cast<float>(w.v0);
  w.q[k] = lattice.memory.free_q[cell];
  w.x[k] = w.u[k] * inverse_gate;
  w.y[k] = w.v[k] * inverse_gate;
  w.z[k] = inverse_gate;
  w.w[k] = w.q[k] * inverse_gate;
}

Coefficients coefficients(const InverseDepthPlane& p) noexcept {
  return {static_cast<float>(-p.a), static_cast<float>(-p.b), static_cast<float>(-p.c), 1};
}

/// False: equal, on a line, or nearly so.
bool plane_through(const Window& w, const Triple& triple, InverseDepthPlane& plane) noexcept {
  double u[3], v[3], q[3];
  for (int i = 0; i < 3; ++i) {
    u[i] = static_cast<double>(w.u[triple.of[i]]);
    v[i] = static_cast<double>(w.v[triple.of[i]]);
    q[i] = static_cast<double>(w.q[triple.of[i]]);
  }
  const double area = (u[1] - u[0]) * (v[2] - v[0]) - (u[2] - u[0]) * (v[1] - v[0]);
  if (area * area < least_area * least_area) return false;
  plane.a = ((q[1] - q[0]) * (v[2] - v[0]) - (q[2] - q[0]) * (v[1] - v[0])) / area;
  plane.b = ((u[1] - u[0]) * (q[2] - q[0]) - (u[2] - u[0]) * (q[1] - q[0])) / area;
  plane.c = q[0] - plane.a * u[0] - plane.b * v[0];
  return true;
}

/// Least squares on the readings within so many gates.
bool refit(const Window& w, double gates, double sigma, InverseDepthPlane& plane) noexcept {
  const Coefficients k = coefficients(plane);
  const auto most = static_cast<float>(gates * gates);
  InverseDepthMoments m;
  for (std::uint32_t i = 0; i < w.count; ++i) {
    const float e = (k.x * w.x[i] + k.y * w.y[i]) + (k.z * w.z[i] + k.w * w.w[i]);
    if (e * e < most)
      m.add(static_cast<double>(w.u[i]), static_cast<double>(w.v[i]), static_cast<double>(w.q[i]));
  }
  InverseDepthFit fit;
  if (fit_inverse_depth(m, sigma, fit) != Status::ok) return false;
  plane = fit.plane;
  return true;
}

/// Local optimisation: refits with the threshold from wide to narrow, as long as they cost less.
float optimised(const Window& w, double sigma, float cost, InverseDepthPlane& plane) noexcept {
  for (const double gates : {1.5, 1.0}) {
    InverseDepthPlane refitted = plane;
    if (!refit(w, gates, sigma, refitted)) break;
    const float refitted_cost = msac_cost(rows_of(w), coefficients(refitted));
    if (!(refitted_cost < cost)) continue;
    cost = refitted_cost;
    plane = refitted;
  }
  return cost;
}

}  // namespace

void gather(const Lattice& lattice, std::int32_t column, std::int32_t row, const WindowShape& shape,
            float widening, Window& window) noexcept {
  window.count = 0;
  window.u0 = column * lattice.cell;
  window.v0 = row * lattice.cell;
  for (std::int32_t r = row - shape.half; r <= row + shape.half; r += shape.step) {
    if (r < 0 || r >= lattice.rows) continue;
    for (std::int32_t c = column - shape.half; c <= column + shape.half; c += shape.step) {
      if (c < 0 || c >= lattice.columns || window.count == Window::capacity) continue;
      const std::size_t cell = lattice.at(c, r);
      if (lattice.memory.free_q[cell] > 0) append(lattice, cell, widening, window);
    }
  }
  for (std::uint32_t k = window.count; k < padded(window.count); ++k)
    window.x[k] = window.y[k] = window.z[k] = window.w[k] = 0;
}

WindowPlane best_of_window(const Window& window, const RansacSearchOptions& options,
                           std::uint64_t stream) noexcept {
  WindowPlane found;
  const std::uint32_t n = window.count;
  const auto most = static_cast<std::uint32_t>(options.max_draws);
  Pcg32 random(options.seed, stream);
  auto best_cost = static_cast<float>(n);
  std::uint32_t needed = n < 3 ? 0 : most;
  for (; found.draws < needed; ++found.draws) {
    const Triple triple = draw_three(random, n);
    InverseDepthPlane plane;
    if (!plane_through(window, triple, plane)) continue;
    const float cost = msac_cost(rows_of(window), coefficients(plane));
    if (!(cost < best_cost)) continue;
    best_cost = optimised(window, options.gate.inverse_sigma, cost, plane);
    found.plane = plane;
    found.inliers = count_inliers(rows_of(window), n, coefficients(plane));
    needed = draws_needed(triple_probability(found.inliers, n), options.confidence, most);
  }
  found.plane.c -= found.plane.a * window.u0 + found.plane.b * window.v0;
  return found;
}

}  // namespace straightedge::ransac
