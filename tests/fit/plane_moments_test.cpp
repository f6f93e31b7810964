// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <vector>

#include "straightedge/inverse_depth.hpp"
#include "straightedge/plane_fit.hpp"
#include "straightedge/random.hpp"
#include "support/catch.hpp"

using namespace straightedge;

namespace {

double integer(Pcg32& random) {
  return static_cast<double>(random.below(201)) - 100;
}

std::array<double, 11> sums(const PlaneMoments& m) {
  return {m.weight, m.x, m.y, m.z, m.xx, m.xy, m.xz, m.yy, m.yz, m.zz, m.count};
}

std::array<double, 10> sums(const InverseDepthMoments& m) {
  return {m.n, m.u, m.v, m.uu, m.uv, m.vv, m.q, m.uq, m.vq, m.qq};
}

}  // namespace

// Integers of this size add up without rounding: the laws hold to the last bit.
TEST_CASE("moments of two sets add up to those of both, in any order") {
  constexpr std::uint64_t seed = 41;
  CAPTURE(seed);
  Pcg32 random(seed);
  PlaneMoments all, odd, even;
  InverseDepthMoments pixels, odd_pixels, even_pixels;
  for (int i = 0; i < 100; ++i) {
    const Vector3 p{integer(random), integer(random), integer(random)};
    const double w = 1 + random.below(9);
    all.add(p, w);
    (i % 2 == 0 ? even : odd).add(p, w);
    pixels.add(p.x, p.y, p.z);
    (i % 2 == 0 ? even_pixels : odd_pixels).add(p.x, p.y, p.z);
  }
  odd.add(even);
  CHECK(sums(odd) == sums(all));
  odd_pixels.add(even_pixels);
  CHECK(sums(odd_pixels) == sums(pixels));
}

TEST_CASE("moments seen from another origin are those of moved points") {
  constexpr std::uint64_t seed = 42;
  CAPTURE(seed);
  Pcg32 random(seed);
  const Vector3 origin{17, -40, 9};
  PlaneMoments here, there;
  InverseDepthMoments pixels_here, pixels_there;
  for (int i = 0; i < 100; ++i) {
    const Vector3 p{integer(random), integer(random), integer(random)};
    const double w = 1 + random.below(9);
    here.add(p, w);
    there.add(p - origin, w);
    pixels_here.add(p.x, p.y, p.z);
    pixels_there.add(p.x - origin.x, p.y - origin.y, p.z);
  }
  CHECK(sums(here.seen_from(origin)) == sums(there));
  CHECK(sums(here.seen_from(origin).seen_from(-origin)) == sums(here));
  CHECK(sums(pixels_here.seen_from(origin.x, origin.y)) == sums(pixels_there));
}
