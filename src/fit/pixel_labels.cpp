// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "pixel_labels.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "labels_around.hpp"
#include "pixel_choice.hpp"

namespace straightedge::detail {
namespace {

// Squares, or cells, that are filled at once: so few that a bent plane is flat over them.
constexpr std::int32_t longest_run = 4;

// A cell's mean squared residual, in variances of the noise.
constexpr double fits_well = 1.5;
constexpr double far_away = 25;

// What a cell is, in place of the one plane that it and all cells around have.
constexpr std::int32_t none = 0;  // no plane anywhere around
constexpr std::int32_t border = -1;
constexpr std::int32_t done = -2;

struct Pixels {
  const PixelLabeller& work;
  ImageView<std::uint16_t> labels;
  std::span<InverseDepthMoments> moments;

  /// Pixels with one and the same plane around: each within the gate is its. The plane is taken for flat.
  void fill(std::int32_t left, std::int32_t top, Size size, const InverseDepthMoments& sum,
            std::uint16_t only) const noexcept {
    const InverseDepthPlane plane = work.planes[only - 1U].tangent(sum.u / sum.n, sum.v / sum.n);
    const double limit = work.gate.sigmas * work.gate.inverse_noise(sum.q / sum.n);
    const ImageView<const float>& q = work.inverse_depth;
    DepthBlock block{{q.row(top) + left, elements_apart(q)},
                     std::min(size.width, labels.width - left),
                     std::min(size.height, labels.height - top),
                     plane.at(left, top),
                     plane.a,
                     plane.b,
                     static_cast<float>(limit),
                     only};
    const DepthBlockCounts counts =
        work.kernels.label_block(block, labels.row(top) + left, elements_apart(labels));
    moments[only - 1U].add(sum);
    for (std::int32_t y = 0; y < block.height; ++y) {
      if ((counts.rows_missed >> static_cast<std::uint32_t>(y) & 1U) == 0) continue;
      subtract_missed(left, top + y, block.width, moments[only - 1U]);
    }
  }
  void clear(std::int32_t left, std::int32_t top, std::int32_t side) const noexcept {
    for (std::int32_t y = top; y < std::min(top + side, labels.height); ++y) {
      std::fill(labels.row(y) + left, labels.row(y) + std::min(left + side, labels.width), std::uint16_t{0});
    }
  }

 private:
  /// Takes the readings without a label out of the sum.
  void subtract_missed(std::int32_t left, std::int32_t y, std::int32_t width,
                       InverseDepthMoments& sum) const noexcept {
    const float* q = work.inverse_depth.row(y) + left;
    const std::uint16_t* label = labels.row(y) + left;
    InverseDepthMoments missed;
    constexpr std::int32_t at_once = 16;
    for (std::int32_t first = 0; first < width; first += at_once) {
      const std::int32_t end = std::min(first + at_once, width);
      int any = 0;
      for (std::int32_t x = first; x < end; ++x) {
        any |= static_cast<int>(q[x] > 0) & static_cast<int>(label[x] == 0);
      }
      for (std::int32_t x = first; any != 0 && x < end; ++x) {
        if (q[x] > 0 && label[x] == 0) missed.add(left + x, y, static_cast<double>(q[x]));
      }
    }
    sum.subtract(missed);
  }
};

/// Greatest label of three cells, and the least but 0: without a plane a cell is 0 in the one, 65535 in the
/// other.
struct Extremes {
  std::uint16_t greatest, least;
};

constexpr Extremes of_three(std::uint16_t a, std::uint16_t b, std::uint16_t c) noexcept {
  const std::uint16_t x = a > b ? a : b;
  const auto u = static_cast<std::uint16_t>(a - 1), v = static_cast<std::uint16_t>(b - 1);
  const auto w = static_cast<std::uint16_t>(c - 1);
  const std::uint16_t y = u < v ? u : v;
  return {x > c ? x : c, y < w ? y : w};
}

constexpr std::int32_t judged(const Extremes& left, const Extremes& here, const Extremes& right) noexcept {
  const std::int32_t two = left.greatest > here.greatest ? left.greatest : here.greatest;
  const std::int32_t greatest = two > right.greatest ? two : right.greatest;
  const std::int32_t least_of_two = left.least < here.least ? left.least : here.least;
  const std::int32_t least = least_of_two < right.least ? least_of_two : right.least;
  return greatest == 0 ? none : greatest - 1 == least ? greatest : border;
}

/// For a row of cells what their neighbourhoods are: `none`, the only plane, or `border`.
void look_around(Size size, std::span<const std::uint16_t> labels, std::int32_t y,
                 std::int32_t* around) noexcept {
  const std::int32_t last = size.width - 1;
  const std::uint16_t* here = labels.data() + static_cast<std::ptrdiff_t>(y) * size.width;
  const std::uint16_t* above = y > 0 ? here - size.width : here;
  const std::uint16_t* below = y + 1 < size.height ? here + size.width : here;
  const auto column = [=](std::int32_t x) noexcept { return of_three(above[x], here[x], below[x]); };
  Extremes left = column(0), middle = left;
  for (std::int32_t x = 0; x < last; ++x) {
    const Extremes right = column(x + 1);
    around[x] = judged(left, middle, right);
    left = middle;
    middle = right;
  }
  around[last] = judged(left, middle, middle);
}

/// Rows of cells that make squares of the coarser level `doublings` above.
struct Band {
  const Pixels& pixels;
  std::span<std::int32_t> around;  ///< of all cells
  int doublings;
  std::int32_t top, bottom;  ///< rows of cells

