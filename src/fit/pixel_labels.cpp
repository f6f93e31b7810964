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

namespace straightedge::detail {
namespace {

// Pixels of a row that are filled at once: so few that a bent plane is flat over them.
constexpr std::int32_t longest_run = 128;

// A cell's mean squared residual, in variances of the noise.
constexpr float fits_well = 1.5F;
constexpr float far_away = 25;

// What a cell is, in place of the one plane that it and all cells around have.
constexpr std::uint16_t none = 0;  // no plane anywhere around
constexpr std::uint16_t border = DepthWholeCells::border;
// Beside that plane: all of the cell is its.
constexpr std::uint16_t whole = DepthWholeCells::mark;

constexpr bool is_whole(std::uint16_t state) noexcept {
  return (state & whole) != 0 && state != border;
}

struct Pixels {
  const PixelLabeller& work;
  ImageView<std::uint16_t> labels;
  std::span<InverseDepthMoments> moments;

  void count(std::int32_t pixels, std::uint16_t label) const noexcept { moments[label - 1U].n += pixels; }
  /// Pixels with one and the same plane around: each within the gate is its. The plane is taken for flat.
  void fill(std::int32_t left, std::int32_t top, Size size, std::uint16_t only) const noexcept {
    const double u = left + size.width / 2.0, v = top + size.height / 2.0;
    const InverseDepthPlane plane = work.planes[only - 1U].tangent(u, v);
    const double limit = work.gate.sigmas * work.gate.inverse_noise(plane.at(u, v));
    const ImageView<const float>& q = work.inverse_depth;
    const DepthBlock block{{q.row(top) + left, elements_apart(q)},
                           std::min(size.width, labels.width - left),
                           std::min(size.height, labels.height - top),
                           plane.at(left, top),
                           plane.a,
                           plane.b,
                           static_cast<float>(limit),
                           only};
    count(work.kernels.label_block(block, labels.row(top) + left, elements_apart(labels)), only);
  }
};

/// What the smallest cells are, row by row.
struct States {
  const PixelLabeller& work;
  std::span<std::uint16_t> all;

  int finest() const noexcept { return work.cells.finest(); }
  Size size() const noexcept { return work.cells.size(finest()); }
  std::uint16_t* row(std::int32_t y) const noexcept {
    return all.data() + static_cast<std::ptrdiff_t>(y) * size().width;
  }
  /// The one plane around each cell, if it is the only one.
  void look_around(std::int32_t y) const noexcept {
    const std::uint16_t* here = work.cell_labels.data() + (row(y) - all.data());
    work.kernels.look_around(y > 0 ? here - size().width : here, here,
                             y + 1 < size().height ? here + size().width : here, size().width, row(y));
  }
  /// Border cells that are clear take their plane; then cells that are whole are marked.
  void settle(std::int32_t y) const noexcept {
    const std::ptrdiff_t first = row(y) - all.data();
    for (std::int32_t x = 0; x < size().width; ++x) {
      if (row(y)[x] == border && is_clear(x, y))
        row(y)[x] = work.cell_labels[static_cast<std::size_t>(first + x)];
    }
    DepthWholeCells task{work.cells.rows(finest(), static_cast<std::size_t>(first)), size().width};
    const std::int32_t side = DepthCells::side_of(finest());
    task.readings = static_cast<float>(side * side);
    // As in PlaneGate::inverse_noise.
    const bool fixed = work.gate.fixed_m > 0;
    task.noise = fixed ? 0.0F : static_cast<float>(work.gate.inverse_sigma);
    task.noise_of_square =
        static_cast<float>(fixed ? work.gate.fixed_m / work.gate.sigmas : work.gate.floor_m);
    task.most = fits_well;
    work.kernels.mark_whole(task, work.surfaces, row(y));
  }

 private:
  /// Whether the cell is its own plane's, without a doubt: it fits well, and each of the others around does
  /// not at all, or lies on one side of its own all over the cell.
  bool is_clear(std::int32_t x, std::int32_t y) const noexcept {
    const auto place =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(size().width) + static_cast<std::size_t>(x);
    const std::uint16_t own = work.cell_labels[place];
    if (own == 0) return false;
    const DepthCell cell = work.cells.at(finest(), place);
    const auto noise = static_cast<float>(work.gate.inverse_noise(static_cast<double>(cell.q)));
    const float unit = cell.n * (noise * noise);
    const DepthSurface surface = surface_of(work.surfaces, own - 1U);
    if (!(squared_residuals(cell, surface) < fits_well * unit)) return false;
    const LabelsAround near(size(), work.cell_labels, x, y);
    for (std::size_t k = 0; k < near.count; ++k) {
      if (near.labels[k] == own) continue;
      const DepthSurface other = surface_of(work.surfaces, near.labels[k] - 1U);
      if (!(squared_residuals(cell, other) > far_away * unit) && cross(surface, other, x, y)) return false;
    }
    return true;
  }
  /// Whether two surfaces change sides within a cell, as its corners tell.
  bool cross(const DepthSurface& a, const DepthSurface& b, std::int32_t x, std::int32_t y) const noexcept {
    const auto side = static_cast<float>(DepthCells::side_of(finest()));
    const float left = static_cast<float>(x) * side - static_cast<float>(work.cells.middle_u()),
                top = static_cast<float>(y) * side - static_cast<float>(work.cells.middle_v());
    int nearer = 0;
    for (const float u : {left, left + (side - 1)}) {
      for (const float v : {top, top + (side - 1)}) nearer += value_at(a, u, v) > value_at(b, u, v) ? 1 : 0;
    }
    return nearer != 0 && nearer != 4;
  }
};

/// Sums of the planes' own cells, in squares as large as they come.
struct CellMoments {
  const PixelLabeller& work;
  std::span<InverseDepthMoments> moments;

