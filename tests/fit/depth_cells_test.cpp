// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/depth_cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "straightedge/random.hpp"
#include "support/catch.hpp"
#include "support/drawing.hpp"
#include "support/guarded_image.hpp"

using namespace straightedge;

namespace {

struct Built {
  explicit Built(Size size, int finest = 0) {
    Arena counting = Arena::measure();
    cells.take(counting, size, finest);
    bytes.resize(counting.used());
    Arena arena(bytes);
    cells.take(arena, size, finest);
    REQUIRE(!arena.failed());
  }
  std::vector<std::byte> bytes;
  DepthCells cells;
};

support::GuardedImage<float> random_depth(Size size, double holes, Pcg32& random) {
  support::GuardedImage<float> image(size, 3, 0.0F);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      if (support::uniform(random, 0, 1) < holes) continue;
      image.at(x, y) = static_cast<float>(1 + random.below(1023)) / 1024;
    }
  }
  return image;
}

InverseDepthMoments naive(ImageView<const float> image, int left, int top, int side) {
  InverseDepthMoments m;
  for (int y = top; y < std::min<std::int32_t>(top + side, image.height); ++y) {
    for (int x = left; x < std::min<std::int32_t>(left + side, image.width); ++x) {
      if (image.at(x, y) > 0) m.add(x, y, static_cast<double>(image.at(x, y)));
    }
  }
  return m;
}

/// As 32 bits hold them: sums of deviations from the means.
bool same(const InverseDepthMoments& found, const InverseDepthMoments& m) {
  if (found.n != m.n) return false;
  if (m.n == 0) return true;
  const double u = m.u / m.n, v = m.v / m.n, q = m.q / m.n;
  const auto near = [&](double a, double b, double scale) {
    return std::abs(a - b) <= 1e-6 * scale * (std::abs(b) + m.n);
  };
  const double un = found.u / m.n, vn = found.v / m.n, qn = found.q / m.n;
  return near(un, u, 1) && near(vn, v, 1) && near(qn, q, 1) &&
         near(found.uu - un * found.u, m.uu - u * m.u, 10) &&
         near(found.uv - un * found.v, m.uv - u * m.v, 10) &&
         near(found.vv - vn * found.v, m.vv - v * m.v, 10) &&
         near(found.uq - un * found.q, m.uq - u * m.q, 10) &&
         near(found.vq - vn * found.q, m.vq - v * m.q, 10) &&
         near(found.qq - qn * found.q, m.qq - q * m.q, 10);
}

int wrong_cells(const DepthCells& cells, ImageView<const float> image) {
  int wrong = 0;
  for (int level = cells.finest(); level < DepthCells::levels; ++level) {
    const int side = DepthCells::side << level;
    const Size size = cells.size(level);
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const auto place = static_cast<std::size_t>(y * size.width + x);
        wrong += same(cells.moments(level, place), naive(image, x * side, y * side, side)) ? 0 : 1;
      }
    }
  }
  return wrong;
}

}  // namespace

TEST_CASE("cells of every level hold the sums over their pixels, cut off at the borders") {
  for (const double holes : {0.0, 0.1, 0.7}) {
    for (int width = 1; width <= 70; width += 2) {
      const Size size{width, 1 + (width * 7) % 41};
      Pcg32 random(static_cast<std::uint64_t>(width));
      const auto image = random_depth(size, holes, random);
      Built built(size);
      built.cells.build(image.view());
      INFO("width " << width << " height " << size.height << " holes " << holes);
      CHECK(wrong_cells(built.cells, image.view()) == 0);
      CHECK(image.guards_intact());
    }
  }
}

TEST_CASE("levels below the finest have no cells, and those above the same sums") {
  for (int finest = 0; finest <= 2; ++finest) {
    for (int width = 1; width <= 140; width += 9) {
      const Size size{width, 1 + (width * 5) % 75};
      Pcg32 random(static_cast<std::uint64_t>(width));
      const auto image = random_depth(size, width % 2 == 0 ? 0 : 0.3, random);
      Built built(size, finest);
      built.cells.build(image.view());
      INFO("finest " << finest << " width " << width);
      CHECK(wrong_cells(built.cells, image.view()) == 0);
      for (int level = 0; level < finest; ++level) {
        CHECK(DepthCells::cell_count(built.cells.size(level)) == 0);
      }
      REQUIRE(built.cells.counts().size() == DepthCells::cell_count(built.cells.size(finest)));
      for (std::size_t i = 0; i < built.cells.counts().size(); ++i) {
        CHECK(built.cells.counts()[i] == std::min(built.cells.moments(finest, i).n, 255.0));
      }
    }
  }
}

TEST_CASE("the number of cells counts those that are cut off") {
  CHECK(DepthCells::size_of({640, 480}, 0) == Size{160, 120});
  CHECK(DepthCells::size_of({640, 480}, 3) == Size{20, 15});
  CHECK(DepthCells::size_of({1, 1}, 3) == Size{1, 1});
  CHECK(DepthCells::size_of({33, 5}, 0) == Size{9, 2});
  CHECK(DepthCells::size_of({33, 5}, 3) == Size{2, 1});
}

