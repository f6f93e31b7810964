// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "straightedge/arena.hpp"
#include "straightedge/gaussian.hpp"
#include "straightedge/hysteresis.hpp"
#include "straightedge/image.hpp"
#include "straightedge/sobel.hpp"

namespace straightedge::detail {

/// Everything that Canny keeps: 14 bytes a pixel and a few rows.
struct CannyWorkspace {
  std::span<std::uint16_t> taps;
  GaussianScratch gaussian_scratch;
  SobelScratch sobel_scratch;
  std::span<std::uint8_t> blurred;
  std::span<std::int16_t> dx;
  std::span<std::int16_t> dy;
  std::span<std::int32_t> magnitude;
  std::span<std::uint8_t> classes;
  std::span<std::uint32_t> stack;

  /// Counting and taking are this one text, so that they cannot differ.
  static constexpr CannyWorkspace take(Arena& arena, Size size, std::int32_t kernel_size,
                                       int aperture) noexcept {
    const std::size_t pixels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    CannyWorkspace memory;
    memory.taps = arena.take<std::uint16_t>(static_cast<std::size_t>(kernel_size));
    memory.gaussian_scratch = GaussianScratch::take(arena, size.width, kernel_size);
    memory.sobel_scratch = SobelScratch::take(arena, size.width, aperture);
    memory.blurred = arena.take<std::uint8_t>(pixels);
    memory.dx = arena.take<std::int16_t>(pixels);
    memory.dy = arena.take<std::int16_t>(pixels);
    memory.magnitude = arena.take<std::int32_t>(pixels);
    memory.classes = arena.take<std::uint8_t>(pixels);
    memory.stack = arena.take<std::uint32_t>(hysteresis_stack_size(size));
    return memory;
  }
};

/// The most pixels that the 32-bit counts hold, and whose workspace a pointer can span.
inline constexpr std::uint64_t max_canny_pixels =
    SIZE_MAX / 32 < INT32_MAX ? std::uint64_t{SIZE_MAX / 32} : std::uint64_t{INT32_MAX};

}  // namespace straightedge::detail
