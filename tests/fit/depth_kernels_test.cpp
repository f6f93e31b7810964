// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/depth_kernels.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "kernel_testing.hpp"
#include "straightedge/random.hpp"
#include "support/catch.hpp"

using namespace straightedge;
using test::for_sets_and_seeds;
using test::rows_by_chance;
using test::stride;

namespace {

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const T& x, const T& y) {
    using Bits = std::array<std::uint8_t, sizeof(T)>;
    return std::bit_cast<Bits>(x) == std::bit_cast<Bits>(y);
  });
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
