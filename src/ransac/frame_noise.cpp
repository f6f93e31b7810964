// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/frame_noise.hpp"

#include "ransac/window.hpp"
#include "straightedge/square_root.hpp"

namespace straightedge::ransac {
namespace {

/// Windows of 97 pixels with cells of four: at this scale depth bends and its noise drifts.
constexpr WindowShape shape{12, 2};
constexpr float widening = 3;
constexpr std::uint32_t most_windows = 64;
constexpr std::uint32_t least_windows = 4;
constexpr std::uint32_t least_readings = 48;
constexpr std::uint64_t first_stream = std::uint64_t{1} << 33U;

/// Root mean square of the residuals in gates, those beyond three times of it left out; 0 if that leaves less
/// than half of the window.
double trimmed_rms(const Window& w, const InverseDepthPlane& plane) noexcept {
  const double c = plane.c + plane.a * w.u0 + plane.b * w.v0;
  double limit = 1;
  double mean = 0;
  for (int round = 0; round < 4; ++round) {
    double sum = 0;
    std::uint32_t inside = 0;
    for (std::uint32_t i = 0; i < w.count; ++i) {
      const double p = plane.a * static_cast<double>(w.u[i]) + plane.b * static_cast<double>(w.v[i]) + c;
      const double e = (static_cast<double>(w.q[i]) - p) * static_cast<double>(w.z[i]);
      if (e * e >= limit) continue;
      sum += e * e;
      ++inside;
    }
    if (2 * inside < w.count) return 0;
    mean = sum / inside;
    limit = 9 * mean;
  }
  return square_root(mean) * static_cast<double>(widening);
}

}  // namespace

double frame_noise(const Lattice& lattice, const RansacSearchOptions& options) noexcept {
  if (options.gate.fixed_m > 0) return 1;
  const std::int32_t apart = 2 * shape.half;
  double sorted[most_windows];
  std::uint32_t count = 0;
  std::uint64_t stream = first_stream;
  Window& window = lattice.memory.window.front();
  for (std::int32_t row = shape.half; row < lattice.rows; row += apart) {
    for (std::int32_t column = shape.half; column < lattice.columns && count < most_windows;
         column += apart) {
      gather(lattice, column, row, shape, widening, window);
      if (window.count < least_readings) continue;
      const WindowPlane found = best_of_window(window, options, stream++);
      const double rms = trimmed_rms(window, found.plane) * options.gate.sigmas;
      if (!(rms > 0)) continue;
      std::uint32_t at = count++;
      for (; at > 0 && sorted[at - 1] > rms; --at) sorted[at] = sorted[at - 1];
      sorted[at] = rms;
    }
  }
  const double noise = count < least_windows ? 1 : sorted[count / 4];
  return noise < 1 ? 1 : (noise > options.most_noise ? options.most_noise : noise);
}

}  // namespace straightedge::ransac
