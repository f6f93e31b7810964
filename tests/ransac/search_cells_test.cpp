// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "straightedge/host/kernels.hpp"
#include "straightedge/random.hpp"
#include "support/catch.hpp"

using namespace straightedge;

namespace {

constexpr float none = -1e30F;

std::uint32_t bits(float x) {
  return std::bit_cast<std::uint32_t>(x);
}

bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](float x, float y) { return bits(x) == bits(y); });
}

/// Cells as DepthCells has them; some of no use.
struct SomeCells {
  static constexpr std::ptrdiff_t apart = 224;

  explicit SomeCells(Pcg32& random) : numbers(static_cast<std::size_t>(10 * apart)) {
    const float infinity = std::numeric_limits<float>::infinity();
    const float odd[] = {0,    -1,     infinity, -infinity, std::numeric_limits<float>::quiet_NaN(),
                         1e6F, 1.1e6F, 1e-3F,    1e-30F};
    for (std::ptrdiff_t i = 0; i < apart; ++i) {
      const auto some = [&] { return static_cast<float>(random.below(1000)) / 1000; };
      const std::uint32_t kind = random.below(18);
      of(0, i) = static_cast<float>(random.below(17));
      of(1, i) = static_cast<float>(4 * i);
      of(2, i) = some();
      of(3, i) = kind < 9 ? odd[kind] : 0.1F + some();
      // Sums of squares; at times of pixels on a line.
      of(4, i) = 20 * some();
      of(5, i) = kind == 10 ? 0 : some();
      of(6, i) = kind == 10 ? 0 : 20 * some();
      of(7, i) = 0.01F * some();
      of(8, i) = kind == 10 ? 0 : 0.01F * some();
      of(9, i) = 0.0002F * some();
    }
  }
  float& of(int number, std::ptrdiff_t i) { return numbers[static_cast<std::size_t>(number * apart + i)]; }

  std::vector<float> numbers;
};

struct Taken {
  std::vector<float> u, v, q, w, squares;
};

Taken take(const PlaneSearchKernels& kernels, const SomeCells& cells, std::int32_t count) {
  const std::vector<float> empty(static_cast<std::size_t>(SomeCells::apart), 4711);
  Taken t{empty, empty, empty, empty, empty};
  kernels.take_cells({cells.numbers.data(), SomeCells::apart, 320, 240}, count, {0.004F, 0.006F, 0.3F}, none,
                     {t.u.data(), t.v.data(), t.q.data(), t.w.data(), t.squares.data()});
  for (std::vector<float>* numbers : {&t.u, &t.v, &t.q, &t.w, &t.squares})
    numbers->resize(static_cast<std::size_t>(count));
  return t;
}

}  // namespace

TEST_CASE("every set of kernels takes cells as the plain one", "[ransac]") {
  for (const KernelSet& set : kernel_sets()) {
    CAPTURE(std::string(set.name));
    for (std::int32_t count = 1; count <= 200; ++count) {
      Pcg32 random(static_cast<std::uint64_t>(count), 3);
      const SomeCells cells(random);
      const Taken expected = take(plain_plane_search_kernels, cells, count);
      const Taken taken = take(*set.plane_search, cells, count);
      CHECK(same_bits(taken.u, expected.u));
      CHECK(same_bits(taken.v, expected.v));
      CHECK(same_bits(taken.q, expected.q));
      CHECK(same_bits(taken.w, expected.w));
      // What is left of cells that are no reading nobody asks.
      for (std::size_t i = 0; i < taken.q.size(); ++i) {
        if (taken.q[i] > 0) REQUIRE(bits(taken.squares[i]) == bits(expected.squares[i]));
      }
    }
  }
}

TEST_CASE("cells that are no reading, or not flat, are not taken", "[ransac]") {
  Pcg32 random(5, 3);
  SomeCells cells(random);
  const Taken taken = take(plain_plane_search_kernels, cells, 200);
  int readings = 0, bent = 0;
  for (std::ptrdiff_t i = 0; i < 200; ++i) {
    CAPTURE(i);
    const auto k = static_cast<std::size_t>(i);
    const auto sum = [&](int number) { return static_cast<double>(cells.of(number, i)); };
    const double n = sum(0), q = sum(3);
    const double wide = std::max(0.004, 0.006 * q * q), determinant = sum(4) * sum(6) - sum(5) * sum(5);
    double rest = sum(9);
    if (determinant > 1e-3 * sum(4) * sum(6)) {
      const double a = (sum(7) * sum(6) - sum(8) * sum(5)) / determinant;
      const double b = (sum(8) * sum(4) - sum(7) * sum(5)) / determinant;
      rest -= a * sum(7) + b * sum(8);
    }
    const double mean = rest / (wide * wide) / n;
    const bool reading = n > 0 && q > wide && q <= 1e6;
    if (reading && std::abs(mean - 0.3) < 1e-3) continue;
    CHECK((taken.q[k] > 0) == (reading && mean < 0.3));
    readings += taken.q[k] > 0 ? 1 : 0;
    bent += reading && !(mean < 0.3) ? 1 : 0;
    if (!(taken.q[k] > 0)) {
      CHECK(taken.q[k] == none);
      CHECK(taken.w[k] == 1);
      continue;
    }
    CHECK(taken.q[k] == cells.of(3, i));
    CHECK(taken.u[k] == cells.of(1, i) + 320);
    CHECK(taken.v[k] == cells.of(2, i) + 240);
    CHECK(static_cast<double>(taken.w[k]) * wide == Approx(1));
  }
  CHECK(readings > 20);
  CHECK(bent > 20);
}

TEST_CASE("every set of kernels masks the cells that have a masked pixel", "[ransac]") {
  for (const KernelSet& set : kernel_sets()) {
    CAPTURE(std::string(set.name));
    for (const std::int32_t side : {4, 8, 16}) {
      for (std::int32_t count = 0; count <= 70; ++count) {
        CAPTURE(side, count);
        Pcg32 random(static_cast<std::uint64_t>(count), 4);
        const auto pixels = static_cast<std::uint32_t>(side);
        const auto rows = static_cast<std::int32_t>(1 + random.below(pixels));
        const std::int32_t stride = side * count + 5;
        std::vector<std::uint16_t> labels(static_cast<std::size_t>(stride * rows));
        for (std::uint16_t& label : labels) label = random.below(pixels * pixels) == 0 ? 0x100 : 0;
        std::vector<float> q(static_cast<std::size_t>(count) + 1, 0.5F);
        set.plane_search->mask_cells(labels.data(), stride, rows, side, count, none, q.data());
        for (std::int32_t i = 0; i < count; ++i) {
          bool masked = false;
          for (std::int32_t y = 0; y < rows; ++y)
            for (std::int32_t x = 0; x < side; ++x)
              masked = masked || labels[static_cast<std::size_t>(y * stride + i * side + x)] != 0;
          REQUIRE(q[static_cast<std::size_t>(i)] == (masked ? none : 0.5F));
        }
        REQUIRE(q[static_cast<std::size_t>(count)] == 0.5F);
      }
    }
  }
}
