// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "hough/angle_table.hpp"
#include "straightedge/hough_job.hpp"
#include "straightedge/hough_kernels.hpp"

namespace straightedge::hough {

/// The distance cells that the pixels of a picture can have at one angle.
struct Reach {
  std::int32_t first = 0;
  std::int32_t last = 0;
};

/// Rounding never turns an order round, so that two of the corners have the extremes, computed as
/// distance_cell computes them.
inline Reach reach(Size picture, float cosine, float sine) noexcept {
  const float right = static_cast<float>(picture.width - 1) * cosine;
  const float bottom = static_cast<float>(picture.height - 1) * sine;
  const float low = (right < 0 ? right : 0.0F) + (bottom < 0 ? bottom : 0.0F);
  const float high = (right > 0 ? right : 0.0F) + (bottom > 0 ? bottom : 0.0F);
  return {round_even(low), round_even(high)};
}

/// The number of a cell, by its row's offset and its distance from the middle.
inline std::size_t cell_index(std::uint32_t offset, std::int32_t distance) noexcept {
  return offset + rounding_bits + static_cast<std::uint32_t>(distance);
}

/// The same for the pixel (x, y), without taking the integer out of the float.
inline std::size_t cell_index(const HoughMemory& memory, std::size_t n, float x, float y) noexcept {
  const float sum = x * memory.cosines[n] + y * memory.sines[n] + rounding_float;
  return memory.offsets[n] + std::bit_cast<std::uint32_t>(sum);
}

/// Puts the rows one behind the other, and the first rows of the tables again behind the last. Cosines and
/// sines must be there.
void lay_out_rows(HoughJob& job) noexcept;

/// Angles [first, end).
struct Angles {
  std::int32_t first = 0;
  std::int32_t end = 0;
};

/// One more vote in each of the cells of a pixel. Returns the first angle whose cell has most, if these are
/// more than `best` has, else `best`.
HoughCandidate cast_votes(const HoughMemory& memory, PixelPlace pixel, Angles angles,
                          HoughCandidate best) noexcept;

/// One vote less in each.
void take_votes_off(const HoughMemory& memory, PixelPlace pixel, Angles angles) noexcept;

}  // namespace straightedge::hough
