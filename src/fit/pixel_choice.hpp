// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "labels_around.hpp"
#include "pixel_labels.hpp"

namespace straightedge::detail {

template <class T>
std::ptrdiff_t elements_apart(const ImageView<T>& view) noexcept {
  return view.stride / static_cast<std::ptrdiff_t>(sizeof(T));
}

/// Step 7 of frame_planes.hpp where several planes meet: every pixel takes the nearest of those around its
/// cell.
class PixelChoice {
 public:
  PixelChoice(const PixelLabeller& work, ImageView<std::uint16_t> labels,
              std::span<InverseDepthMoments> moments) noexcept;

  /// Labels the pixels of smallest cell (x, y), and counts them in their planes' sums.
  void label_cell(std::int32_t x, std::int32_t y, const LabelsAround& around) noexcept;

 private:
  static constexpr std::int32_t side = DepthChoice::side, side_around = side + 2;

  /// The square's pixels with those around it.
  DepthRows look(std::int32_t left, std::int32_t top) noexcept;
  void label_square(std::int32_t left, std::int32_t top) noexcept;
  void write(std::int32_t left, std::int32_t top, const std::uint16_t* chosen) const noexcept;

  const PixelLabeller& work_;
  ImageView<std::uint16_t> labels_;
  std::span<InverseDepthMoments> moments_;
  DepthChoice choice_;
  std::array<InverseDepthPlane, DepthChoice::most_planes> flat_;
  std::array<float, std::size_t{side_around} * side_around> at_border_;
};

}  // namespace straightedge::detail
