// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "base/lanes.hpp"
#include "base/three_counts.hpp"
#include "pixel_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

constexpr std::int32_t side = DepthChoice::side;

// Of each of the 4x4 pixels.
constexpr float columns[DepthChoice::pixels] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
constexpr float rows[DepthChoice::pixels] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};

#if STRAIGHTEDGE_LANES > 4
using Four [[gnu::vector_size(16)]] = float;

Four four(const float* from) noexcept {
  Four x;
  std::memcpy(&x, from, sizeof x);
  return x;
}
#endif

/// The pixels from `first` on, each moved by (i − 1, j − 1).
Lanes moved(const DepthRows& around, std::int32_t first, std::int32_t i, std::int32_t j) noexcept {
  const float* at = around.first + (first / side + j) * around.stride + (first % side + i);
#if STRAIGHTEDGE_LANES == 16
  const std::ptrdiff_t below = around.stride;
  const auto upper = __builtin_shufflevector(four(at), four(at + below), 0, 1, 2, 3, 4, 5, 6, 7);
  const auto lower =
      __builtin_shufflevector(four(at + 2 * below), four(at + 3 * below), 0, 1, 2, 3, 4, 5, 6, 7);
  return __builtin_shufflevector(upper, lower, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
#elif STRAIGHTEDGE_LANES == 8
  return __builtin_shufflevector(four(at), four(at + around.stride), 0, 1, 2, 3, 4, 5, 6, 7);
#else
  return load(at);
#endif
}

struct Nearest {
  Lanes distance, next, label;
};

/// u and v from the corner.
Nearest nearest(const DepthChoice& square, const Lanes& u, const Lanes& v, const Lanes& q) noexcept {
  Nearest best{all(1e30F), all(1e30F), all(0)};
  for (std::int32_t k = 0; k < square.planes; ++k) {
    const Lanes r = q - ((square.at[k] + square.along[k] * u) + square.down[k] * v);
    const Lanes distance = r < all(0) ? -r : r;
    const auto nearer = distance < best.distance;
    const Lanes further = nearer ? best.distance : distance;
    best.next = further < best.next ? further : best.next;
    best.distance = nearer ? distance : best.distance;
    best.label = nearer ? all(static_cast<float>(square.label[k])) : best.label;
  }
  return best;
}

/// Of nine pixels how many count, and the sums of their columns and rows, each 0, 1 or 2.
using NearCounts = ThreeCounts<4, 9>;

/// What each of the nine counts for.
struct PixelCounts {
  float of[3][3];

  constexpr PixelCounts() noexcept : of{} {
    for (std::int32_t row = 0; row < 3; ++row)
      for (std::int32_t column = 0; column < 3; ++column) of[row][column] = NearCounts::of(1, column, row);
  }
};
constexpr PixelCounts counts_of;

/// The nearest to the mean of the 3x3 pixels around each one that lie on its surface.
Nearest nearest_to_mean(const DepthChoice& square, std::int32_t first, const Lanes& q,
                        const Lanes& limit) noexcept {
  Lanes sum = all(0), counted = sum;
  for (std::int32_t j = 0; j < 3; ++j) {
    for (std::int32_t i = 0; i < 3; ++i) {
      const Lanes other = moved(square.around, first, i, j), r = other - q;
      const auto counts = (other > all(0)) & (r <= limit) & (r >= -limit);
      sum = counts ? sum + other : sum;
      counted = counts ? counted + all(counts_of.of[j][i]) : counted;
    }
  }
  const NearCounts near(counted);
  const Wholes n = near.first(), right = near.second() - n, down = near.third() - n;
  const Lanes readings = in_floats(n), count = readings > all(1) ? readings : all(1);
  return nearest(square, load(columns + first) + in_floats(right) / count,
                 load(rows + first) + in_floats(down) / count, sum / count);
}

void choose_some(const DepthChoice& square, std::int32_t first, std::uint16_t* labels) noexcept {
  constexpr float beyond_doubt = 4, same_surface = 8;
  const Lanes q = moved(square.around, first, 1, 1);
  const Lanes of_square = square.noise_of_square * (q * q), least = all(square.noise);
  const Lanes noise = of_square > least ? of_square : least;
  const auto reads = q > all(0);
  Nearest found = nearest(square, load(columns + first), load(rows + first), q);
  const auto doubt = (found.next - found.distance < beyond_doubt * noise) & reads;
  if (any(doubt)) {
    const Nearest again = nearest_to_mean(square, first, q, same_surface * noise);
    found.label = doubt ? again.label : found.label;
    found.distance = doubt ? again.distance : found.distance;
  }
  const auto within = (found.distance < square.sigmas * noise) & reads;
  const Lanes label = within ? found.label : all(0);
  float each[lanes];
  store(each, label);
  for (std::int32_t i = 0; i < lanes; ++i) labels[first + i] = static_cast<std::uint16_t>(each[i]);
}

}  // namespace

void choose(const DepthChoice& square, std::uint16_t* labels) noexcept {
  for (std::int32_t first = 0; first < DepthChoice::pixels; first += lanes) {
    choose_some(square, first, labels);
  }
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
