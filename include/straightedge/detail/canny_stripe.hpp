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
#include "straightedge/detail/canny_row_memory.hpp"
#include "straightedge/detail/canny_row_recipe.hpp"
#include "straightedge/image.hpp"

namespace straightedge::detail {

/// Some rows of a picture, and what is needed to find their edges without a look at the others' work: a
/// recipe that begins some rows above them and ends some rows below, as a picture of its own. In lines of the
/// cache of its own too: threads write into theirs with each row.
struct alignas(Arena::alignment) CannyStripe {
  std::int32_t first_read = 0, end_read = 0;  ///< rows that the recipe is given
  std::int32_t begin = 0, end = 0;            ///< rows whose classes count
  CannyRowRecipe recipe;
  CannyRowMemory rows;
  std::span<std::uint32_t> worklist;
  std::span<std::uint8_t> class_row;  ///< whole words of 64 pixels
  std::uint32_t strong = 0, edges = 0;

  /// Not more stripes than rows.
  static constexpr std::int32_t count(Size size, const CannyRowOptions& rows) noexcept {
    return std::min(rows.stripes, size.height);
  }

  static constexpr CannyStripe take(Arena& arena, Size size, const CannyOptions& options,
                                    const CannyRowOptions& rows, std::int32_t index) noexcept {
    const std::int64_t height = size.height, stripes = count(size, rows);
    // What a row's class depends on: the magnitudes beside it, their gradients, and the blur below those.
    const std::int32_t reach = 1 + options.aperture / 2 + gaussian_size(options.sigma) / 2;
    CannyStripe stripe;
    stripe.begin = static_cast<std::int32_t>(height * index / stripes);
    stripe.end = static_cast<std::int32_t>(height * (index + 1) / stripes);
    stripe.first_read = std::max<std::int32_t>(stripe.begin - reach, 0);
    stripe.end_read = std::min<std::int32_t>(stripe.end + reach, size.height);
    const Size own{size.width, stripe.end_read - stripe.first_read};
    const std::size_t pixels = static_cast<std::size_t>(own.width) * static_cast<std::size_t>(own.height);
    stripe.rows = CannyRowMemory::take(arena, own, options);
    stripe.worklist = arena.take<std::uint32_t>(std::min<std::size_t>(rows.worklist, pixels));
    stripe.class_row = arena.take<std::uint8_t>((static_cast<std::size_t>(own.width) + 63) / 64 * 64);
    return stripe;
  }
};

}  // namespace straightedge::detail
