// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "straightedge/arena.hpp"
#include "straightedge/canny.hpp"
#include "straightedge/canny_row_kernels.hpp"
#include "straightedge/image.hpp"

namespace straightedge::detail {

/// The most pixels of the row forms: rows may be counted a little beyond the last, and a pointer can span
/// all rows that are kept.
inline constexpr std::uint64_t max_row_canny_pixels = std::min<std::uint64_t>(SIZE_MAX / 64, 1U << 30U);

/// Elements of a row with the room that kernels may use beyond its end.
constexpr std::size_t in_row_steps(std::size_t length) noexcept {
  return (length + canny_row_step - 1) / canny_row_step * canny_row_step;
}

/// A ring of rows: row y lies in slot y modulo the number of slots.
template <class T>
struct RowRing {
  std::span<T> elements;
  std::int32_t slots = 0;
  std::size_t stride = 0;  ///< elements from one slot to the next
  std::size_t margin = 0;  ///< elements on both sides of the row

  static constexpr RowRing take(Arena& arena, std::int32_t slots, std::int32_t width,
                                std::int32_t margin) noexcept {
    RowRing ring;
    ring.slots = slots;
    ring.margin = static_cast<std::size_t>(margin);
    ring.stride = in_row_steps(in_row_steps(static_cast<std::size_t>(width)) + 2 * ring.margin);
    ring.elements = arena.take<T>(ring.stride * static_cast<std::size_t>(slots));
    return ring;
  }

  T* row(std::int32_t y) const noexcept {
    return elements.data() + static_cast<std::size_t>(y % slots) * stride + margin;
  }
};

/// The rows that the recipe of canny_row_recipe.hpp works on.
struct CannyRowMemory {
  std::span<std::uint16_t> taps;
  std::span<const std::uint8_t*> sources;  ///< the rows that one sum over columns looks at
  RowRing<std::uint8_t> gray;              ///< none without a blur
  RowRing<std::uint16_t> sums;
  RowRing<std::uint8_t> blurred;
  std::span<std::int16_t> sobel_scratch;
  RowRing<std::int16_t> dx;
  RowRing<std::int16_t> dy;
  RowRing<std::uint16_t> magnitude_l1;  ///< one of the two
  RowRing<std::uint32_t> magnitude_l2;

  static constexpr CannyRowMemory take(Arena& arena, Size size, const CannyOptions& options) noexcept {
    const std::int32_t taps = gaussian_size(options.sigma);
    const std::int32_t margin = options.aperture / 2;
    const bool blurs = taps > 1;
    CannyRowMemory memory;
    memory.taps = arena.take<std::uint16_t>(static_cast<std::size_t>(taps));
    const auto most_sources = static_cast<std::size_t>(std::max<std::int32_t>(taps, options.aperture));
    memory.sources = arena.take<const std::uint8_t*>(most_sources);
    if (blurs) {
      memory.gray = RowRing<std::uint8_t>::take(arena, std::min(taps, size.height), size.width, 0);
      memory.sums = RowRing<std::uint16_t>::take(arena, 1, size.width, taps / 2);
    }
    memory.blurred = RowRing<std::uint8_t>::take(arena, options.aperture, size.width, margin);
    if (options.aperture > 3) {
      const std::size_t length = static_cast<std::size_t>(size.width) + static_cast<std::size_t>(2 * margin);
      memory.sobel_scratch = arena.take<std::int16_t>(2 * length);
    }
    memory.dx = RowRing<std::int16_t>::take(arena, 2, size.width, 0);
    memory.dy = RowRing<std::int16_t>::take(arena, 2, size.width, 0);
    if (options.norm == GradientNorm::l1) {
      memory.magnitude_l1 = RowRing<std::uint16_t>::take(arena, 3, size.width, 1);
    } else {
      memory.magnitude_l2 = RowRing<std::uint32_t>::take(arena, 3, size.width, 1);
    }
    return memory;
  }
};

}  // namespace straightedge::detail
