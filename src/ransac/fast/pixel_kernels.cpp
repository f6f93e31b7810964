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

/// 1/z beyond which there is no reading.
constexpr float most_inverse = 1e6F;

/// Whether no depth has 1/z above that, and depth 0, whose 1/z is infinite, an infinite gate: none of them
/// needs to be compared.
bool bounded(const RansacPixels<std::uint16_t>& row) noexcept {
  return row.scale <= most_inverse && row.metres > 0;
}

/// Some neighbouring pixels.
template <class Q, bool are_bounded>
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
    readings = are_bounded ? wide < q : less_where(q <= Floats::all(most_inverse), wide, q);
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

/// Calls visit(group, inside, readings, u, r) for the lanes from `first` on of each sixteen pixels.
template <bool are_bounded, class Q, class Visit>
void for_groups(const RansacPixels<Q>& row, std::int32_t first, Visit visit) noexcept {
  const Look<Q, are_bounded> look(row);
  const std::ptrdiff_t whole = row.count / lanes;
  const Q* pixels = row.pixels + first;
  Floats u = columns(first), r;
  Floats::Mask some;
  if (row.labels == nullptr) {
    for (std::ptrdiff_t group = 0; group < whole; ++group, pixels += lanes) {
      const Floats::Mask inside = look.at(pixels, u, some, r);
      visit(group, inside, some, u, r);
      u = u + Floats::all(lanes);
    }
  } else {
    const std::uint16_t* labels = row.labels + first;
    for (std::ptrdiff_t group = 0; group < whole; ++group, pixels += lanes, labels += lanes) {
      const Floats::Mask inside = look.at(pixels, u, some, r), free = unlabelled(labels);
      visit(group, both(inside, free), both(some, free), u, r);
      u = u + Floats::all(lanes);
    }
  }
  if (whole * lanes == row.count) return;
  const Tail<Q> tail(row, static_cast<std::int32_t>(whole) * lanes);
  const Floats::Mask inside = look.at(tail.pixels + first, u, some, r),
                     free = unlabelled(tail.labels + first);
  visit(whole, both(inside, free), both(some, free), u, r);
}

template <bool are_bounded, class Q>
RansacPixelSums sum(const RansacPixels<Q>& row) noexcept {
  alignas(64) float lane[3][lanes];
  PixelBits inliers(row.count), readings(row.count);
  const std::int32_t groups = PixelBits::groups_in(row.count);
  ColumnSums whole;
  for (std::int32_t first = 0; first < lanes; first += width) {
    Sums sums;
    ColumnCounter counter;
    for_groups<are_bounded>(
        row, first,
        [&](std::ptrdiff_t group, Floats::Mask inside, Floats::Mask some, Floats u, Floats r) noexcept {
          // What was stored last time is there by now.
          counter.add(inliers.before(group, first), first);
          store_bits(inside, inliers.at(group, first));
          store_bits(some, readings.at(group, first));
          sums.add(inside, u, r);
        });
    counter.add(inliers.before(groups, first), first);
    whole += counter.sums(groups);
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

template <bool are_bounded, class Q>
std::uint32_t count(const RansacPixels<Q>& row) noexcept {
  std::uint32_t n = 0;
  for (std::int32_t first = 0; first < lanes; first += width)
    for_groups<are_bounded>(row, first,
                            [&](std::ptrdiff_t, Floats::Mask inside, Floats::Mask, Floats, Floats) noexcept {
                              n += count_of(inside);
                            });
  return n;
}

}  // namespace

RansacPixelSums sum_inverse_pixels(const RansacPixels<float>& row) noexcept {
  return sum<false>(row);
}

std::uint32_t count_inverse_pixels(const RansacPixels<float>& row) noexcept {
  return count<false>(row);
}

RansacPixelSums sum_raw_pixels(const RansacPixels<std::uint16_t>& row) noexcept {
  return bounded(row) ? sum<true>(row) : sum<false>(row);
}

std::uint32_t count_raw_pixels(const RansacPixels<std::uint16_t>& row) noexcept {
  return bounded(row) ? count<true>(row) : count<false>(row);
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
