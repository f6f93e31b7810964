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

void widen(Window& w) noexcept {
  for (std::uint32_t i = 0; i < padded(w); ++i) w.w[i] /= widening;
}

/// Root mean square of the residuals in gates, those beyond three times of it left out; 0 if that leaves less
/// than half of the window.
double trimmed_rms(const Lattice& lattice, const Window& w, const SearchPlane& plane) noexcept {
  float limit = 1;
  double mean = 0;
  for (int round = 0; round < 4; ++round) {
    const SearchInliers inside = lattice.kernels.find_inliers(readings_of(w), padded(w), plane, limit);
    if (2 * inside.count < w.count) return 0;
    mean = static_cast<double>(inside.squares) / inside.count;
    limit = static_cast<float>(9 * mean);
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
      gather(lattice, column, row, shape, window);
      if (window.count < least_readings) continue;
      widen(window);
      const WindowPlane found = best_of_window(lattice, window, options, stream++);
      const double rms = trimmed_rms(lattice, window, found.local) * options.gate.sigmas;
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
