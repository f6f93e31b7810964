// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/depth_kernels.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "kernel_testing.hpp"
#include "straightedge/random.hpp"
#include "support/catch.hpp"
#include "support/drawing.hpp"

using namespace straightedge;
using support::uniform;
using test::for_sets_and_seeds;

namespace {

constexpr std::ptrdiff_t stride = 211;

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const T& x, const T& y) {
    using Bits = std::array<std::uint8_t, sizeof(T)>;
    return std::bit_cast<Bits>(x) == std::bit_cast<Bits>(y);
  });
}

float number(Pcg32& random, std::uint32_t odd_of_hundred) {
  const float infinity = std::numeric_limits<float>::infinity();
  const float odd[] = {0, -0.0F, -1, infinity, -infinity, std::numeric_limits<float>::quiet_NaN(), 1e30F};
  if (random.below(100) < odd_of_hundred) return odd[random.below(7)];
  return static_cast<float>(uniform(random, 0.2, 2));
}

/// Rows of 1/z, some of them hardly broken, some full of what is no reading.
std::vector<float> rows_by_chance(Pcg32& random, std::int32_t height) {
  const std::uint32_t odd = random.below(3) * 15;
  std::vector<float> rows(static_cast<std::size_t>(height * stride));
  for (float& q : rows) q = number(random, odd);
  return rows;
}

struct Labelled {
  std::vector<std::uint16_t> labels;
  std::uint32_t rows_missed = 0;
};

Labelled label_block(const DepthKernels& kernels, const DepthBlock& block) {
  Labelled out{std::vector<std::uint16_t>(static_cast<std::size_t>(block.height * stride), 4711)};
  out.rows_missed = kernels.label_block(block, out.labels.data(), stride);
  return out;
}

DepthBlock block_by_chance(Pcg32& random, const std::vector<float>& rows) {
  DepthBlock block{{rows.data(), stride},
                   1 + static_cast<std::int32_t>(random.below(200)),
                   1 + static_cast<std::int32_t>(random.below(32))};
  block.at = uniform(random, 0.5, 1.5);
  block.along = uniform(random, -0.01, 0.01);
  block.down = uniform(random, -0.01, 0.01);
  block.limit = static_cast<float>(uniform(random, 0.01, 1));
  block.label = static_cast<std::uint16_t>(1 + random.below(256));
  return block;
}

DepthChoice choice_by_chance(Pcg32& random) {
  DepthChoice choice{};
  const std::uint32_t odd = random.below(3) * 10;
  const double spread = random.below(2) == 0 ? 0.002 : 0.1;
  for (float& q : choice.around) {
    q = random.below(100) < odd ? 0.0F : static_cast<float>(0.5 + spread * uniform(random, -1, 1));
  }
  choice.planes = 1 + static_cast<std::int32_t>(random.below(9));
  for (int k = 0; k < choice.planes; ++k) {
    choice.at[k] = static_cast<float>(0.5 + spread * uniform(random, -1, 1));
    choice.along[k] = static_cast<float>(uniform(random, -1e-3, 1e-3));
    choice.down[k] = static_cast<float>(uniform(random, -1e-3, 1e-3));
  }
  choice.noise = random.below(4) == 0 ? 0.0F : 2e-3F;
  choice.noise_of_square = 2e-3F;
  choice.sigmas = 3;
  return choice;
}

std::vector<std::int32_t> chosen(const DepthKernels& kernels, const DepthChoice& choice) {
  std::vector<std::int32_t> out(16, -1);
  kernels.choose(choice, out.data());
  return out;
}

}  // namespace

TEST_CASE("every set of kernels inverts rows as the plain one") {
  for_sets_and_seeds(200, [](const DepthKernels& kernels, Pcg32& random, std::uint64_t width) {
    std::vector<std::uint16_t> raw(width + 1);
    for (std::uint16_t& units : raw)
      units = static_cast<std::uint16_t>(random.below(4) == 0 ? 0 : random.next());
    raw.back() = 65535;
    std::vector<float> expected(width + 2, 7), inverse(width + 2, 7);
    const auto count = static_cast<std::int32_t>(width);
    plain_depth_kernels.invert(raw.data() + 1, count, 5000, expected.data() + 1);
    kernels.invert(raw.data() + 1, count, 5000, inverse.data() + 1);
    CHECK(same_bits(inverse, expected));
    CHECK(expected.front() == 7);
    CHECK(expected.back() == 7);
    const std::uint16_t first = raw[1];
    CHECK(expected[1] == (first == 0 ? 0.0F : 5000.0F / static_cast<float>(first)));
  });
}

TEST_CASE("every set of kernels keeps readings as the plain one, which is as each pixel says") {
  for_sets_and_seeds(200, [](const DepthKernels& kernels, Pcg32& random, std::uint64_t width) {
    std::vector<float> rows = rows_by_chance(random, 1);
    rows[3] = 1e4F;
    rows[4] = std::nextafter(1e4F, 2e4F);
    std::vector<std::uint16_t> mask(width + 1);
    for (std::uint16_t& m : mask) m = static_cast<std::uint16_t>(random.below(3));
    const bool masked = random.below(2) == 0;
    std::vector<float> expected(width + 2, 7), kept(width + 2, 7);
    for (std::size_t x = 0; x < width; ++x) {
      const float q = rows[x + 3];
      expected[x + 1] = q > 0 && q <= 1e4F && (!masked || mask[x + 1] == 0) ? q : 0.0F;
    }
    kernels.keep_readings(rows.data() + 3, masked ? mask.data() + 1 : nullptr,
                          static_cast<std::int32_t>(width), 1e4F, kept.data() + 1);
    CHECK(same_bits(kept, expected));
  });
}

