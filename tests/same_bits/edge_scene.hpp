// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "inputs.hpp"
#include "memory.hpp"
#include "straightedge/canny.hpp"
#include "straightedge/edge_position.hpp"
#include "straightedge/gradient_view.hpp"

namespace same_bits {

/// The picture's edges with their gradients, for those who look for lines. Takes the front of the workspace;
/// `rest` is free.
struct EdgeScene {
  static constexpr straightedge::CannyOptions options{.sigma = 1.4, .low = 40, .high = 100};
  static constexpr std::ptrdiff_t stride = picture_size.width + 2;
  static constexpr std::size_t edge_bytes = std::size_t{stride} * picture_size.height;
  static constexpr std::size_t canny_bytes = straightedge::Canny::workspace_bytes(picture_size, options);
  static constexpr std::size_t bytes = edge_bytes + canny_bytes;

  /// `ok` unless Canny fails.
  straightedge::Status make() noexcept {
    using straightedge::Canny;
    const std::span<std::byte> memory = workspace();
    edges = {reinterpret_cast<std::uint8_t*>(memory.data()), picture_size, stride};
    rest = memory.subspan(bytes);
    const auto prepared =
        Canny::prepare(canny, picture_size, options, memory.subspan(edge_bytes, canny_bytes));
    return prepared == straightedge::Status::ok ? canny.run(picture(), edges).status : prepared;
  }
  straightedge::GradientView gradients() const noexcept { return {canny.gradient_x(), canny.gradient_y()}; }
  straightedge::GradientField field() const noexcept {
    return {canny.gradient_x(), canny.gradient_y(), canny.magnitude()};
  }

  straightedge::Canny canny;
  straightedge::ImageView<std::uint8_t> edges;
  std::span<std::byte> rest;
};

}  // namespace same_bits
