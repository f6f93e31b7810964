// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "kernel_testing.hpp"
#include "straightedge/depth_kernels.hpp"
#include "straightedge/inverse_depth.hpp"
#include "straightedge/random.hpp"
#include "support/catch.hpp"
#include "support/drawing.hpp"

using namespace straightedge;
using support::uniform;
using test::for_sets_and_seeds;
using test::rows_by_chance;
using test::stride;

namespace {

struct Labelled {
  std::vector<std::uint16_t> labels;
  std::int32_t count = 0;
};

Labelled label_block(const DepthKernels& kernels, const DepthBlock& block) {
  Labelled out{std::vector<std::uint16_t>(static_cast<std::size_t>(block.height * stride), 4711)};
  out.count = kernels.label_block(block, out.labels.data(), stride);
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

/// 4x4 pixels with one more on every side, so many floats a row.
using Square = std::array<float, 48>;
constexpr std::ptrdiff_t square_stride = 8;

DepthChoice choice_by_chance(Pcg32& random, Square& around) {
  DepthChoice choice{};
  choice.around = {around.data(), square_stride};
  const std::uint32_t odd = random.below(3) * 10;
  const double spread = random.below(2) == 0 ? 0.002 : 0.1;
  for (float& q : around) {
    q = random.below(100) < odd ? 0.0F : static_cast<float>(0.5 + spread * uniform(random, -1, 1));
  }
  choice.planes = 1 + static_cast<std::int32_t>(random.below(9));
  for (int k = 0; k < choice.planes; ++k) {
    choice.at[k] = static_cast<float>(0.5 + spread * uniform(random, -1, 1));
    choice.along[k] = static_cast<float>(uniform(random, -1e-3, 1e-3));
    choice.down[k] = static_cast<float>(uniform(random, -1e-3, 1e-3));
    choice.label[k] = static_cast<std::uint16_t>(1 + random.below(256));
  }
  choice.noise = random.below(4) == 0 ? 0.0F : 2e-3F;
  choice.noise_of_square = 2e-3F;
  choice.sigmas = 3;
  return choice;
}

std::vector<std::uint16_t> chosen(const DepthKernels& kernels, const DepthChoice& choice) {
  std::vector<std::uint16_t> out(16, 4711);
  kernels.choose(choice, out.data());
  return out;
}

}  // namespace

TEST_CASE("every set of kernels labels blocks as the plain one, which is as each pixel's residual says") {
  for_sets_and_seeds(300, [](const DepthKernels& kernels, Pcg32& random, std::uint64_t) {
    const std::vector<float> rows = rows_by_chance(random, 32);
    const DepthBlock block = block_by_chance(random, rows);
    const Labelled expected = label_block(plain_depth_kernels, block), found = label_block(kernels, block);
    CHECK(found.labels == expected.labels);
    CHECK(found.count == expected.count);
    CHECK(found.count == std::count(found.labels.begin(), found.labels.end(), block.label));
    for (std::int32_t y = 0; y < block.height; ++y) {
      for (std::int32_t x = 0; x < block.width; ++x) {
        const float q = rows[static_cast<std::size_t>(y * stride + x)];
        const std::uint16_t label = expected.labels[static_cast<std::size_t>(y * stride + x)];
        const double r = static_cast<double>(q) - (block.at + block.along * x + block.down * y);
        const double margin = std::abs(r) - static_cast<double>(block.limit);
        if (!(q > 0) || margin > 1e-5) REQUIRE(label == 0);
        if (q > 0 && margin < -1e-5) REQUIRE(label == block.label);
      }
      REQUIRE(expected.labels[static_cast<std::size_t>(y * stride + block.width)] == 4711);
    }
  });
}

TEST_CASE("a row of cells gives its pixels the labels of whole cells, in every set of kernels") {
  for_sets_and_seeds(300, [](const DepthKernels& kernels, Pcg32& random, std::uint64_t) {
    const std::int32_t side = 4 << random.below(3);
    const auto width = 1 + static_cast<std::int32_t>(random.below(200));
    std::vector<std::uint16_t> cells(static_cast<std::size_t>((width + side - 1) / side));
    for (std::uint16_t& cell : cells) {
      const std::uint16_t label = static_cast<std::uint16_t>(1 + random.below(256));
      const std::uint16_t kinds[] = {0, DepthWholeCells::border, DepthWholeCells::inner_border, label,
                                     static_cast<std::uint16_t>(label | DepthWholeCells::mark)};
      cell = kinds[random.below(5)];
    }
    std::vector<std::uint16_t> found(static_cast<std::size_t>(width) + 1, 4711);
    kernels.spread_labels(cells.data(), side, width, found.data());
    for (std::int32_t x = 0; x < width; ++x) {
      const std::uint16_t cell = cells[static_cast<std::size_t>(x / side)];
      const bool whole = cell < DepthWholeCells::inner_border && cell >= DepthWholeCells::mark;
      REQUIRE(found[static_cast<std::size_t>(x)] == (whole ? cell - DepthWholeCells::mark : 0));
    }
    REQUIRE(found.back() == 4711);
  });
}

TEST_CASE("every set of kernels gives the labels of a row their new names") {
  for_sets_and_seeds(300, [](const DepthKernels& kernels, Pcg32& random, std::uint64_t seed) {
    const std::uint32_t names = seed % 3 == 0 ? 257 : 1 + random.below(70);
    std::vector<std::uint16_t> by(names), before(random.below(200));
    for (std::uint16_t& name : by) name = static_cast<std::uint16_t>(random.below(names));
    for (std::uint16_t& label : before) label = static_cast<std::uint16_t>(random.below(names));
    std::vector<std::uint16_t> labels = before;
    labels.push_back(4711);
    kernels.rename_row(labels.data(), static_cast<std::int32_t>(before.size()), by.data(),
                       static_cast<std::int32_t>(names));
    for (std::size_t x = 0; x < before.size(); ++x) REQUIRE(labels[x] == by[before[x]]);
    REQUIRE(labels.back() == 4711);
  });
}

TEST_CASE("every set of kernels chooses as the plain one") {
  for_sets_and_seeds(2000, [](const DepthKernels& kernels, Pcg32& random, std::uint64_t) {
    Square around;
    const DepthChoice choice = choice_by_chance(random, around);
    CHECK(chosen(kernels, choice) == chosen(plain_depth_kernels, choice));
  });
}

TEST_CASE("a pixel takes the plane that is nearest, or none where none is near or nothing was read") {
  Square around;
  around.fill(0.5F);
  DepthChoice choice{};
  choice.around = {around.data(), square_stride};
  choice.planes = 3;
  choice.at[0] = 0.52F;
  choice.at[1] = 0.501F;
  choice.at[2] = 0.4F;
  choice.label[0] = 12;
  choice.label[1] = 256;
  choice.label[2] = 3;
  choice.noise = 2e-3F;
  choice.sigmas = 3;
  around[square_stride + 1] = 0;           // pixel (0, 0)
  around[2 * square_stride + 2] = 0.519F;  // pixel (1, 1)
  around[4 * square_stride + 4] = 0.46F;   // pixel (3, 3)
  std::vector<std::uint16_t> expected(16, 256);
  expected[0] = 0;
  expected[5] = 12;
  expected[15] = 0;
  CHECK(chosen(plain_depth_kernels, choice) == expected);
}

TEST_CASE("where two planes are nearly as near the mean over the surface decides") {
  Square around;
  around.fill(0.500F);
  around[2 * square_stride + 2] = 0.5045F;  // alone, it is nearer to the other plane
  around[2 * square_stride + 3] = 0.9F;     // beside it, of another surface
  DepthChoice choice{};
  choice.around = {around.data(), square_stride};
  choice.planes = 2;
  choice.at[0] = 0.500F;
  choice.at[1] = 0.506F;
  choice.label[0] = 7;
  choice.label[1] = 8;
  choice.noise = 2e-3F;
  choice.sigmas = 3;
  std::vector<std::uint16_t> expected(16, 7);
  expected[6] = 0;
  CHECK(chosen(plain_depth_kernels, choice) == expected);
}