TEST_CASE("every set of kernels labels blocks as the plain one, which is as each pixel's residual says") {
  for_sets_and_seeds(300, [](const DepthKernels& kernels, Pcg32& random, std::uint64_t) {
    const std::vector<float> rows = rows_by_chance(random, 32);
    const DepthBlock block = block_by_chance(random, rows);
    const Labelled expected = label_block(plain_depth_kernels, block), found = label_block(kernels, block);
    CHECK(found.labels == expected.labels);
    CHECK(found.rows_missed == expected.rows_missed);
    std::uint32_t rows_missed = 0;
    for (std::int32_t y = 0; y < block.height; ++y) {
      for (std::int32_t x = 0; x < block.width; ++x) {
        const float q = rows[static_cast<std::size_t>(y * stride + x)];
        const std::uint16_t label = expected.labels[static_cast<std::size_t>(y * stride + x)];
        if (q > 0 && label == 0) rows_missed |= 1U << static_cast<std::uint32_t>(y);
        const double r = static_cast<double>(q) - (block.at + block.along * x + block.down * y);
        const double margin = std::abs(r) - static_cast<double>(block.limit);
        if (!(q > 0) || margin > 1e-5) REQUIRE(label == 0);
        if (q > 0 && margin < -1e-5) REQUIRE(label == block.label);
      }
      REQUIRE(expected.labels[static_cast<std::size_t>(y * stride + block.width)] == 4711);
    }
    CHECK(expected.rows_missed == rows_missed);
  });
}

TEST_CASE("every set of kernels chooses as the plain one") {
  for_sets_and_seeds(2000, [](const DepthKernels& kernels, Pcg32& random, std::uint64_t) {
    const DepthChoice choice = choice_by_chance(random);
    CHECK(chosen(kernels, choice) == chosen(plain_depth_kernels, choice));
  });
}

TEST_CASE("a pixel takes the plane that is nearest, or none where none is near or nothing was read") {
  DepthChoice choice{};
  std::fill(std::begin(choice.around), std::end(choice.around), 0.5F);
  choice.planes = 3;
  choice.at[0] = 0.52F;
  choice.at[1] = 0.501F;
  choice.at[2] = 0.4F;
  choice.noise = 2e-3F;
  choice.sigmas = 3;
  choice.around[DepthChoice::stride + 1] = 0;           // pixel (0, 0)
  choice.around[2 * DepthChoice::stride + 2] = 0.519F;  // pixel (1, 1)
  choice.around[4 * DepthChoice::stride + 4] = 0.46F;   // pixel (3, 3)
  std::vector<std::int32_t> expected(16, 2);
  expected[0] = 0;
  expected[5] = 1;
  expected[15] = 0;
  CHECK(chosen(plain_depth_kernels, choice) == expected);
}

TEST_CASE("where two planes are nearly as near the mean over the surface decides") {
  DepthChoice choice{};
  for (int y = 0; y < 6; ++y) {
    for (int x = 0; x < 8; ++x) choice.around[y * 8 + x] = 0.500F;
  }
  choice.around[2 * DepthChoice::stride + 2] = 0.5045F;  // alone, it is nearer to the other plane
  choice.planes = 2;
  choice.at[0] = 0.500F;
  choice.at[1] = 0.506F;
  choice.noise = 2e-3F;
  choice.sigmas = 3;
  CHECK(chosen(plain_depth_kernels, choice) == std::vector<std::int32_t>(16, 1));
}

TEST_CASE("every set of kernels looks around as the plain one, which tells the only label from several") {
  for_sets_and_seeds(200, [](const DepthKernels& kernels, Pcg32& random, std::uint64_t width) {
    const auto count = static_cast<std::int32_t>(width);
    const std::uint32_t labels = 1 + random.below(3);
    std::array<std::vector<std::uint16_t>, 3> rows;
    for (auto& row : rows) {
      row.resize(width);
      for (std::size_t x = 0; x < width; ++x) {
        const bool other = random.below(12) == 0;
        row[x] = static_cast<std::uint16_t>(other ? random.below(labels + 1) : x > 0 ? row[x - 1] : 1);
      }
    }
    std::vector<std::uint16_t> expected(width + 1, 4711), found = expected;
    plain_depth_kernels.look_around(rows[0].data(), rows[1].data(), rows[2].data(), count, expected.data());
    kernels.look_around(rows[0].data(), rows[1].data(), rows[2].data(), count, found.data());
    CHECK(found == expected);
    CHECK(expected.back() == 4711);
    for (std::size_t x = 0; x < width; ++x) {
      std::uint16_t only = 0;
      for (const auto& row : rows) {
        for (std::size_t i = x > 0 ? x - 1 : 0; i <= x + 1 && i < width; ++i) {
          if (row[i] != 0) only = only == 0 || only == row[i] ? row[i] : std::uint16_t{0xFFFF};
        }
      }
      REQUIRE(expected[x] == only);
    }
  });
}
