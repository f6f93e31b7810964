// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "ransac/labels.hpp"
#include "ransac/readings.hpp"
#include "straightedge/ransac_kernels.hpp"

namespace straightedge::ransac {

/// A frame's pixels as the kernels take them: Q is float or std::uint16_t.
template <class Q>
const ImageView<const Q>& frame_of(const Readings& readings) noexcept {
  if constexpr (sizeof(Q) == sizeof(float)) {
    return readings.frame;
  } else {
    return readings.raw;
  }
}

/// Asks for a row's pixels: they are looked at soon, and a frame that just came is in no near cache.
template <class Q>
void prefetch(const Q* pixels, std::int32_t count) noexcept {
  constexpr auto line = static_cast<std::int32_t>(64 / sizeof(Q));
  for (std::int32_t i = 0; i < count; i += line) __builtin_prefetch(pixels + i);
}

/// Calls visit(pixels, u, v) for every `part`-th row of a frame, from the middle of the first rows on, in
/// pieces that the kernels take; u is the column of the first of the pixels. The plane is 1/z = a i + c
/// there.
template <class Q, class Visit>
void for_pixels(const Readings& readings, const Labels& labels, const LinearPlane& plane, double gates,
                std::int32_t part, Visit visit) noexcept {
  const ImageView<const Q>& frame = frame_of<Q>(readings);
  RansacPixels<Q> row;
  row.scale = readings.scale;
  row.a = static_cast<float>(-plane.x);
  row.constant = readings.constant(gates);
  row.metres = readings.metres(gates);
  const std::int32_t ahead = 2 * part;
  for (std::int32_t v = part / 2; v < frame.height; v += part) {
    if (frame.height - v > ahead) prefetch(frame.row(v + ahead), frame.width);
    for (std::int32_t u = 0; u < frame.width; u += ransac_most_pixels) {
      row.pixels = frame.row(v) + u;
      row.count = frame.width - u < ransac_most_pixels ? frame.width - u : ransac_most_pixels;
      row.c = static_cast<float>(-(plane.x * u + plane.y * v + plane.w));
      row.labels = labels.kept() ? labels.row(static_cast<std::size_t>(v)) + u : nullptr;
      visit(row, u, v);
    }
  }
}

}  // namespace straightedge::ransac
