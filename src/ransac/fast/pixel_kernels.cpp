// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
// Same results as ../pixel_kernels.cpp; read that first.
#include "ransac/fast/lanes.hpp"
#include "ransac/fast/pixel_bits.hpp"
#include "ransac/kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

constexpr std::int32_t lanes = ransac_lanes;
constexpr std::int32_t width = Floats::count;

/// Depth 0 becomes infinity, which is no reading either.
Floats inverse_of(const float* pixels, Floats /*scale*/) noexcept {
  return Floats::load(pixels);
}
Floats inverse_of(const std::uint16_t* pixels, Floats scale) noexcept {
  return scale / Floats::load(pixels);
}

/// Some neighbouring pixels.
template <class Q>
struct Look {
  Floats scale, a, c, constant, metres;

  explicit Look(const RansacPixels<Q>& row) noexcept
      : scale(Floats::all(row.scale)),
        a(Floats::all(row.a)),
        c(Floats::all(row.c)),
        constant(Floats::all(row.constant)),
        metres(Floats::all(row.metres)) {}
  Floats::Mask at(const Q* pixels, Floats u, Floats::Mask& readings, Floats& r) const noexcept {
    const Floats q = inverse_of(pixels, scale);
    const Floats wide = max(metres * (q * q), constant);
    r = q - (a * u + c);
    readings = less_where(q <= Floats::all(1e6F), wide, q);
    return less_where(readings, r.magnitude(), wide);
  }
};

/// Sums of some neighbouring lanes.
struct Sums {
  Floats r, ur, rr;

  Sums() noexcept { r = ur = rr = Floats::all(0); }
  void add(Floats::Mask inside, Floats at, Floats residual) noexcept {
    r = r.plus(residual, inside);
    ur = ur.plus(at * residual, inside);
    rr = rr.plus(residual * residual, inside);
  }
};

/// The last pixels, with zeros behind them.
template <class Q>
struct Tail {
  Q pixels[lanes] = {};
  std::uint16_t labels[lanes] = {};

  Tail(const RansacPixels<Q>& row, std::int32_t first) noexcept {
    for (std::int32_t i = first; i < row.count; ++i) {
      pixels[i - first] = row.pixels[i];
      if (row.labels != nullptr) labels[i - first] = row.labels[i];
    }
  }
};

Floats columns(std::int32_t first) noexcept {
  float column[width];
  for (std::int32_t l = 0; l < width; ++l) column[l] = static_cast<float>(first + l);
  return Floats::load(column);
}

/// Calls visit(i, inside, readings, u, r) for each group of lanes, from pixel i on.
template <class Q, class Visit>
void for_groups(const RansacPixels<Q>& row, std::int32_t first, Visit visit) noexcept {
  const Look<Q> look(row);
  const std::int32_t whole = row.count / lanes * lanes;
  Floats u = columns(first), r;
  Floats::Mask some;
  if (row.labels == nullptr) {
    for (std::int32_t i = first; i < whole; i += lanes) {
      const Floats::Mask inside = look.at(row.pixels + i, u, some, r);
      visit(i, inside, some, u, r);
      u = u + Floats::all(lanes);
    }
  } else {
    for (std::int32_t i = first; i < whole; i += lanes) {
      const Floats::Mask inside = look.at(row.pixels + i, u, some, r), free = unlabelled(row.labels + i);
      visit(i, both(inside, free), both(some, free), u, r);
      u = u + Floats::all(lanes);
    }
  }
  if (whole == row.count) return;
  const Tail<Q> tail(row, whole);
  const Floats::Mask inside = look.at(tail.pixels + first, u, some, r),
                     free = unlabelled(tail.labels + first);
  visit(whole + first, both(inside, free), both(some, free), u, r);
}

template <class Q>
RansacPixelSums sum(const RansacPixels<Q>& row) noexcept {
  alignas(64) float lane[3][lanes];
  PixelBits inliers(row.count), readings(row.count);
  ColumnSums whole;
  for (std::int32_t first = 0; first < lanes; first += width) {
    Sums sums;
    ColumnCounter columns_before;
    for_groups(row, first,
               [&](std::int32_t i, Floats::Mask inside, Floats::Mask some, Floats u, Floats r) noexcept {
                 // Those that were stored last time are there by now.
                 columns_before.add(inliers.at(i - lanes), first);
                 store_bits(inside, inliers.at(i));
                 store_bits(some, readings.at(i));
                 sums.add(inside, u, r);
               });
    const std::int32_t groups = (row.count + lanes - 1) / lanes;
    columns_before.add(inliers.at((groups - 1) * lanes + first), first);
    whole += columns_before.sums(groups);
    sums.r.store(lane[0] + first);
    sums.ur.store(lane[1] + first);
    sums.rr.store(lane[2] + first);
  }
  return {.readings = readings.count(),
          .n = whole.n,
          .u = whole.u,
          .uu = whole.uu,
          .r = fold(lane[0]),
          .ur = fold(lane[1]),
          .rr = fold(lane[2])};
}

template <class Q>
std::uint32_t count(const RansacPixels<Q>& row) noexcept {
  std::uint32_t n = 0;
  for (std::int32_t first = 0; first < lanes; first += width)
    for_groups(row, first, [&](std::int32_t, Floats::Mask inside, Floats::Mask, Floats, Floats) noexcept {
      n += count_of(inside);
    });
  return n;
}

}  // namespace

RansacPixelSums sum_inverse_pixels(const RansacPixels<float>& row) noexcept {
  return sum(row);
}

std::uint32_t count_inverse_pixels(const RansacPixels<float>& row) noexcept {
  return count(row);
}

RansacPixelSums sum_raw_pixels(const RansacPixels<std::uint16_t>& row) noexcept {
  return sum(row);
}

std::uint32_t count_raw_pixels(const RansacPixels<std::uint16_t>& row) noexcept {
  return count(row);
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
