// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/depth_cells.hpp"

#include <algorithm>
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

/// Multiples of 2^-10 below 1, so that all sums are exact and may be compared bit for bit.
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

bool same(const InverseDepthMoments& a, const InverseDepthMoments& b) {
  return a.n == b.n && a.u == b.u && a.v == b.v && a.uu == b.uu && a.uv == b.uv && a.vv == b.vv &&
         a.q == b.q && a.uq == b.uq && a.vq == b.vq && a.qq == b.qq;
}

int wrong_cells(const DepthCells& cells, ImageView<const float> image) {
  int wrong = 0;
  for (int level = cells.finest(); level < DepthCells::levels; ++level) {
    const int side = DepthCells::side << level;
    const Size size = cells.size(level);
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const auto place = static_cast<std::size_t>(y * size.width + x);
        wrong += same(cells.level(level)[place], naive(image, x * side, y * side, side)) ? 0 : 1;
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
      for (int level = 0; level < finest; ++level) CHECK(built.cells.level(level).empty());
      const auto sums = built.cells.level(finest);
      REQUIRE(built.cells.counts().size() == sums.size());
      for (std::size_t i = 0; i < sums.size(); ++i) {
        CHECK(built.cells.counts()[i] == std::min(sums[i].n, 255.0));
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
    for (const InverseDepthMoments& m : built.cells.level(level)) CHECK(same(m, {}));
  }
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) image.at(x, y) = x % 2 == 0 ? -1.0F : -0.0F;
  }
  image.at(36, 20) = 0.5F;
  built.cells.build(image.view());
  CHECK(wrong_cells(built.cells, image.view()) == 0);
  CHECK(built.cells.level(3).back().n == 1);
}

TEST_CASE("sum_up carries a change of the smallest cells to the larger ones") {
  const Size size{67, 45};
  Pcg32 random(5);
  auto image = random_depth(size, 0.2, random);
  Built built(size);
  built.cells.build(image.view());
  const Size cells = built.cells.size(0);
  for (const int x : {0, 7, int{cells.width} - 1}) {
    const int y = (x * 5) % cells.height;
    built.cells.level(0)[static_cast<std::size_t>(y * cells.width + x)] = {};
    for (int j = 4 * y; j < std::min<std::int32_t>(4 * y + 4, size.height); ++j) {
      for (int i = 4 * x; i < std::min<std::int32_t>(4 * x + 4, size.width); ++i) image.at(i, j) = 0;
    }
  }
  CHECK(wrong_cells(built.cells, image.view()) > 0);
  built.cells.sum_up();
  CHECK(wrong_cells(built.cells, image.view()) == 0);
}

TEST_CASE("squared residuals from a plane follow from the sums alone") {
  Pcg32 random(8);
  for (int trial = 0; trial < 200; ++trial) {
    const InverseDepthPlane plane{support::uniform(random, -1e-3, 1e-3),
                                  support::uniform(random, -1e-3, 1e-3), support::uniform(random, 0.2, 0.8)};
    InverseDepthMoments m;
    double sum = 0;
    for (int i = 0; i < 30; ++i) {
      const double u = random.below(64), v = random.below(64);
      const double q = plane.at(u, v) + 0.01 * support::normal(random);
      m.add(u, v, q);
      sum += (q - plane.at(u, v)) * (q - plane.at(u, v));
    }
    INFO("trial " << trial);
    CHECK(squared_residuals(m, plane) == Approx(sum).epsilon(1e-8));
  }
  CHECK(squared_residuals({}, {1, 2, 3}) == 0);
}
