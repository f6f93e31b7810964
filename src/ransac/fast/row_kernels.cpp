// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
// Same results as ../row_kernels.cpp; read that first.
#include "ransac/fast/lanes.hpp"
#include "ransac/kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

constexpr std::uint32_t lanes = ransac_lanes;
constexpr std::uint32_t width = Floats::count;

struct Plane {
  Floats x, y, z, w;

  explicit Plane(const RansacCoefficients& k) noexcept
      : x(Floats::all(k.x)), y(Floats::all(k.y)), z(Floats::all(k.z)), w(Floats::all(k.w)) {}
  Floats residual(const RansacRows& rows, std::uint32_t i) const noexcept {
    return (x * Floats::load(rows.x + i) + y * Floats::load(rows.y + i)) +
           (z * Floats::load(rows.z + i) + w * Floats::load(rows.w + i));
  }
};

/// Nine sums of products of some neighbouring lanes.
struct Products {
  Floats ss, st, sw, tt, tw, ww, se, te, we;

  Products() noexcept { ss = st = sw = tt = tw = ww = se = te = we = Floats::all(0); }
  void add(Floats s, Floats t, Floats w, Floats e) noexcept {
    ss = ss + s * s;
    st = st + s * t;
    sw = sw + s * w;
    tt = tt + t * t;
    tw = tw + t * w;
    ww = ww + w * w;
    se = se + s * e;
    te = te + t * e;
    we = we + w * e;
  }
  void store(float (*sums)[lanes], std::uint32_t first) const noexcept {
    const Floats* const all[] = {&ss, &st, &sw, &tt, &tw, &ww, &se, &te, &we};
    for (int k = 0; k < 9; ++k) all[k]->store(sums[k] + first);
  }
};

}  // namespace

void batch_costs(const RansacRows& rows, const RansacBatch& planes, float* costs) noexcept {
  const Floats one = Floats::all(1);
  for (std::uint32_t first = 0; first < lanes; first += width) {
    const Floats kx = Floats::load(planes.x + first), ky = Floats::load(planes.y + first);
    const Floats kz = Floats::load(planes.z + first), kw = Floats::load(planes.w + first);
    Floats sum = Floats::all(0);
    for (std::uint32_t i = 0; i < rows.count; ++i) {
      const Floats e = (kx * Floats::all(rows.x[i]) + ky * Floats::all(rows.y[i])) +
                       (kz * Floats::all(rows.z[i]) + kw * Floats::all(rows.w[i]));
      sum = sum + min(e * e, one);
    }
    sum.store(costs + first);
  }
}

float row_cost(const RansacRows& rows, const RansacCoefficients& plane) noexcept {
  const Plane k(plane);
  const Floats one = Floats::all(1);
  alignas(64) float sums[lanes];
  for (std::uint32_t first = 0; first < lanes; first += width) {
    Floats sum = Floats::all(0);
    for (std::uint32_t i = first; i < rows.count; i += lanes) {
      const Floats e = k.residual(rows, i);
      sum = sum + min(e * e, one);
    }
    sum.store(sums + first);
  }
  return fold(sums);
}

std::uint32_t count_rows(const RansacRows& rows, const RansacCoefficients& plane) noexcept {
  const Plane k(plane);
  const Floats one = Floats::all(1);
  std::uint32_t count = 0;
  for (std::uint32_t i = 0; i < rows.count; i += width) {
    const Floats e = k.residual(rows, i);
    count += count_of(e * e < one);
  }
  return count;
}

RansacChangeSums sum_changes(const RansacRows& rows, const RansacCoefficients& plane, const float* s,
                             const float* t, float limit) noexcept {
  const Plane k(plane);
  const Floats most = Floats::all(limit);
  alignas(64) float sums[9][lanes];
  for (std::uint32_t first = 0; first < lanes; first += width) {
    Products products;
    for (std::uint32_t i = first; i < rows.count; i += lanes) {
      const Floats e = k.residual(rows, i);
      const Floats::Mask in = e * e < most;
      products.add(Floats::load(s + i).where(in), Floats::load(t + i).where(in),
                   Floats::load(rows.w + i).where(in), e.where(in));
    }
    products.store(sums, first);
  }
  return {fold(sums[0]), fold(sums[1]), fold(sums[2]), fold(sums[3]), fold(sums[4]),
          fold(sums[5]), fold(sums[6]), fold(sums[7]), fold(sums[8])};
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
