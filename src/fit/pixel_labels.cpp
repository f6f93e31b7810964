// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "pixel_labels.hpp"

#include <algorithm>
#include <array>

namespace straightedge::detail {
namespace {

constexpr std::int32_t side = DepthCells::side;
// Planes of cells up to two cells away are tried: beyond lies another surface's border.
constexpr std::int32_t reach = 2;
// Pixels whose 1/z differs by more deviations than this are not of one surface.
constexpr double same_surface = 8;

/// The different planes of the cells around one, itself first.
struct Around {
  std::array<std::uint16_t, (2 * reach + 1) * (2 * reach + 1)> labels{};
  std::size_t count = 0;

  Around(std::span<const std::uint16_t> cell_labels, Size size, std::int32_t x, std::int32_t y) noexcept {
    for (std::int32_t j = std::max(y - reach, 0); j <= std::min(y + reach, size.height - 1); ++j) {
      const std::uint16_t* row =
          cell_labels.data() + static_cast<std::ptrdiff_t>(j) * static_cast<std::ptrdiff_t>(size.width);
      std::uint16_t last = 0;
      for (std::int32_t i = std::max(x - reach, 0); i <= std::min(x + reach, size.width - 1); ++i) {
        if (row[i] == last || row[i] == 0) continue;
        last = row[i];
        const auto end = labels.begin() + static_cast<std::ptrdiff_t>(count);
        if (std::find(labels.begin(), end, last) == end) labels[count++] = last;
      }
    }
  }
};

struct Mean {
  double u = 0, v = 0, q = 0;
};

/// The mean of the 3x3 pixels around one that lie on its surface.
Mean mean_of_surface(ImageView<const float> inverse_depth, std::int32_t x, std::int32_t y,
                     double limit) noexcept {
  const auto centre = static_cast<double>(inverse_depth.at(x, y));
  double n = 0;
  Mean sum;
  for (std::int32_t j = std::max(y - 1, 0); j <= std::min(y + 1, inverse_depth.height - 1); ++j) {
    for (std::int32_t i = std::max(x - 1, 0); i <= std::min(x + 1, inverse_depth.width - 1); ++i) {
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

std::uint16_t nearest(const Mean& mean, const Around& around, std::span<const BentPlane> planes,
                      double gate) noexcept {
  std::uint16_t best = 0;
  double least = gate;
  for (std::size_t k = 0; k < around.count; ++k) {
    const double r = mean.q - planes[around.labels[k] - 1U].at(mean.u, mean.v);
    const double distance = r < 0 ? -r : r;
    if (distance < least) {
      least = distance;
      best = around.labels[k];
    }
  }
  return best;
}

struct Pixels {
  ImageView<const float> inverse_depth;
  std::span<const BentPlane> planes;
  const PlaneGate& gate;
  ImageView<std::uint16_t> labels;

  std::uint16_t label(std::int32_t x, std::int32_t y, const Around& around) const noexcept {
    const auto q = static_cast<double>(inverse_depth.at(x, y));
    if (!(q > 0)) return 0;
    const double noise = gate.inverse_noise(q);
    const Mean mean = around.count == 1 ? Mean{static_cast<double>(x), static_cast<double>(y), q}
                                        : mean_of_surface(inverse_depth, x, y, same_surface * noise);
    return nearest(mean, around, planes, gate.sigmas * noise);
  }
  /// Returns the label that all readings of the cell got, or 0.
  std::uint16_t cell(std::int32_t left, std::int32_t top, const Around& around) const noexcept {
    const std::uint16_t first = around.count > 0 ? around.labels[0] : std::uint16_t{0};
    bool all = first != 0;
    for (std::int32_t y = top; y < std::min(top + side, labels.height); ++y) {
      for (std::int32_t x = left; x < std::min(left + side, labels.width); ++x) {
        const std::uint16_t found = around.count > 0 ? label(x, y, around) : std::uint16_t{0};
        labels.at(x, y) = found;
        all = all && (found == first || !(inverse_depth.at(x, y) > 0));
      }
    }
    return all ? first : std::uint16_t{0};
  }
  void add_cell(std::int32_t left, std::int32_t top, std::span<InverseDepthMoments> moments) const noexcept {
    for (std::int32_t y = top; y < std::min(top + side, labels.height); ++y) {
      for (std::int32_t x = left; x < std::min(left + side, labels.width); ++x) {
        const std::uint16_t found = labels.at(x, y);
        if (found != 0) moments[found - 1U].add(x, y, static_cast<double>(inverse_depth.at(x, y)));
      }
    }
  }
};

}  // namespace

void label_pixels(ImageView<const float> inverse_depth, const DepthCells& cells,
                  std::span<const std::uint16_t> cell_labels, std::span<const BentPlane> planes,
                  const PlaneGate& gate, ImageView<std::uint16_t> labels,
                  std::span<InverseDepthMoments> moments) noexcept {
  for (InverseDepthMoments& m : moments) m = {};
  const Pixels pixels{inverse_depth, planes, gate, labels};
  const Size size = cells.size(0);
  const InverseDepthMoments* cell = cells.level(0).data();
  for (std::int32_t y = 0; y < size.height; ++y) {
    for (std::int32_t x = 0; x < size.width; ++x, ++cell) {
      const Around around(cell_labels, size, x, y);
      const std::uint16_t whole = pixels.cell(x * side, y * side, around);
      if (whole != 0) {
        moments[whole - 1U].add(*cell);
      } else if (around.count > 0) {
        pixels.add_cell(x * side, y * side, moments);
      }
    }
  }
}

}  // namespace straightedge::detail
