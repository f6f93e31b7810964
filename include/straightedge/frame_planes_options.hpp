// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "straightedge/depth_kernels.hpp"
#include "straightedge/detail/has_table.hpp"
#include "straightedge/image.hpp"
#include "straightedge/plane_gate.hpp"

namespace straightedge {

/// A number that is NaN or outside its range gives `invalid_option`.
struct FramePlanesOptions {
  PlaneGate gate = {};
  /// A plane with fewer pixels leaves; 0: one thousandth of the picture, at least 64.
  std::uint32_t min_pixels = 0;
  std::uint32_t max_planes = 64;  ///< at most 256
  /// Searches at most, each on what is left over, up to 8; 0: as many as the search asks for.
  std::uint32_t rounds = 0;
  /// Neighbours of a reading share its noise; so many pixels count as one independent reading. 1 to 1000.
  double noise_pixels = 28;
  /// Real frames stray further from planes than the noise model says; residuals may be so many times larger
  /// in every test. 1 to 10.
  double slack = 1.4;
  bool reject_curved = true;  ///< flat strips of balls and pillars are no planes
  /// Side of the smallest cells, pixels: 4, 8 or 16. With larger ones a frame takes less time and memory, and
  /// faces that are thin or small are lost; see for_large_planes.
  std::int32_t cell = 4;
  const DepthKernels* kernels = &plain_depth_kernels;  ///< not null
};

/// What min_pixels comes to for pictures of a size.
constexpr std::uint32_t least_pixels(Size size, const FramePlanesOptions& options) noexcept {
  if (options.min_pixels > 0) return options.min_pixels;
  const std::size_t share =
      static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) / 1000;
  return share > 64 ? static_cast<std::uint32_t>(share < 0xFFFFFFF ? share : 0xFFFFFFF) : 64U;
}

/// Planes that fill at least this share of the picture, (0, 1], in the shortest time: one search, cells of 8
/// pixels. More slack: few large faces are flat to the noise, such as walls of brick or the fronts of books.
constexpr FramePlanesOptions for_large_planes(Size size, double share = 0.05) noexcept {
  const double pixels = share * size.width * size.height;
  FramePlanesOptions options;
  options.min_pixels = pixels >= 64 && pixels <= 0xFFFFFFF ? static_cast<std::uint32_t>(pixels) : 64U;
  options.rounds = 1;
  options.cell = 8;
  options.slack = 2;
  return options;
}

/// The gate with its noise as `slack` widens it: the one for the search, too.
constexpr PlaneGate widened(const FramePlanesOptions& options) noexcept {
  PlaneGate gate = options.gate;
  gate.inverse_sigma *= options.slack;
  return gate;
}

namespace detail {

constexpr bool valid(const FramePlanesOptions& o) noexcept {
  return o.gate.valid() && o.max_planes >= 1 && o.max_planes <= 256 && o.rounds <= 8 &&
         o.noise_pixels >= 1 && o.noise_pixels <= 1000 && o.slack >= 1 && o.slack <= 10 &&
         (o.cell == 4 || o.cell == 8 || o.cell == 16) && has_table(o.kernels);
}

/// The level of DepthCells whose cells are the smallest.
constexpr int finest_level(const FramePlanesOptions& o) noexcept {
  return o.cell == 4 ? 0 : o.cell == 8 ? 1 : 2;
}

/// Sixteen cells beside one another.
constexpr std::size_t cell_groups(Size cells) noexcept {
  return static_cast<std::size_t>(cells.height) * static_cast<std::size_t>((cells.width + 15) / 16);
}

}  // namespace detail
}  // namespace straightedge
