// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "map/picture_rows.hpp"
#include "straightedge/host/kernels.hpp"
#include "straightedge/random.hpp"
#include "support/catch.hpp"

using namespace straightedge;

namespace {

using Row = std::vector<std::uint8_t>;

/// Even stretches, extremes and noise.
Row random_row(Pcg32& random, std::int32_t width) {
  Row row;
  std::uint8_t level = 0;
  for (std::int32_t x = 0; x < width; ++x) {
    const std::uint32_t kind = random.below(8);
    if (kind == 0) level = static_cast<std::uint8_t>(random.below(256));
    if (kind == 1) level = random.below(2) == 0 ? 0 : 255;
    row.push_back(level);
  }
  return row;
}

}  // namespace

TEST_CASE("the kernels that understand pictures give the same numbers in every set, and the right ones") {
  Pcg32 random(7);
  for (std::int32_t width = 1; width <= 420; width += width < 200 ? 1 : 11) {
    CAPTURE(width);
    const std::array<Row, 4> rows{random_row(random, width), random_row(random, width),
                                  random_row(random, width), random_row(random, width)};
    const GrayStretch rule{static_cast<std::int32_t>(random.below(200)),
                           static_cast<std::int32_t>(1 + random.below(255))};
    Row stretched, lone(rows[0].size());
    for (const std::uint8_t v : rows[0]) {
      const int n = (2 * 255 * (v - rule.black) + rule.span) / (2 * rule.span);
      stretched.push_back(static_cast<std::uint8_t>(v < rule.black ? 0 : std::clamp(n, 0, 255)));
    }
    GrainCount grain;
    for (std::size_t x = 1; x < rows[0].size(); ++x) {
      const bool between = rows[0][x] != 0 && rows[0][x] != 255;
      grain.pairs += between ? 1 : 0;
      grain.same += between && rows[0][x] == rows[0][x - 1] ? 1 : 0;
    }
    const bool any = plain_picture_row_kernels.find_lone(rows[0].data(), rows[1].data(), rows[2].data(),
                                                         width, 80, lone.data());
    for (const KernelSet& set : kernel_sets()) {
      CAPTURE(set.name);
      const PictureRowKernels& kernels = *set.picture_rows;
      Row out(rows[0].size());
      kernels.stretch(rows[0].data(), width, rule, out.data());
      CHECK(out == stretched);
      const auto other =
          std::find_if(rows[0].begin(), rows[0].end(), [&](auto v) { return v != rows[0][0]; });
      CHECK(kernels.count_even(rows[0].data(), width) == (other - rows[0].begin()) / 64 * 64);
      GrainCount count;
      kernels.count_grain(rows[0].data(), width, count);
      CHECK(count.pairs == grain.pairs);
      CHECK(count.same == grain.same);
      std::fill(out.begin(), out.end(), std::uint8_t{0});
      CHECK(kernels.find_lone(rows[0].data(), rows[1].data(), rows[2].data(), width, 80, out.data()) == any);
      if (any) CHECK(out == lone);
      const std::uint8_t* const four[] = {rows[0].data(), rows[1].data(), rows[2].data(), rows[3].data()};
      Row medians(rows[0].size() / 4);
      kernels.block_medians(four, width / 4, medians.data());
      for (std::size_t i = 0; i < medians.size(); ++i) {
        Row block;
        for (const Row& row : rows)
          for (std::size_t c = 0; c < 4; ++c) block.push_back(row[4 * i + c]);
        std::sort(block.begin(), block.end());
        REQUIRE(medians[i] == block[8]);
      }
    }
  }
}

TEST_CASE("every set of kernels counts the pixels that have the gray of the first, by 64") {
  for (const KernelSet& set : kernel_sets()) {
    for (std::int32_t width = 0; width <= 400; ++width) {
      for (std::int32_t other = 0; other <= width; other += 1 + other / 9) {
        Row row(static_cast<std::size_t>(width), 200);
        if (other < width) row[static_cast<std::size_t>(other)] = 201;
        CAPTURE(set.name, width, other);
        REQUIRE(set.picture_rows->count_even(row.data(), width) == other / 64 * 64);
      }
    }
  }
}

TEST_CASE("every gray is stretched by every rule as whole numbers say") {
  Row levels(256);
  for (std::size_t v = 0; v < 256; ++v) levels[v] = static_cast<std::uint8_t>(v);
  for (int span = 1; span <= 255; ++span) {
    Row out(256);
    plain_picture_row_kernels.stretch(levels.data(), 256, {0, span}, out.data());
    for (int v = 0; v < 256; ++v)
      REQUIRE(out[static_cast<std::size_t>(v)] == std::min(255, (2 * 255 * v + span) / (2 * span)));
  }
}

TEST_CASE("a lone dark pixel is found, and neither one at the border nor one of two") {
  for (const KernelSet& set : kernel_sets()) {
    const Row light(80, 200);
    Row here = light, lone(80);
    here[0] = here[40] = here[60] = here[61] = 100;
    REQUIRE(set.picture_rows->find_lone(light.data(), here.data(), light.data(), 80, 80, lone.data()));
    CHECK(std::count(lone.begin(), lone.end(), 1) == 1);
    CHECK(lone[40] == 1);
  }
}
