// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "pixel_labels.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "depth_surfaces.hpp"
#include "four_labels.hpp"
#include "labels_around.hpp"
#include "pixel_choice.hpp"
#include "straightedge/square_root.hpp"

namespace straightedge::detail {
namespace {

// Squares, or cells, that are filled at once: so few that a bent plane is flat over them.
constexpr std::int32_t longest_run = 4;

// A cell's mean squared residual, in variances of the noise.
constexpr float fits_well = 1.5F;
constexpr float far_away = 25;

// What a cell is, in place of the one plane that it and all cells around have.
constexpr std::uint16_t none = 0;  // no plane anywhere around
constexpr std::uint16_t border = 0xFFFF;
constexpr std::uint16_t done = 0xFFFE;

struct Pixels {
  const PixelLabeller& work;
  ImageView<std::uint16_t> labels;
  std::span<InverseDepthMoments> moments;

  /// Pixels with one and the same plane around: each within the gate is its. The plane is taken for flat.
  void fill(std::int32_t left, std::int32_t top, Size size, const InverseDepthMoments& sum,
            std::uint16_t only) const noexcept {
    if (work.shown[only - 1U] == 0) return clear(left, top, size);
    const InverseDepthPlane plane = work.planes[only - 1U].tangent(sum.u / sum.n, sum.v / sum.n);
    const double limit = work.gate.sigmas * work.gate.inverse_noise(sum.q / sum.n);
    const ImageView<const float>& q = work.inverse_depth;
    const DepthBlock block{{q.row(top) + left, elements_apart(q)},
                           left,
                           top,
                           std::min(size.width, labels.width - left),
                           std::min(size.height, labels.height - top),
                           plane.at(left, top),
                           plane.a,
                           plane.b,
                           static_cast<float>(limit),
                           only};
    moments[only - 1U].add(sum);
    work.kernels.label_block(block, labels.row(top) + left, elements_apart(labels),
                             numbers_of(moments.subspan(only - 1U)));
  }
  void clear(std::int32_t left, std::int32_t top, Size size) const noexcept {
    const std::int32_t right = std::min(left + size.width, labels.width);
    for (std::int32_t y = top; y < std::min(top + size.height, labels.height); ++y) {
      std::fill(labels.row(y) + left, labels.row(y) + right, std::uint16_t{0});
    }
  }
};

/// Rows of cells that make squares of the coarser level `doublings` above.
struct Band {
  const Pixels& pixels;
  std::span<std::uint16_t> around;  ///< of all cells
  int doublings;
  std::int32_t top, bottom;  ///< rows of cells

  std::int32_t cells_across() const noexcept { return pixels.work.cells.size(finest()).width; }
  int finest() const noexcept { return pixels.work.cells.finest(); }
  std::uint16_t* row(std::int32_t y) const noexcept {
    return around.data() + static_cast<std::ptrdiff_t>(y) * cells_across();
  }
  /// The only plane of all cells of square X and around them, or 0.
  std::uint16_t only_plane(std::int32_t X) const noexcept {
    const std::int32_t left = X << doublings, right = std::min(left + (1 << doublings), cells_across());
    const std::uint16_t first = row(top)[left];
    for (std::int32_t y = top; y < bottom; ++y) {
      if (right - left == 4 && four(row(y) + left) == first * four_ones) continue;
      for (std::int32_t x = left; x < right; ++x) {
        if (row(y)[x] != first) return 0;
      }
    }
    return first < done ? first : none;
  }
  /// Fills runs of squares.
  void fill_squares() const noexcept {
    const int level = finest() + doublings;
    const std::int32_t side = DepthCells::side_of(level), width = pixels.work.cells.size(level).width;
    const auto first = static_cast<std::size_t>(top >> doublings) * static_cast<std::size_t>(width);
    const DepthCells& cells = pixels.work.cells;
    const float* readings = cells.rows(level, first).first;
    for (std::int32_t X = 0; X < width;) {
      const std::uint16_t only = only_plane(X);
      std::int32_t end = X + 1;
      if (only != 0 && readings[X] > 0) {
        InverseDepthMoments sum = cells.moments(level, first + static_cast<std::size_t>(X));
        for (; end < width && end - X < longest_run && only_plane(end) == only; ++end) {
          sum.add(cells.moments(level, first + static_cast<std::size_t>(end)));
        }
        pixels.fill(X * side, top * DepthCells::side_of(finest()), {(end - X) * side, side}, sum, only);
        mark_done(X << doublings, std::min(end << doublings, cells_across()));
      }
      X = end;
    }
  }
  /// Whether the cell is its own plane's, without a doubt: it fits well, and the others around do not at all.
  bool is_clear(std::int32_t x, std::int32_t y) const noexcept {
    const PixelLabeller& work = pixels.work;
    const Size size = work.cells.size(finest());
    const auto place =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x);
    const std::uint16_t own = work.cell_labels[place];
    if (own == 0) return false;
    const DepthCell cell = work.cells.at(finest(), place);
    const auto noise = static_cast<float>(work.gate.inverse_noise(static_cast<double>(cell.q)));
    const float unit = cell.n * (noise * noise);
    if (!(squared_residuals(cell, surface_of(work.surfaces, own - 1U)) < fits_well * unit)) return false;
    const LabelsAround near(size, work.cell_labels, x, y);
    for (std::size_t k = 0; k < near.count; ++k) {
      if (near.labels[k] == own) continue;
      const DepthSurface other = surface_of(work.surfaces, near.labels[k] - 1U);
      if (!(squared_residuals(cell, other) > far_away * unit)) return false;
    }
    return true;
  }
  /// Border cells that are clear take their plane.
  void clear_borders(std::int32_t y) const noexcept {
    const std::uint16_t* own =
        pixels.work.cell_labels.data() + static_cast<std::ptrdiff_t>(y) * cells_across();
    for (std::int32_t x = 0; x < cells_across(); ++x) {
      if (row(y)[x] == border && is_clear(x, y)) row(y)[x] = own[x];
    }
  }
  /// What squares left over.
  void label_row(std::int32_t y, PixelChoice& choice) const noexcept {
    const std::int32_t side = DepthCells::side_of(finest()), width = cells_across();
    const std::uint16_t* of = row(y);
    const DepthCells& cells = pixels.work.cells;
    const auto first = static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
    const float* readings = cells.rows(finest(), first).first;
    const auto is_empty = [&](std::int32_t x) noexcept {
      return of[x] == none || (of[x] != done && !(readings[x] > 0));
    };
    for (std::int32_t x = 0; x < width;) {
      std::int32_t end = x + 1;
      if (is_empty(x)) {
        while (end < width && is_empty(end)) ++end;
        pixels.clear(x * side, y * side, {(end - x) * side, side});
      } else if (of[x] == border) {
        choice.label_cell(x, y);
      } else if (of[x] != done) {
        InverseDepthMoments sum = cells.moments(finest(), first + static_cast<std::size_t>(x));
        for (; end < width && end - x < longest_run && of[end] == of[x]; ++end) {
          sum.add(cells.moments(finest(), first + static_cast<std::size_t>(end)));
        }
        pixels.fill(x * side, y * side, {(end - x) * side, side}, sum, of[x]);
      }
      x = end;
    }
  }