  std::int32_t cells_across() const noexcept { return pixels.work.cells.size(finest()).width; }
  int finest() const noexcept { return pixels.work.cells.finest(); }
  std::int32_t* row(std::int32_t y) const noexcept {
    return around.data() + static_cast<std::ptrdiff_t>(y) * cells_across();
  }
  /// The only plane of all cells of square X and around them, or 0.
  std::int32_t only_plane(std::int32_t X) const noexcept {
    const std::int32_t left = X << doublings, right = std::min(left + (1 << doublings), cells_across());
    const std::int32_t first = row(top)[left];
    for (std::int32_t y = top; y < bottom; ++y) {
      for (std::int32_t x = left; x < right; ++x) {
        if (row(y)[x] != first) return 0;
      }
    }
    return std::max(first, none);
  }
  /// Fills runs of squares.
  void fill_squares() const noexcept {
    const int level = finest() + doublings;
    const std::int32_t side = DepthCells::side_of(level), width = pixels.work.cells.size(level).width;
    const InverseDepthMoments* sums =
        pixels.work.cells.level(level).data() + static_cast<std::ptrdiff_t>(top >> doublings) * width;
    for (std::int32_t X = 0; X < width;) {
      const std::int32_t only = only_plane(X);
      InverseDepthMoments sum = sums[X];
      std::int32_t end = X + 1;
      if (only != 0 && sum.n > 0) {
        for (; end < width && end - X < longest_run && only_plane(end) == only; ++end) sum.add(sums[end]);
        pixels.fill(X * side, top * DepthCells::side_of(finest()), {(end - X) * side, side}, sum,
                    static_cast<std::uint16_t>(only));
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
    const InverseDepthMoments& cell = work.cells.level(finest())[place];
    const double u = cell.u / cell.n, v = cell.v / cell.n;
    const double noise = work.gate.inverse_noise(cell.q / cell.n), unit = cell.n * noise * noise;
    if (!(squared_residuals(cell, work.planes[own - 1U].tangent(u, v)) < fits_well * unit)) return false;
    const LabelsAround near(size, work.cell_labels, x, y);
    for (std::size_t k = 0; k < near.count; ++k) {
      if (near.labels[k] == own) continue;
      const InverseDepthPlane other = work.planes[near.labels[k] - 1U].tangent(u, v);
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
    const std::int32_t* of = row(y);
    const InverseDepthMoments* sums =
        pixels.work.cells.level(finest()).data() + static_cast<std::ptrdiff_t>(y) * width;
    for (std::int32_t x = 0; x < width;) {
      std::int32_t end = x + 1;
      if (of[x] == none || (of[x] != done && !(sums[x].n > 0))) {
        pixels.clear(x * side, y * side, side);
      } else if (of[x] == border) {
        choice.label_cell(x, y);
      } else if (of[x] != done) {
        InverseDepthMoments sum = sums[x];
        for (; end < width && end - x < longest_run && of[end] == of[x]; ++end) sum.add(sums[end]);
        pixels.fill(x * side, y * side, {(end - x) * side, side}, sum, static_cast<std::uint16_t>(of[x]));
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

void PixelLabeller::label(ImageView<std::uint16_t> labels, std::span<InverseDepthMoments> moments,
                          std::span<std::int32_t> scratch) const noexcept {
  for (InverseDepthMoments& m : moments) m = {};
  const Pixels pixels{*this, labels, moments};
  PixelChoice choice(*this, labels, moments);
  const Size size = cells.size(cells.finest());
  const int doublings = std::min(2, DepthCells::levels - 1 - cells.finest());
  for (std::int32_t top = 0; top < size.height; top += 1 << doublings) {
    const Band band{pixels, scratch, doublings, top, std::min(top + (1 << doublings), size.height)};
    for (std::int32_t y = top; y < band.bottom; ++y) look_around(size, cell_labels, y, band.row(y));
    band.fill_squares();
    for (std::int32_t y = top; y < band.bottom; ++y) {
      band.clear_borders(y);
      band.label_row(y, choice);
    }
  }
}

}  // namespace straightedge::detail
