// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "canny/stages.hpp"
#include "support/catch.hpp"

using namespace stages;

namespace {

constexpr Border borders[] = {Border::constant, Border::replicate, Border::reflect, Border::reflect_101};

// The pixel at (x, y), inside or not, by walking along the border's own picture one step at a time.
int walked(int i, int n, Border border) {
  while (i < 0 || i >= n) {
    if (border == Border::constant) return -1;
    if (border == Border::replicate) i += i < 0 ? 1 : -1;
    if (border == Border::reflect) i = i < 0 ? -1 - i : 2 * n - 1 - i;
    if (border == Border::reflect_101) i = n == 1 ? 0 : i < 0 ? -i : 2 * (n - 1) - i;
  }
  return i;
}

int pixel(const GrayImage& gray, int x, int y, Border border) {
  const int column = walked(x, gray.size().width, border);
  const int row = walked(y, gray.size().height, border);
  return column < 0 || row < 0 ? 0 : gray.at(column, row);
}

// One sum over the whole square: weight (i, j) is across[i] * down[j].
template <class Taps>
long long square_sum(const GrayImage& gray, int x, int y, Border border, const Taps& across,
                     const Taps& down) {
  const int n = static_cast<int>(across.size());
  long long sum = 0;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const long long weight =
          static_cast<long long>(across[static_cast<std::size_t>(i)]) * down[static_cast<std::size_t>(j)];
      sum += weight * pixel(gray, x - n / 2 + i, y - n / 2 + j, border);
    }
  }
  return sum;
}

const std::vector<int> smoothing[] = {{1, 2, 1}, {1, 4, 6, 4, 1}, {1, 6, 15, 20, 15, 6, 1}};
const std::vector<int> differences[] = {{-1, 0, 1}, {-1, -2, 0, 2, 1}, {-1, -4, -5, 0, 5, 4, 1}};

}  // namespace

TEST_CASE("the blur is one sum over the square, rounded once") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Pcg32 random(seed);
    const Size size{1 + static_cast<int>(random.below(24)), 1 + static_cast<int>(random.below(16))};
    const GrayImage gray = support::random_bytes(size, random, static_cast<int>(random.below(9)));
    const int n = 1 + 2 * static_cast<int>(random.below(12));
    const double sigma = random.below(60) / 10.0;
    const std::vector<std::uint16_t> taps = kernel(n, sigma);
    for (const Border border : borders) {
      GrayImage out(size, 3);
      REQUIRE(blur(gray.view(), taps, border, out.view()) == Status::ok);
      CHECK(out.guards_intact());
      CAPTURE(seed, size.width, size.height, n, sigma, static_cast<int>(border));
      for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
          REQUIRE(out.at(x, y) == (square_sum(gray, x, y, border, taps, taps) + 32768) / 65536);
        }
      }
    }
  }
}

TEST_CASE("the gradient is one sum over the square") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Pcg32 random(seed, 1);
    const Size size{1 + static_cast<int>(random.below(24)), 1 + static_cast<int>(random.below(16))};
    const GrayImage gray = support::random_bytes(size, random, static_cast<int>(random.below(9)));
    const std::size_t kind = random.below(3);
    const int aperture = 3 + 2 * static_cast<int>(kind);
    for (const Border border : borders) {
      GradientImage dx(size, 1), dy(size, 2);
      REQUIRE(gradient(gray.view(), aperture, border, GradientScale::clamp, dx.view(), dy.view()) ==
              Status::ok);
      CHECK(dx.guards_intact());
      CHECK(dy.guards_intact());
      CAPTURE(seed, size.width, size.height, aperture, static_cast<int>(border));
      for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
          const long long right = square_sum(gray, x, y, border, differences[kind], smoothing[kind]);
          const long long below = square_sum(gray, x, y, border, smoothing[kind], differences[kind]);
          REQUIRE(dx.at(x, y) == std::clamp(right, -32768LL, 32767LL));
          REQUIRE(dy.at(x, y) == std::clamp(below, -32768LL, 32767LL));
        }
      }
    }
  }
}