 private:
  void mark_done(std::int32_t left, std::int32_t right) const noexcept {
    for (std::int32_t y = top; y < bottom; ++y) std::fill(row(y) + left, row(y) + right, done);
  }
};

}  // namespace

bool PixelLabeller::some_are_small() const noexcept {
  const double side = DepthCells::side_of(cells.finest());
  // Those whose cells, with a ring of cells around a square of them, are too few: others have a chance.
  return std::any_of(sums.begin(), sums.end(), [&](const QuadraticSums& sum) noexcept {
    return sum.n + 4 * side * square_root(sum.n) < min_pixels;
  });
}

void PixelLabeller::find_shown(std::span<const std::uint16_t> around,
                               std::span<InverseDepthMoments> most) const noexcept {
  // A plane's pixels lie in cells that have it around.
  const Size size = cells.size(cells.finest());
  const float* readings = cells.rows(cells.finest(), 0).first;
  std::size_t i = 0;
  for (std::int32_t y = 0; y < size.height; ++y) {
    for (std::int32_t x = 0; x < size.width; ++x, ++i) {
      const auto count = static_cast<double>(readings[i]);
      if (around[i] != border) {
        if (around[i] != none) most[around[i] - 1U].n += count;
        continue;
      }
      const LabelsAround near(size, cell_labels, x, y);
      for (std::size_t k = 0; k < near.count; ++k) most[near.labels[k] - 1U].n += count;
    }
  }
  for (std::size_t k = 0; k < most.size(); ++k) {
    if (most[k].n < min_pixels) shown[k] = 0;
    most[k] = {};
  }
}

void PixelLabeller::label(ImageView<std::uint16_t> labels, std::span<InverseDepthMoments> moments,
                          std::span<std::uint16_t> scratch) const noexcept {
  for (InverseDepthMoments& m : moments) m = {};
  for (std::size_t k = 0; k < planes.size(); ++k) shown[k] = static_cast<std::uint16_t>(k + 1);
  const Pixels pixels{*this, labels, moments};
  PixelChoice choice(*this, labels, moments);
  fill_surfaces(planes, cells, surfaces);
  const Size size = cells.size(cells.finest());
  for (std::int32_t y = 0; y < size.height; ++y) {
    const std::ptrdiff_t width = size.width, first = y * width;
    const std::uint16_t* here = cell_labels.data() + first;
    kernels.look_around(y > 0 ? here - width : here, here, y + 1 < size.height ? here + width : here,
                        size.width, scratch.data() + first);
  }
  if (some_are_small()) find_shown(scratch, moments);
  const int doublings = std::min(2, DepthCells::levels - 1 - cells.finest());
  for (std::int32_t top = 0; top < size.height; top += 1 << doublings) {
    const Band band{pixels, scratch, doublings, top, std::min(top + (1 << doublings), size.height)};
    band.fill_squares();
    for (std::int32_t y = top; y < band.bottom; ++y) {
      band.clear_borders(y);
      band.label_row(y, choice);
    }
  }
}

}  // namespace straightedge::detail
