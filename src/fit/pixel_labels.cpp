// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "pixel_labels.hpp"

#include <algorithm>
#include <array>

#include "labels_around.hpp"

namespace straightedge::detail {
namespace {

constexpr std::int32_t side = DepthCells::side;
// Planes of the cells that touch are tried (labels_around.hpp): beyond lies another surface's border.
constexpr std::int32_t reach = 1;
// Cells that are filled at once: so few that a bent plane is flat over them.
constexpr std::size_t longest_run = 16;
// The nearest plane is the one beyond doubt when the next is so many deviations further away.
constexpr double beyond_doubt = 4;
// Pixels whose 1/z differs by more deviations than this are not of one surface.
constexpr double same_surface = 8;

struct Mean {
  double u = 0, v = 0, q = 0;
};

/// The mean of the 3x3 pixels around one that lie on its surface.
Mean mean_of_surface(ImageView<const float> inverse_depth, std::int32_t x, std::int32_t y,
                     double limit) noexcept {
  const auto centre = static_cast<double>(inverse_depth.at(x, y));
  double n = 0;
  Mean sum;
  for (std::int32_t j = std::max<std::int32_t>(y - 1, 0); j <= std::min(y + 1, inverse_depth.height - 1); ++j) {
    for (std::int32_t i = std::max<std::int32_t>(x - 1, 0); i <= std::min(x + 1, inverse_depth.width - 1); ++i) {
      const auto q = static_cast<double>(inverse_depth.at(i, j));
      if (!(q > 0) || q - centre > limit || centre - q > limit) continue;
      n += 1;
      sum.u += i;
      sum.v += j;
      sum.q += q;
    }
  }
  return {sum.u / n, sum.v / n, sum.q / n};
}

struct Nearest {
  std::uint16_t label = 0;
  double distance = 1e300, next = 1e300;
};

/// Planes in the order of `around`, flat over the cell.
Nearest nearest(const Mean& at, const LabelsAround& around,
                std::span<const InverseDepthPlane> planes) noexcept {
  Nearest best;
  for (std::size_t k = 0; k < around.count; ++k) {
    const double r = at.q - planes[k].at(at.u, at.v);
    const double distance = r < 0 ? -r : r;
    if (distance < best.distance) {
      best = {around.labels[k], distance, best.distance};
    } else if (distance < best.next) {
      best.next = distance;
    }
  }
  return best;
}

/// Labels the readings of a row that lie within the gate of first + slope x; returns how many.
std::int32_t label_row(const float* q, std::int32_t width, float first, float slope, float limit,
                       std::uint16_t label, std::uint16_t* out) noexcept {
  std::int32_t count = 0;
  for (std::int32_t x = 0; x < width; ++x) {
    const float r = q[x] - (first + slope * static_cast<float>(x));
    const bool fits = (r < limit) & (r > -limit) & (q[x] > 0);
    out[x] = fits ? label : std::uint16_t{0};
    count += fits ? 1 : 0;
  }
  return count;
}

struct Pixels {
  ImageView<const float> inverse_depth;
  std::span<const BentPlane> planes;
  const PlaneGate& gate;
  ImageView<std::uint16_t> labels;

  std::uint16_t label(std::int32_t x, std::int32_t y, const LabelsAround& around,
                      std::span<const InverseDepthPlane> flat) const noexcept {
    const auto q = static_cast<double>(inverse_depth.at(x, y));
    if (!(q > 0)) return 0;
    const double noise = gate.inverse_noise(q);
    Nearest found = nearest({static_cast<double>(x), static_cast<double>(y), q}, around, flat);
    if (found.next - found.distance < beyond_doubt * noise) {
      found = nearest(mean_of_surface(inverse_depth, x, y, same_surface * noise), around, flat);
    }
    return found.distance < gate.sigmas * noise ? found.label : std::uint16_t{0};
  }
  /// Every pixel the nearest of the planes around the cell.
  void choose(std::int32_t left, std::int32_t top, const LabelsAround& around,
              std::span<InverseDepthMoments> moments) const noexcept {
    std::array<InverseDepthPlane, 9> flat;
    for (std::size_t k = 0; k < around.count; ++k) {
      flat[k] = planes[around.labels[k] - 1U].tangent(left + side / 2, top + side / 2);
    }
    for (std::int32_t y = top; y < std::min(top + side, labels.height); ++y) {
      for (std::int32_t x = left; x < std::min(left + side, labels.width); ++x) {
        const std::uint16_t found = label(x, y, around, flat);
        labels.at(x, y) = found;
        if (found != 0) moments[found - 1U].add(x, y, static_cast<double>(inverse_depth.at(x, y)));
      }
    }
  }
  /// Cells in a row with one and the same plane around: every pixel within the gate is its. It is taken for
  /// flat inside of the run.
  void fill(std::int32_t left, std::int32_t top, std::span<const InverseDepthMoments> run, std::uint16_t only,
            std::span<InverseDepthMoments> moments) const noexcept {
    InverseDepthMoments sum;
    for (const InverseDepthMoments& cell : run) sum.add(cell);
    const InverseDepthPlane plane = planes[only - 1U].tangent(sum.u / sum.n, sum.v / sum.n);
    const auto limit = static_cast<float>(gate.sigmas * gate.inverse_noise(sum.q / sum.n));
    const std::int32_t width = std::min(side * static_cast<std::int32_t>(run.size()), labels.width - left);
    const std::int32_t bottom = std::min(top + side, labels.height);
    std::int32_t count = 0;
    for (std::int32_t y = top; y < bottom; ++y) {
      count += label_row(inverse_depth.row(y) + left, width, static_cast<float>(plane.at(left, y)),
                         static_cast<float>(plane.a), limit, only, labels.row(y) + left);
    }
    if (count == static_cast<std::int32_t>(sum.n)) {
      moments[only - 1U].add(sum);
    } else {
      add_labelled({left, top, left + width, bottom}, only, moments);
    }
  }
  void clear(std::int32_t left, std::int32_t top) const noexcept {
    for (std::int32_t y = top; y < std::min(top + side, labels.height); ++y) {
      std::fill(labels.row(y) + left, labels.row(y) + std::min(left + side, labels.width), std::uint16_t{0});
    }
  }

