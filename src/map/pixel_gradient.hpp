// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "straightedge/edge_position.hpp"
#include "straightedge/image.hpp"

namespace straightedge {

/// Right minus left, below minus above.
struct PixelGradient {
  std::int32_t dx = 0, dy = 0;
};

/// Gradients that were kept. The rows of both are equally far apart.
class StoredGradients {
 public:
  explicit StoredGradients(const GradientField& field)
      : dx_(field.x.data),
        dy_(field.y.data),
        row_(field.x.stride / static_cast<std::ptrdiff_t>(sizeof(std::int16_t))) {}

  std::ptrdiff_t row() const noexcept { return row_; }
  /// Places count pixels from the first one, `row` to the next row.
  PixelGradient at(std::ptrdiff_t place) const noexcept { return {dx_[place], dy_[place]}; }
  void fetch(std::ptrdiff_t place) const noexcept {
    __builtin_prefetch(dx_ + place);
    __builtin_prefetch(dy_ + place);
  }

 private:
  const std::int16_t *dx_, *dy_;
  std::ptrdiff_t row_;
};

/// The same made anew where they are asked for, by Sobel's operator of side 3 (sobel.hpp): more work for a
/// pixel, but most pixels are never asked for, and four times less memory is read and written.
class MadeGradients {
 public:
  /// The picture has a rim of one pixel around it.
  explicit MadeGradients(GrayView blurred) : pixels_(blurred.data), row_(blurred.stride) {}

  std::ptrdiff_t row() const noexcept { return row_; }
  PixelGradient at(std::ptrdiff_t place) const noexcept {
    const std::uint8_t *here = pixels_ + place, *above = here - row_, *below = here + row_;
    const std::int32_t falling = below[1] - above[-1], rising = above[1] - below[-1];
    return {falling + rising + 2 * (here[1] - here[-1]), falling - rising + 2 * (below[0] - above[0])};
  }
  void fetch(std::ptrdiff_t place) const noexcept { __builtin_prefetch(pixels_ + place); }

 private:
  const std::uint8_t* pixels_;
  std::ptrdiff_t row_;
};

/// Where the gradients of a picture come from.
struct GradientSource {
  GradientField stored;
  GrayView blurred;  ///< with a rim; none where they are stored

  GradientSource() = default;
  GradientSource(const GradientField& field) : stored(field) {}
  explicit GradientSource(GrayView with_rim) : blurred(with_rim) {}

  bool is_stored() const noexcept { return blurred.data == nullptr; }
  Size size() const noexcept { return is_stored() ? stored.x.size() : blurred.size(); }
  PixelGradient at(std::int32_t x, std::int32_t y) const noexcept {
    if (is_stored()) return {stored.x.at(x, y), stored.y.at(x, y)};
    return MadeGradients(blurred).at(y * blurred.stride + x);
  }
};

}  // namespace straightedge
