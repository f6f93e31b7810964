// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/image.hpp"

namespace straightedge {

/// The gradient of an image, one pair of numbers a pixel: dx is right minus left, dy is below minus
/// above. Only its direction modulo pi is used where lines are sought. Two null views mean "none".
struct GradientView {
  ImageView<const std::int16_t> dx;
  ImageView<const std::int16_t> dy;

  constexpr bool given() const noexcept { return dx.data != nullptr || dy.data != nullptr; }
  constexpr bool valid() const noexcept { return dx.valid() && dy.valid(); }
};

}  // namespace straightedge
