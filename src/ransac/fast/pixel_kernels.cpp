// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
// Same results as ../pixel_kernels.cpp; read that first.
#include "ransac/fast/lanes.hpp"
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
    readings = both(wide < q, q <= Floats::all(1e6F));
    return both(r.magnitude() < wide, readings);
  }
};

/// Sums of some neighbouring lanes. Those of whole numbers are exact in floats.
struct Sums {
  std::uint32_t readings = 0, n = 0;
  Floats u, uu, r, ur, rr;

  Sums() noexcept { u = uu = r = ur = rr = Floats::all(0); }
  void add(Floats::Mask some, Floats::Mask inside, Floats at, Floats residual) noexcept {
    readings += count_of(some);
    if (!inside) return;
    const Floats here = at.where(inside), e = residual.where(inside);
    n += count_of(inside);
    u = u + here;
    uu = uu + here * here;
    r = r + e;
    ur = ur + at * e;
    rr = rr + e * e;
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

/// Calls visit(pixels, labels, u) for each group of lanes, u being its first column.
template <class Q, class Visit>
void for_groups(const RansacPixels<Q>& row, std::int32_t first, Visit visit) noexcept {
  const std::int32_t whole = row.count / lanes * lanes;
  for (std::int32_t i = first; i < whole; i += lanes)
    visit(row.pixels + i, row.labels == nullptr ? nullptr : row.labels + i, i);
  if (whole == row.count) return;
  const Tail<Q> tail(row, whole);
  visit(tail.pixels + first, row.labels == nullptr ? nullptr : tail.labels + first, whole + first);
}

Floats columns(std::int32_t first) noexcept {
  float column[width];
  for (std::int32_t l = 0; l < width; ++l) column[l] = static_cast<float>(first + l);
  return Floats::load(column);
}

template <class Q>
RansacPixelSums sum(const RansacPixels<Q>& row) noexcept {
  const Look<Q> look(row);
  alignas(64) float lane[5][lanes];
  RansacPixelSums out;
  for (std::int32_t first = 0; first < lanes; first += width) {
    Sums sums;
    Floats u = columns(first);
    for_groups(row, first, [&](const Q* pixels, const std::uint16_t* labels, std::int32_t) noexcept {
      Floats r;
      Floats::Mask some;
      Floats::Mask inside = look.at(pixels, u, some, r);
      if (labels != nullptr) {
        const Floats::Mask free = unlabelled(labels);
        some = both(some, free);
        inside = both(inside, free);
      }
      sums.add(some, inside, u, r);
      u = u + Floats::all(lanes);
    });
    out.readings += sums.readings;
    out.n += sums.n;
    sums.u.store(lane[0] + first);
    sums.uu.store(lane[1] + first);
    sums.r.store(lane[2] + first);
    sums.ur.store(lane[3] + first);
    sums.rr.store(lane[4] + first);
  }
  out.u = fold_whole(lane[0]);
  out.uu = fold_whole(lane[1]);
  out.r = fold(lane[2]);
  out.ur = fold(lane[3]);
  out.rr = fold(lane[4]);
  return out;
}

template <class Q>
std::uint32_t count(const RansacPixels<Q>& row) noexcept {
  const Look<Q> look(row);
  std::uint32_t n = 0;
  for (std::int32_t first = 0; first < lanes; first += width) {
    Floats u = columns(first);
    for_groups(row, first, [&](const Q* pixels, const std::uint16_t* labels, std::int32_t) noexcept {
      Floats r;
      Floats::Mask some;
      Floats::Mask inside = look.at(pixels, u, some, r);
      if (labels != nullptr) inside = both(inside, unlabelled(labels));
      n += count_of(inside);
      u = u + Floats::all(lanes);
    });
  }
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
