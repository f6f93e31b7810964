// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <array>
#include <bit>
#include <limits>
#include <string>
#include <vector>

#include "straightedge/host/kernels.hpp"
#include "straightedge/random.hpp"
#include "support/catch.hpp"

using namespace straightedge;

namespace {

constexpr float farthest = 1e4F;
constexpr std::ptrdiff_t stride = 19;
using Pixels = std::array<float, 8 * stride>;

/// Whole squares, squares with holes, empty ones; numbers that are no readings.
Pixels pixels_by_chance(Pcg32& random) {
  const float infinity = std::numeric_limits<float>::infinity();
  const float odd[] = {0, -1, infinity, -infinity, std::numeric_limits<float>::quiet_NaN(), 1.1e4F};
  const std::uint32_t holes = random.below(4) * 30;
  Pixels pixels;
  for (float& q : pixels) {
    const bool hole = random.below(100) < holes;
    q = hole ? odd[random.below(6)] : 0.5F + 0.001F * static_cast<float>(random.below(1000));
  }
  return pixels;
}

void check_same(const SquareSums& a, const SquareSums& b) {
  const std::array numbers{a.reference, a.q, a.uq, a.vq, a.qq}, expected{b.reference, b.q, b.uq, b.vq, b.qq};
  using Bits = std::array<std::uint32_t, 5>;
  CHECK(std::bit_cast<Bits>(numbers) == std::bit_cast<Bits>(expected));
  CHECK(a.whole == b.whole);
  CHECK(std::equal(std::begin(a.seen), std::end(a.seen), std::begin(b.seen)));
}

}  // namespace

TEST_CASE("every set of kernels sums squares as the plain one", "[hough]") {
  for (const KernelSet& set : kernel_sets()) {
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
      CAPTURE(std::string(set.name), seed);
      Pcg32 random(seed);
      const Pixels pixels = pixels_by_chance(random);
      SquareSums expected[2], sums[2];
      plain_hough_patch_kernels.sum_squares(pixels.data(), stride, farthest, expected);
      set.hough_patches->sum_squares(pixels.data(), stride, farthest, sums);
      check_same(sums[0], expected[0]);
      check_same(sums[1], expected[1]);
    }
  }
}

TEST_CASE("the sums of a square are those of its readings", "[hough]") {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    CAPTURE(seed);
    Pcg32 random(seed, 1);
    const Pixels pixels = pixels_by_chance(random);
    SquareSums sums[2];
    plain_hough_patch_kernels.sum_squares(pixels.data(), stride, farthest, sums);
    for (int square = 0; square < 2; ++square) {
      const SquareSums& s = sums[square];
      double q = 0, uq = 0, vq = 0, qq = 0;
      int readings = 0;
      for (int v = 0; v < 8; ++v)
        for (int u = 0; u < 8; ++u) {
          const float read = pixels[static_cast<std::size_t>(v * stride + square * 8 + u)];
          const bool reading = read > 0 && read <= farthest;
          if (!s.whole) CHECK((s.seen[u] >> v & 1) == (reading ? 1 : 0));
          if (!reading) continue;
          ++readings;
          const double d = static_cast<double>(read) - static_cast<double>(s.reference);
          q += d;
          uq += u * d;
          vq += v * d;
          qq += d * d;
        }
      CHECK(s.whole == (readings == 64));
      CHECK((s.reference > 0) == (readings > 0));
      CHECK(static_cast<double>(s.q) == Approx(q).margin(1e-4));
      CHECK(static_cast<double>(s.uq) == Approx(uq).margin(1e-3));
      CHECK(static_cast<double>(s.vq) == Approx(vq).margin(1e-3));
      CHECK(static_cast<double>(s.qq) == Approx(qq).margin(1e-4));
    }
  }
}