  /// Adds square (x, y) of `doublings` levels above the finest if all of it has one label.
  bool add(std::int32_t x, std::int32_t y, int doublings) const noexcept {
    const int level = work.cells.finest() + doublings;
    const Size size = work.cells.size(work.cells.finest()), squares = work.cells.size(level);
    const std::int32_t left = x << doublings, right = std::min((x + 1) << doublings, size.width),
                       top = y << doublings, bottom = std::min((y + 1) << doublings, size.height);
    const std::uint16_t* row = work.cell_labels.data() + static_cast<std::ptrdiff_t>(top) * size.width + left;
    const std::uint16_t first = *row;
    std::uint64_t differ = 0;
    for (std::int32_t j = top; j < bottom; ++j, row += size.width) {
      if (right - left == 4) {
        differ |= four(row) ^ (first * four_ones);
        continue;
      }
      for (std::int32_t i = 0; i < right - left; ++i) differ |= row[i] ^ first;
    }
    if (differ != 0) return false;
    if (first != 0) {
      const auto place =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(squares.width) + static_cast<std::size_t>(x);
      moments[first - 1U].add(work.cells.moments(level, place));
    }
    return true;
  }
  void add_all() const noexcept {
    const int most = std::min(2, DepthCells::levels - 1 - work.cells.finest());
    const Size size = work.cells.size(work.cells.finest() + most);
    for (std::int32_t y = 0; y < size.height; ++y) {
      for (std::int32_t x = 0; x < size.width; ++x) {
        if (!add(x, y, most)) add_parts(x, y, most - 1);
      }
    }
  }
  void add_parts(std::int32_t X, std::int32_t Y, int doublings) const noexcept {
    const Size size = work.cells.size(work.cells.finest() + doublings),
               smallest = work.cells.size(work.cells.finest());
    for (std::int32_t y = 2 * Y; y < std::min(2 * Y + 2, size.height); ++y) {
      for (std::int32_t x = 2 * X; x < std::min(2 * X + 2, size.width); ++x) {
        if (add(x, y, doublings) || doublings == 0) continue;
        for (std::int32_t j = 2 * y; j < std::min(2 * y + 2, smallest.height); ++j) {
          for (std::int32_t i = 2 * x; i < std::min(2 * x + 2, smallest.width); ++i) add(i, j, 0);
        }
      }
    }
  }
};

constexpr InverseDepthMoments times(const InverseDepthMoments& m, double factor) noexcept {
  return {m.n * factor,  m.u * factor, m.v * factor,  m.uu * factor, m.uv * factor,
          m.vv * factor, m.q * factor, m.uq * factor, m.vq * factor, m.qq * factor};
}

/// A row of smallest cells.
struct CellRow {
  const Pixels& pixels;
  const States& states;
  std::int32_t y;

  /// Whole cells give all of their pixels their label, the others' get none.
  void spread() const noexcept {
    const std::int32_t side = DepthCells::side_of(states.finest()), top = y * side;
    const ImageView<std::uint16_t>& labels = pixels.labels;
    std::uint16_t* out = labels.row(top);
    pixels.work.kernels.spread_labels(states.row(y), side, labels.width, out);
    for (std::int32_t j = top + 1; j < std::min(top + side, labels.height); ++j) {
      std::copy(out, out + labels.width, labels.row(j));
    }
  }
  /// Counts the pixels of whole cells, and labels those of the others.
  void label_rest(PixelChoice& choice) const noexcept {
    const DepthCells& cells = pixels.work.cells;
    const std::int32_t side = DepthCells::side_of(states.finest()), width = states.size().width;
    const std::uint16_t* of = states.row(y);
    const auto first = static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
    const float* readings = cells.rows(states.finest(), first).first;
    for (std::int32_t x = 0; x < width;) {
      std::int32_t end = x + 1;
      if (of[x] == border) {
        choice.label_cell(x, y);
      } else if (of[x] != none && readings[x] > 0) {
        while (end < width && (end - x) * side < longest_run && of[end] == of[x]) ++end;
        if (is_whole(of[x])) {
          pixels.count((end - x) * side * side, static_cast<std::uint16_t>(of[x] & ~unsigned{whole}));
        } else {
          pixels.fill(x * side, y * side, {(end - x) * side, side}, of[x]);
        }
      }
      x = end;
    }
  }
};

}  // namespace

void PixelLabeller::label(ImageView<std::uint16_t> labels, std::span<InverseDepthMoments> moments,
                          std::span<std::uint16_t> scratch) const noexcept {
  for (InverseDepthMoments& m : moments) m = {};
  const Pixels pixels{*this, labels, moments};
  const States states{*this, scratch};
  PixelChoice choice(*this, labels, moments);
  fill_surfaces(planes, cells, surfaces);
  const std::int32_t height = states.size().height;
  for (std::int32_t y = 0; y < height; ++y) states.look_around(y);
  for (std::int32_t y = 0; y < height; ++y) states.settle(y);
  CellMoments{*this, moments}.add_all();
  // The means, while n counts pixels.
  for (InverseDepthMoments& m : moments) {
    if (m.n > 0) m = times(m, 1 / m.n);
    m.n = 0;
  }
  for (std::int32_t y = 0; y < height; ++y) {
    const CellRow row{pixels, states, y};
    row.spread();
    row.label_rest(choice);
  }
  for (InverseDepthMoments& m : moments) {
    const double counted = m.n;
    m = times(m, counted);
    m.n = counted;
  }
}

}  // namespace straightedge::detail