 private:
  struct Box {
    std::int32_t left, top, right, bottom;
  };
  void add_labelled(const Box& box, std::uint16_t only,
                    std::span<InverseDepthMoments> moments) const noexcept {
    for (std::int32_t y = box.top; y < box.bottom; ++y) {
      for (std::int32_t x = box.left; x < box.right; ++x) {
        if (labels.at(x, y) != only) continue;
        moments[only - 1U].add(x, y, static_cast<double>(inverse_depth.at(x, y)));
      }
    }
  }
};

/// Least and greatest label but 0 of some cells.
struct Range {
  std::uint16_t least = 0xFFFF, greatest = 0;

  void add(const Range& other) noexcept {
    least = std::min(least, other.least);
    greatest = std::max(greatest, other.greatest);
  }
};

constexpr std::int32_t pack(const Range& r) noexcept {
  return static_cast<std::int32_t>(std::uint32_t{r.greatest} << 16U | r.least);
}
constexpr Range unpack(std::int32_t packed) noexcept {
  const auto bits = static_cast<std::uint32_t>(packed);
  return {static_cast<std::uint16_t>(bits), static_cast<std::uint16_t>(bits >> 16U)};
}

/// For every cell the range over itself and `reach` cells to both sides in its row.
void range_rows(Size size, std::span<const std::uint16_t> labels, std::span<std::int32_t> ranges) noexcept {
  for (std::int32_t y = 0; y < size.height; ++y) {
    const std::ptrdiff_t start = static_cast<std::ptrdiff_t>(y) * size.width;
    const std::uint16_t* row = labels.data() + start;
    for (std::int32_t x = 0; x < size.width; ++x) {
      Range range;
      for (std::int32_t i = std::max<std::int32_t>(x - reach, 0); i <= std::min(x + reach, size.width - 1); ++i) {
        range.add({row[i] == 0 ? std::uint16_t{0xFFFF} : row[i], row[i]});
      }
      ranges[static_cast<std::size_t>(start + x)] = pack(range);
    }
  }
}

/// The ranges of a row of cells over `reach` rows to both sides.
void range_column(Size size, std::int32_t y, std::span<const std::int32_t> rows,
                  std::span<std::int32_t> ranges) noexcept {
  const auto width = static_cast<std::size_t>(size.width);
  const std::int32_t top = std::max<std::int32_t>(y - reach, 0), bottom = std::min(y + reach, size.height - 1);
  for (std::size_t x = 0; x < width; ++x) {
    Range range;
    for (std::int32_t j = top; j <= bottom; ++j) {
      range.add(unpack(rows[static_cast<std::size_t>(j) * width + x]));
    }
    ranges[x] = pack(range);
  }
}

}  // namespace

void label_pixels(ImageView<const float> inverse_depth, const DepthCells& cells,
                  std::span<const std::uint16_t> cell_labels, std::span<const BentPlane> planes,
                  const PlaneGate& gate, ImageView<std::uint16_t> labels,
                  std::span<InverseDepthMoments> moments, std::span<std::int32_t> scratch) noexcept {
  for (InverseDepthMoments& m : moments) m = {};
  const Pixels pixels{inverse_depth, planes, gate, labels};
  const Size size = cells.size(0);
  range_rows(size, cell_labels, scratch);
  const std::span<std::int32_t> ranges = scratch.subspan(cell_labels.size());
  const auto width = static_cast<std::size_t>(size.width);
  for (std::int32_t y = 0; y < size.height; ++y) {
    range_column(size, y, scratch, ranges);
    const auto row = cells.level(0).subspan(static_cast<std::size_t>(y) * width, width);
    for (std::size_t x = 0; x < width;) {
      const auto left = static_cast<std::int32_t>(x) * side;
      const Range range = unpack(ranges[x]);
      if (range.greatest == 0 || !(row[x].n > 0)) {
        pixels.clear(left, y * side);
        ++x;
      } else if (range.least != range.greatest) {
        pixels.choose(left, y * side, LabelsAround(size, cell_labels, static_cast<std::int32_t>(x), y),
                      moments);
        ++x;
      } else {
        std::size_t end = x + 1;
        while (end < width && end - x < longest_run && ranges[end] == ranges[x] && row[end].n > 0) ++end;
        pixels.fill(left, y * side, row.subspan(x, end - x), range.least, moments);
        x = end;
      }
    }
  }
}

}  // namespace straightedge::detail
