// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
// Step 5 of frame_planes.hpp.
#include <algorithm>

#include "cell_labels.hpp"
#include "cell_pieces.hpp"
#include "plane_shape.hpp"
#include "plane_surfaces.hpp"
#include "straightedge/frame_planes.hpp"

namespace straightedge {
namespace {

using detail::gone;

// Gone, and its cells as well.
constexpr std::uint16_t gone_with_cells = 0xFFFE;
// Pieces with fewer pixels than this share of the least plane are chance: other planes may have them.
constexpr double crumb_share = 0.3;

/// Pixels of a solid piece: as many cells as the least plane of the usual options has. A large plane may be
/// in pieces, as the front of a shelf is.
double solid_pixels(Size size, const FramePlanesOptions& options) noexcept {
  const double cells = static_cast<double>(least_pixels(size, {})) / (DepthCells::side * DepthCells::side);
  return std::min(cells * options.cell * options.cell, static_cast<double>(least_pixels(size, options)));
}

}  // namespace

void FramePlanes::count_solid(const PinholeCamera& camera) noexcept {
  const std::span<std::uint16_t> labels = small_cell_labels();
  const double least = solid_pixels(size_, options_), of_cell = options_.cell * options_.cell;
  std::fill_n(cells_of_.begin(), count_, 0U);
  std::fill_n(solid_.begin(), count_, 0U);
  std::fill_n(loose_.begin(), count_, detail::QuadraticSums{});
  const detail::CellPieces pieces{cells_.size(cells_.finest()), labels, visited_, runs_};
  pieces.find();
  pieces.for_runs([&](std::int32_t begin, std::int32_t end, std::uint16_t label) noexcept {
    const auto run = static_cast<std::uint32_t>(end - begin);
    cells_of_[label - 1U] += run;
    if (pieces.cells_of(begin) * of_cell >= least) {
      solid_[label - 1U] += run;
    } else {
      const auto again = static_cast<std::uint16_t>(label | detail::CellLabeller::fresh);
      std::fill(labels.begin() + begin, labels.begin() + end, again);
    }
  });
  detail::PlaneSurfaces(size_, camera, options_).add_fresh(cells_, labels, loose_);
}

void FramePlanes::judge(const PinholeCamera& camera) noexcept {
  // Step 5.
  count_solid(camera);
  bool round = false;
  for (std::uint16_t k = 0; k < count_; ++k) {
    detail::QuadraticSums solid = sums_[k];
    solid.take_off(loose_[k]);
    const detail::PlaneShape shape =
        detail::plane_shape(cells_of_[k], solid_[k], solid, size_, options_, camera);
    becomes_[k] = shape == detail::PlaneShape::flat   ? k
                  : shape == detail::PlaneShape::bent ? gone_with_cells
                                                      : gone;
    round = round || shape == detail::PlaneShape::bent;
  }
  if (round) clear_round();
  keep();
}

void FramePlanes::clear_round() noexcept {
  const Size size = cells_.size(cells_.finest());
  const std::int32_t width = size.width;
  std::int32_t top = size.height, bottom = 0;
  const detail::CellPieces pieces{size, small_cell_labels(), visited_, runs_};
  pieces.for_runs([&](std::int32_t begin, std::int32_t end, std::uint16_t label) noexcept {
    if (becomes_[label - 1U] != gone_with_cells) return;
    clear_cells(begin, end);
    top = std::min(top, begin / width);
    bottom = begin / width + 1;
  });
  if (top < bottom) cells_.sum_up(top, bottom, *options_.kernels);
}

void FramePlanes::clear_cells(std::int32_t begin, std::int32_t end) noexcept {
  for (std::int32_t cell = begin; cell < end; ++cell) {
    cells_.set(cells_.finest(), static_cast<std::size_t>(cell), {});
    cells_.counts()[static_cast<std::size_t>(cell)] = 0;
  }
  const std::int32_t side = options_.cell, width = cells_.size(cells_.finest()).width;
  const std::int32_t left = begin % width * side, right = std::min(left + (end - begin) * side, size_.width);
  const std::int32_t top = begin / width * side, bottom = std::min(top + side, size_.height);
  for (std::int32_t y = top; y < bottom; ++y) {
    std::fill(inverse_depth_.row(y) + left, inverse_depth_.row(y) + right, 0.0F);
  }
}

void FramePlanes::drop_crumbs() noexcept {
  const double least = crumb_share * solid_pixels(size_, options_), of_cell = options_.cell * options_.cell;
  const std::span<std::uint16_t> labels = small_cell_labels();
  // As the last judgement found them.
  const detail::CellPieces pieces{cells_.size(cells_.finest()), labels, visited_, runs_};
  pieces.for_runs([&](std::int32_t begin, std::int32_t end, std::uint16_t) noexcept {
    if (pieces.cells_of(begin) * of_cell < least)
      std::fill(labels.begin() + begin, labels.begin() + end, std::uint16_t{0});
  });
}

}  // namespace straightedge
