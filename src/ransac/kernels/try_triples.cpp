// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "base/lanes.hpp"
#include "ransac/kernels/search_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

/// Twice the area of a triangle of pixels below which its plane is chance: the noise of the three readings
/// tilts it at will.
constexpr float least_area = 32;
/// 1/z that is beyond every gate.
constexpr float nowhere = 1e15F;

void planes_through(const SearchTriples& t, SearchPlanes& planes) noexcept {
  for (std::int32_t l = 0; l < search_lanes; ++l) {
    const float u1 = t.u[1][l] - t.u[0][l], v1 = t.v[1][l] - t.v[0][l], q1 = t.q[1][l] - t.q[0][l];
    const float u2 = t.u[2][l] - t.u[0][l], v2 = t.v[2][l] - t.v[0][l], q2 = t.q[2][l] - t.q[0][l];
    const float area = u1 * v2 - u2 * v1;
    const bool wide = area * area >= least_area * least_area;
    const float divisor = wide ? area : 1;
    const float a = (q1 * v2 - q2 * v1) / divisor;
    const float b = (u1 * q2 - u2 * q1) / divisor;
    const float c = (t.q[0][l] - a * t.u[0][l]) - b * t.v[0][l];
    planes.a[l] = wide ? a : 0;
    planes.b[l] = wide ? b : 0;
    planes.c[l] = wide ? c : nowhere;
  }
}

}  // namespace

void try_triples(const SearchReadings& readings, std::uint32_t count, const SearchTriples& triples,
                 SearchPlanes& planes) noexcept {
  planes_through(triples, planes);
  for (std::int32_t l = 0; l < search_lanes; l += lanes) {
    const Lanes a = load(planes.a + l), b = load(planes.b + l), c = load(planes.c + l);
    const Lanes one = all(1);
    Lanes cost = all(0);
    for (std::uint32_t i = 0; i < count; ++i) {
      const Lanes e = (readings.q[i] - ((a * readings.u[i] + b * readings.v[i]) + c)) * readings.w[i];
      const Lanes squared = e * e;
      cost += squared < one ? squared : one;
    }
    store(planes.cost + l, cost);
  }
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
