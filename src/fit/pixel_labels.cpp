// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "pixel_labels.hpp"

#include <algorithm>
#include <cstddef>

#include "base/lowest_bit.hpp"
#include "depth_surfaces.hpp"
#include "four_labels.hpp"
#include "label_squares.hpp"
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
// Several planes; DepthWholeCells::border, which is greater, says the same.
constexpr std::uint16_t inner_border = DepthWholeCells::inner_border;
// Beside that plane: all of the cell is its.
constexpr std::uint16_t whole = DepthWholeCells::mark;

constexpr std::uint16_t any_label = 0xFFFF;

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
  /// All pixels of a square.
  void give_all(std::int32_t left, std::int32_t top, std::int32_t side, std::uint16_t label) const noexcept {
    for (std::int32_t y = top; y < top + side; ++y) std::fill_n(labels.row(y) + left, side, label);
    count(side * side, label);
  }
};

constexpr InverseDepthMoments times(const InverseDepthMoments& m, double factor) noexcept {
  return {m.n * factor,  m.u * factor, m.v * factor,  m.uu * factor, m.uv * factor,
          m.vv * factor, m.q * factor, m.uq * factor, m.vq * factor, m.qq * factor};
}

/// A row of smallest cells, and what they are.
struct CellRow {
  const Pixels& pixels;
  const PixelLabeller& work;
  std::uint16_t* states;
  std::int32_t y;

  /// The one plane around each cell, if it is the only one; then those that are wholly a plane's are marked.
  void find_states() const noexcept {
    const std::int32_t width = size().width;
    const std::uint16_t* here = own();
    work.kernels.look_around(y > 0 ? here - width : here, here, y + 1 < size().height ? here + width : here,
                             width, states);
    DepthWholeCells task{work.cells.rows(finest(), first()), here, width};
    task.readings = static_cast<float>(side() * side());
    // As in PlaneGate::inverse_noise.
    const bool fixed = work.gate.fixed_m > 0;
    task.noise = fixed ? 0.0F : static_cast<float>(work.gate.inverse_sigma);
    task.noise_of_square =
        static_cast<float>(fixed ? work.gate.fixed_m / work.gate.sigmas : work.gate.floor_m);
    task.most = fits_well;
    work.kernels.mark_whole(task, work.surfaces, states);
  }
  /// Whole cells give all of their pixels their label, the others' get none.
  void spread() const noexcept {
    const std::int32_t top = y * side();
    const ImageView<std::uint16_t>& labels = pixels.labels;
    std::uint16_t* out = labels.row(top);
    work.kernels.spread_labels(states, side(), labels.width, out);
    for (std::int32_t j = top + 1; j < std::min(top + side(), labels.height); ++j) {
      std::copy(out, out + labels.width, labels.row(j));
    }
  }
  /// Counts the pixels of whole cells, and labels those of the others.
  void label_rest(PixelChoice& choice) const noexcept {
    const float* readings = work.cells.rows(finest(), first()).first;
    for (std::int32_t x = 0; x < size().width;) {
      const std::uint16_t state = states[x];
      std::int32_t end = x + 1;
      if (state >= inner_border) {
        label_border(x, choice);
      } else if (state != none && readings[x] > 0) {
        end = end_of_run(x);
        if (state >= whole) {
          pixels.count((end - x) * side() * side(), static_cast<std::uint16_t>(state & ~unsigned{whole}));
        } else {
          pixels.fill(x * side(), y * side(), {(end - x) * side(), side()}, state);
        }
      }
      x = end;
    }
  }

 private:
  int finest() const noexcept { return work.cells.finest(); }
  Size size() const noexcept { return work.cells.size(finest()); }
  std::int32_t side() const noexcept { return DepthCells::side_of(finest()); }
  std::size_t first() const noexcept {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size().width);
  }
  const std::uint16_t* own() const noexcept { return work.cell_labels.data() + first(); }
  /// Cells from x on are the same, as many as are filled at once.
  std::int32_t end_of_run(std::int32_t x) const noexcept {
    const std::uint16_t state = states[x];
    const std::int32_t most = std::min(size().width, x + longest_run / side());
    std::int32_t end = x + 1;
    for (; end + 4 <= most; end += 4) {
      const std::uint64_t differ = four(states + end) ^ (state * four_ones);
      if (differ != 0) return end + static_cast<std::int32_t>(lowest_bit(differ) / 16);
    }
    while (end < most && states[end] == state) ++end;
    return end;
  }

  void label_border(std::int32_t x, PixelChoice& choice) const noexcept {
    const LabelsAround near(size(), work.cell_labels, x, y);
    if (states[x] == inner_border && is_clear(x, near)) {
      pixels.give_all(x * side(), y * side(), side(), own()[x]);
    } else {
      choice.label_cell(x, y, near);
    }
  }
  /// Whether each of the others around does not fit at all, or lies on one side of the cell's own plane all
  /// over the cell.
  bool is_clear(std::int32_t x, const LabelsAround& near) const noexcept {
    const DepthSurface surface = surface_of(work.surfaces, own()[x] - 1U);
    for (std::size_t k = 0; k < near.count; ++k) {
      if (near.labels[k] == own()[x]) continue;
      const DepthSurface other = surface_of(work.surfaces, near.labels[k] - 1U);
      if (cross(surface, other, x) && !is_far(x, other)) return false;
    }
    return true;
  }
  bool is_far(std::int32_t x, const DepthSurface& surface) const noexcept {
    const DepthCell cell = work.cells.at(finest(), first() + static_cast<std::size_t>(x));
    const auto noise = static_cast<float>(work.gate.inverse_noise(static_cast<double>(cell.q)));
    return squared_residuals(cell, surface) > far_away * (cell.n * (noise * noise));
  }
  /// Whether two surfaces change sides within a cell, as its corners tell.
  bool cross(const DepthSurface& a, const DepthSurface& b, std::int32_t x) const noexcept {
    const auto across = static_cast<float>(side());
    const float left = static_cast<float>(x) * across - static_cast<float>(work.cells.middle_u()),
                top = static_cast<float>(y) * across - static_cast<float>(work.cells.middle_v());
    int nearer = 0;
    for (const float u : {left, left + (across - 1)}) {
      for (const float v : {top, top + (across - 1)}) nearer += value_at(a, u, v) > value_at(b, u, v) ? 1 : 0;
    }
    return (nearer != 0) & (nearer != 4);
  }
};

}  // namespace

void PixelLabeller::label(ImageView<std::uint16_t> labels, std::span<InverseDepthMoments> moments,
                          std::span<std::uint16_t> states) const noexcept {
  for (InverseDepthMoments& m : moments) m = {};
  const Pixels pixels{*this, labels, moments};
  PixelChoice choice(*this, labels, moments);
  fill_surfaces(planes, cells, surfaces);
  LabelSquares squares(cells, {cell_labels.data(), cells.size(cells.finest())}, any_label, false);
  squares.for_each([&](const LabelSquare& square) noexcept {
    moments[square.label - 1U].add(cells.moments(square.level, square.place));
  });
  // The means, while n counts pixels.
  for (InverseDepthMoments& m : moments) {
    if (m.n > 0) m = times(m, 1 / m.n);
    m.n = 0;
  }
  for (std::int32_t y = 0; y < cells.size(cells.finest()).height; ++y) {
    const CellRow row{pixels, *this, states.data(), y};
    row.find_states();
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
