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

/// Step 2 of depth_cells.hpp for what rows [top, bottom) of the smallest cells are part of.
void sum_up_rows(const DepthCells& cells, std::int32_t top, std::int32_t bottom,
                 const DepthKernels& kernels) noexcept {
  for (int fine = cells.finest(); fine + 1 < DepthCells::levels; ++fine) {
    const Size from = cells.size(fine), to = cells.size(fine + 1);
    top /= 2;
    bottom = (bottom + 1) / 2;
    const Size band{from.width, std::min(2 * bottom, from.height) - 2 * top};
    join_cells(cells.rows(fine, static_cast<std::size_t>(2 * top * from.width)), band,
               cells.rows(fine + 1, static_cast<std::size_t>(top * to.width)), kernels);
  }
}

}  // namespace

void FramePlanes::count_solid(const PinholeCamera& camera, bool drop_crumbs) noexcept {
  const std::span<std::uint16_t> labels = small_cell_labels();
  const double least = solid_pixels(size_, options_), of_cell = options_.cell * options_.cell;
  std::fill_n(cells_of_.begin(), count_, 0U);
  std::fill_n(solid_.begin(), count_, 0U);
  std::fill_n(loose_.begin(), count_, detail::QuadraticSums{});
  const detail::CellPieces pieces{cells_.size(cells_.finest()), labels, visited_, runs_};
  pieces.find();
  const auto is_crumb = [&](std::int32_t cells) noexcept {
    return drop_crumbs && cells * of_cell < crumb_share * least;
  };
  pieces.for_runs(
      [&](std::int32_t begin, std::int32_t end, std::uint16_t label, std::int32_t cells) noexcept {
        const auto run = static_cast<std::uint32_t>(end - begin);
        if (!is_crumb(cells)) cells_of_[label - 1U] += run;
        if (cells * of_cell >= least) {
          solid_[label - 1U] += run;
        } else {
          const auto again = static_cast<std::uint16_t>(label | detail::CellLabeller::fresh);
          std::fill(labels.begin() + begin, labels.begin() + end, again);
        }
      });
  detail::PlaneSurfaces(size_, camera, options_).add_fresh(cells_, labels, loose_);
  if (!drop_crumbs) return;
  pieces.for_runs([&](std::int32_t begin, std::int32_t end, std::uint16_t, std::int32_t cells) noexcept {
    if (is_crumb(cells)) std::fill(labels.begin() + begin, labels.begin() + end, std::uint16_t{0});
  });
}

void FramePlanes::judge(const PinholeCamera& camera, bool last) noexcept {
  // Step 5.
  count_solid(camera, last);
  dropped_ = false;
  bool round = false;
  for (std::uint16_t k = 0; k < count_; ++k) {
    detail::QuadraticSums solid = sums_[k];
    solid.take_off(loose_[k]);
    const detail::PlaneShape shape =
        detail::plane_shape(cells_of_[k], solid_[k], solid, size_, options_, camera);
    becomes_[k] = shape == detail::PlaneShape::flat   ? k
                  : shape == detail::PlaneShape::bent ? gone_with_cells
                                                      : gone;
    dropped_ = dropped_ || shape != detail::PlaneShape::flat;
    round = round || shape == detail::PlaneShape::bent;
  }
  if (round) clear_round();
  keep();
}

void FramePlanes::clear_round() noexcept {
  const std::span<const std::uint16_t> labels = small_cell_labels();
  const std::int32_t width = cells_.size(cells_.finest()).width;
  std::int32_t top = cells_.size(cells_.finest()).height, bottom = 0;
  for (std::size_t cell = 0; cell < labels.size(); ++cell) {
    if (labels[cell] == 0 || becomes_[labels[cell] - 1U] != gone_with_cells) continue;
    const auto i = static_cast<std::int32_t>(cell);
    clear_cell(i);
    top = std::min(top, i / width);
    bottom = i / width + 1;
  }
  if (top < bottom) sum_up_rows(cells_, top, bottom, *options_.kernels);
}

void FramePlanes::clear_cell(std::int32_t cell) noexcept {
  const std::int32_t side = options_.cell, width = cells_.size(cells_.finest()).width;
  const std::int32_t left = cell % width * side, top = cell / width * side;
  cells_.set(cells_.finest(), static_cast<std::size_t>(cell), {});
  cells_.counts()[static_cast<std::size_t>(cell)] = 0;
  for (std::int32_t y = top; y < std::min(top + side, size_.height); ++y) {
    std::fill(inverse_depth_.row(y) + left, inverse_depth_.row(y) + std::min(left + side, size_.width), 0.0F);
  }
}

}  // namespace straightedge