TEST_CASE("what is not above zero is no reading") {
  const Size size{37, 21};
  Built built(size);
  support::GuardedImage<float> image(size, 0, 0.0F);
  built.cells.build(image.view());
  for (int level = 0; level < DepthCells::levels; ++level) {
    for (std::size_t i = 0; i < DepthCells::cell_count(built.cells.size(level)); ++i) {
      CHECK(built.cells.moments(level, i).n == 0);
    }
  }
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) image.at(x, y) = x % 2 == 0 ? -1.0F : -0.0F;
  }
  image.at(36, 20) = 0.5F;
  built.cells.build(image.view());
  CHECK(wrong_cells(built.cells, image.view()) == 0);
  CHECK(built.cells.moments(3, DepthCells::cell_count(built.cells.size(3)) - 1).n == 1);
}

TEST_CASE("sum_up carries a change of the smallest cells to the larger ones, in the rows it is told") {
  const Size size{67, 45};
  Pcg32 random(5);
  auto image = random_depth(size, 0.2, random);
  Built built(size);
  built.cells.build(image.view());
  const Size cells = built.cells.size(0);
  for (const int x : {0, 7, int{cells.width} - 1}) {
    const int y = (x * 5) % cells.height;
    built.cells.set(0, static_cast<std::size_t>(y * cells.width + x), {});
    for (int j = 4 * y; j < std::min<std::int32_t>(4 * y + 4, size.height); ++j) {
      for (int i = 4 * x; i < std::min<std::int32_t>(4 * x + 4, size.width); ++i) image.at(i, j) = 0;
    }
  }
  CHECK(wrong_cells(built.cells, image.view()) > 0);
  built.cells.sum_up(0, cells.height);
  CHECK(wrong_cells(built.cells, image.view()) == 0);
  // Each row alone.
  for (const int y : {0, 5, int{cells.height} - 1}) {
    built.cells.set(0, static_cast<std::size_t>(y * cells.width + 3), {});
    for (int j = 4 * y; j < std::min<std::int32_t>(4 * y + 4, size.height); ++j)
      for (int i = 12; i < 16; ++i) image.at(i, j) = 0;
    CHECK(wrong_cells(built.cells, image.view()) > 0);
    built.cells.sum_up(y, y + 1);
    CHECK(wrong_cells(built.cells, image.view()) == 0);
  }
}

TEST_CASE("squared residuals from a plane follow from a cell alone") {
  const Size size{32, 32};
  Pcg32 random(8);
  for (int trial = 0; trial < 100; ++trial) {
    const InverseDepthPlane plane{support::uniform(random, -1e-3, 1e-3),
                                  support::uniform(random, -1e-3, 1e-3), support::uniform(random, 0.2, 0.8)};
    const double tilt = support::uniform(random, -2e-4, 2e-4), noise = trial % 2 == 0 ? 1e-3 : 2e-2;
    support::GuardedImage<float> image(size, 0, 0.0F);
    double sum = 0;
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        if (random.below(5) == 0) continue;
        image.at(x, y) = static_cast<float>(plane.at(x, y) + noise * support::normal(random));
        const double r = static_cast<double>(image.at(x, y)) - plane.at(x, y) - tilt * x;
        sum += r * r;
      }
    }
    Built built(size);
    built.cells.build(image.view());
    const DepthSurface surface{static_cast<float>(plane.at(16, 16) + 16 * tilt),
                               static_cast<float>(plane.a + tilt), static_cast<float>(plane.b)};
    double in_small = 0;
    for (std::size_t i = 0; i < 64; ++i) {
      in_small += static_cast<double>(squared_residuals(built.cells.at(0, i), surface));
    }
    INFO("trial " << trial);
    CHECK(static_cast<double>(squared_residuals(built.cells.at(3, 0), surface)) == Approx(sum).epsilon(1e-3));
    CHECK(in_small == Approx(sum).epsilon(1e-3));
  }
  CHECK(squared_residuals(DepthCell{}, {1, 2, 3}) == 0);
}

TEST_CASE("a bent surface is taken for the plane that touches it at a cell") {
  const DepthSurface bent{0.5F, 1e-3F, -2e-3F, 1e-5F, 2e-5F, -3e-5F};
  const DepthCell cell{16, 10, -20, 0.5F, 20, 0, 20, 0.01F, 0.02F, 0.001F};
  const double a = 1e-3 + 2 * 1e-5 * 10 + 2e-5 * -20, b = -2e-3 + 2e-5 * 10 + 2 * -3e-5 * -20;
  const double at = 0.5 + 1e-3 * 10 + 2e-3 * 20 + 1e-5 * 100 - 2e-5 * 200 - 3e-5 * 400;
  const double off = 0.5 - at;
  const double expected = 16 * off * off + 0.001 - 2 * (a * 0.01 + b * 0.02) + a * a * 20 + b * b * 20;
  CHECK(static_cast<double>(squared_residuals(cell, bent)) == Approx(expected).epsilon(1e-4));
}
