// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "base/lanes.hpp"
#include "straightedge/hough_patch_kernels.hpp"

namespace straightedge {
namespace STRAIGHTEDGE_KERNEL_SET {
namespace {

constexpr std::int32_t side = 8;
constexpr std::int32_t columns = 2 * side;

/// Of the columns of two squares.
struct ColumnSums {
  float q[columns], uq[columns], vq[columns], qq[columns];
  float seen[columns];  ///< 2^v for each reading
};

bool is_reading(float q, float farthest) noexcept {
  return q > 0 && q <= farthest;
}

/// One in the square's middle is asked first.
float reference_of(const float* pixels, std::ptrdiff_t stride, float farthest) noexcept {
  const float middle = pixels[side / 2 * stride + side / 2];
  if (is_reading(middle, farthest)) return middle;
  for (std::ptrdiff_t v = 0; v < side; ++v)
    for (std::ptrdiff_t u = 0; u < side; ++u)
      if (is_reading(pixels[v * stride + u], farthest)) return pixels[v * stride + u];
  return 0;
}

void sum_columns(const float* pixels, std::ptrdiff_t stride, float farthest,
                 const float (&references)[columns], ColumnSums& sums) noexcept {
  static constexpr float places[columns] = {0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7};
  const Lanes none = all(0), most = all(farthest);
  for (std::int32_t l = 0; l < columns; l += lanes) {
    const Lanes reference = load(references + l);
    Lanes q = none, vq = none, qq = none, seen = none;
    float bit = 1;
    for (std::int32_t v = 0; v < side; ++v, bit *= 2) {
      const Lanes read = load(pixels + v * stride + l);
      const auto good = (read > none) & (read <= most);
      const Lanes d = good ? read - reference : none;
      q += d;
      vq += static_cast<float>(v) * d;
      qq += d * d;
      seen += good ? all(bit) : none;
    }
    store(sums.q + l, q);
    store(sums.uq + l, load(places + l) * q);
    store(sums.vq + l, vq);
    store(sums.qq + l, qq);
    store(sums.seen + l, seen);
  }
}

float fold(const float* eight) noexcept {
  float sums[4];
  for (std::int32_t l = 0; l < 4; ++l) sums[l] = eight[l] + eight[l + 4];
  return (sums[0] + sums[2]) + (sums[1] + sums[3]);
}

void sum_squares(const float* pixels, std::ptrdiff_t stride, float farthest, SquareSums (&sums)[2]) noexcept {
  float references[columns];
  for (std::int32_t s = 0; s < 2; ++s) {
    sums[s].reference = reference_of(pixels + s * side, stride, farthest);
    for (std::int32_t u = 0; u < side; ++u) references[s * side + u] = sums[s].reference;
  }
  ColumnSums of;
  sum_columns(pixels, stride, farthest, references, of);
  for (std::int32_t s = 0; s < 2; ++s) {
    const std::int32_t first = s * side;
    sums[s].q = fold(of.q + first);
    sums[s].uq = fold(of.uq + first);
    sums[s].vq = fold(of.vq + first);
    sums[s].qq = fold(of.qq + first);
    sums[s].whole = fold(of.seen + first) == side * 255.0F;
    if (sums[s].whole) continue;
    for (std::int32_t u = 0; u < side; ++u) sums[s].seen[u] = static_cast<std::uint8_t>(of.seen[first + u]);
  }
}

}  // namespace
}  // namespace STRAIGHTEDGE_KERNEL_SET

constinit const HoughPatchKernels STRAIGHTEDGE_OF_SET(_hough_patch_kernels) = {
    .sum_squares = STRAIGHTEDGE_KERNEL_SET::sum_squares,
};

}  // namespace straightedge
