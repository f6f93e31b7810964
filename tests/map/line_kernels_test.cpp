// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "map/picture_rows.hpp"
#include "map/sample.hpp"
#include "straightedge/edge_position.hpp"
#include "straightedge/host/image.hpp"
#include "straightedge/host/kernels.hpp"
#include "straightedge/random.hpp"
#include "support/catch.hpp"

using namespace straightedge;

namespace {

double between(Pcg32& random, double low, double high) {
  return low + (high - low) * random.below(1U << 30U) / (1U << 30U);
}

/// With sides from `shortest` on, and that many grays.
Image<std::uint8_t> random_picture(Pcg32& random, std::int32_t shortest, std::uint32_t grays) {
  const auto side = [&] { return shortest + static_cast<std::int32_t>(random.below(40)); };
  const std::int32_t width = side();
  Image<std::uint8_t> picture({width, side()});
  for (std::int32_t y = 0; y < picture.height(); ++y)
    for (std::int32_t x = 0; x < width; ++x)
      picture.at(x, y) = static_cast<std::uint8_t>(random.below(grays));
  return picture;
}

/// As many different shapes of an edge as five small numbers make, and large ones.
std::int32_t random_magnitude(Pcg32& random) {
  const std::uint32_t kind = random.below(8);
  if (kind == 0) return 0;
  return static_cast<std::int32_t>(random.below(kind < 6 ? 5 : 1U << 30U));
}

/// What edge_position says of a pixel with these magnitudes across its edge.
EdgePosition position_of(const EdgeBatch& batch, std::int32_t i) {
  Image<std::int16_t> dx(Size{5, 5}, batch.dx[i]), dy(Size{5, 5}, batch.dy[i]);
  Image<std::int32_t> magnitude(Size{5, 5});
  for (std::int32_t k = 0; k < EdgeBatch::around; ++k) {
    magnitude.at(k, 2) = batch.magnitude[k][i];
    if (std::abs(batch.dx[i]) < std::abs(batch.dy[i])) {
      magnitude.at(k, 2) = 0;
      magnitude.at(2, k) = batch.magnitude[k][i];
    }
  }
  if (std::abs(batch.dx[i]) < std::abs(batch.dy[i])) magnitude.at(2, 2) = batch.magnitude[2][i];
  EdgePosition edge = edge_position({dx, dy, magnitude}, 2, 2);
  edge.x += batch.x[i] - 2;
  edge.y += batch.y[i] - 2;
  return edge;
}

}  // namespace

TEST_CASE("every set of kernels places edge points where edge_position does") {
  Pcg32 random(11);
  const auto batch = std::make_unique<EdgeBatch>();
  for (std::int32_t count = 0; count <= EdgeBatch::room; count += count < 40 ? 1 : 24) {
    CAPTURE(count);
    batch->count = count;
    for (std::int32_t i = 0; i < count; ++i) {
      batch->x[i] = 2;  // so that adding the shift rounds as edge_position does
      batch->y[i] = 2;
      batch->dx[i] = static_cast<std::int16_t>(random.below(7) - 3);
      batch->dy[i] = static_cast<std::int16_t>(random.below(7) - 3);
      for (auto& magnitude : batch->magnitude) magnitude[i] = random_magnitude(random);
    }
    for (const KernelSet& set : kernel_sets()) {
      CAPTURE(set.name);
      set.picture_rows->edge_places(*batch);
      for (std::int32_t i = 0; i < count; ++i) {
        const EdgePosition expected = position_of(*batch, i);
        REQUIRE(batch->place_x[i] == expected.x);
        REQUIRE(batch->place_y[i] == expected.y);
        REQUIRE(batch->weight[i] == 1 / expected.variance);
      }
    }
  }
}

TEST_CASE("every set of kernels samples gray as one place after the other") {
  Pcg32 random(12);
  for (std::int32_t round = 0; round < 200; ++round) {
    CAPTURE(round);
    const Image<std::uint8_t> picture = random_picture(random, 2, 256);
    const Size size = picture.size();
    const GrayView view = picture;
    SampleWay way{.pixels = view.data, .stride = view.stride, .width = size.width, .height = size.height};
    way.x = between(random, -5, size.width + 5);
    way.y = between(random, -5, size.height + 5);
    way.step_x = between(random, -1, 1);
    way.step_y = round % 5 == 0 ? 0 : between(random, -1, 1);
    way.aside_x = between(random, -3, 3);
    if (round % 7 == 0) way = SampleWay{view.data, view.stride, size.width, size.height, 0, 1, 1, 0, 0, 0};
    std::vector<double> steps(static_cast<std::size_t>(round));
    for (std::size_t i = 0; i < steps.size(); ++i)
      steps[i] = round % 7 == 0 ? static_cast<double>(i) - 3 : between(random, -30, 30);
    for (const KernelSet& set : kernel_sets()) {
      CAPTURE(set.name);
      std::vector<double> gray(steps.size() + 1, -1);
      set.picture_rows->sample(way, steps.data(), round, gray.data());
      for (std::size_t i = 0; i < steps.size(); ++i)
        REQUIRE(gray[i] == sample(view, way.x + steps[i] * way.step_x + way.aside_x,
                                  way.y + steps[i] * way.step_y + way.aside_y));
      CHECK(gray.back() == -1);
    }
  }
}

TEST_CASE("every set of kernels reads the pixels that places lie in") {
  Pcg32 random(14);
  for (std::int32_t round = 0; round < 200; ++round) {
    CAPTURE(round);
    const Image<std::uint8_t> picture = random_picture(random, 1, 255);  // 255 is what lies outside
    const Size size = picture.size();
    const GrayView view = picture;
    const SampleWay way{.pixels = view.data,
                        .stride = view.stride,
                        .width = size.width,
                        .height = size.height,
                        .x = between(random, -5, size.width + 5),
                        .y = between(random, -5, size.height + 5),
                        .step_x = between(random, -1, 1),
                        .step_y = round % 5 == 0 ? 0 : between(random, -1, 1),
                        .aside_x = between(random, -3, 3),
                        .aside_y = between(random, -3, 3)};
    for (const KernelSet& set : kernel_sets()) {
      CAPTURE(set.name);
      std::vector<std::uint8_t> gray(static_cast<std::size_t>(round) + 1, 7);
      set.picture_rows->read_nearest(way, round, gray.data());
      for (std::int32_t i = 0; i < round; ++i) {
        const auto x = static_cast<std::int32_t>(std::floor(way.x + i * way.step_x + way.aside_x));
        const auto y = static_cast<std::int32_t>(std::floor(way.y + i * way.step_y + way.aside_y));
        const int expected = view.contains(x, y) ? view.at(x, y) : 255;
        REQUIRE(int{gray[static_cast<std::size_t>(i)]} == expected);
      }
      CHECK(gray.back() == 7);
    }
  }
}

TEST_CASE("every set of kernels finds the same points in a strip") {
  Pcg32 random(13);
  const auto expected = std::make_unique<StripBatch>(), batch = std::make_unique<StripBatch>();
  for (std::int32_t count = 0; count <= StripBatch::room; ++count) {
    CAPTURE(count);
    const StripRule rule{
        between(random, 0, 9), between(random, 0, 9), 0.6, -0.8, between(random, 0.5, 4), 0.9};
    expected->count = count;
    for (std::int32_t i = 0; i < count; ++i) {
      expected->x[i] = between(random, 0, 9);
      expected->y[i] = between(random, 0, 9);
      expected->dx[i] = static_cast<std::int32_t>(random.below(9)) - 2;
      expected->dy[i] = static_cast<std::int32_t>(random.below(9)) - 6;
      expected->weight[i] = between(random, 0.1, 16);
    }
    plain_picture_row_kernels.find_inside(rule, *expected);
    std::int64_t inside = 0;
    for (std::int32_t i = 0; i < count; ++i) {
      const double x = expected->x[i] - rule.px, y = expected->y[i] - rule.py, w = expected->weight[i];
      const double gx = expected->dx[i], gy = expected->dy[i];
      const double toward = gx * rule.nx + gy * rule.ny, off = x * rule.nx + y * rule.ny;
      const bool faces = toward > 0 && toward * toward >= 0.9 * 0.9 * (gx * gx + gy * gy);
      REQUIRE((expected->inside[i] != 0) == (faces && off <= rule.half_width && off >= -rule.half_width));
      REQUIRE(expected->along[i] == x * 0.8 + y * 0.6);
      REQUIRE(expected->weight_xy[i] == w * x * y);
      inside += expected->inside[i];
    }
    if (count == StripBatch::room) CHECK((inside > 5 && inside < count - 5));
    for (const KernelSet& set : kernel_sets()) {
      CAPTURE(set.name);
      *batch = *expected;
      std::fill_n(batch->inside, count, std::int64_t{-1});
      set.picture_rows->find_inside(rule, *batch);
      for (std::int32_t i = 0; i < count; ++i) {
        REQUIRE(batch->inside[i] == expected->inside[i]);
        REQUIRE(batch->along[i] == expected->along[i]);
        REQUIRE(batch->weight_x[i] == expected->weight_x[i]);
        REQUIRE(batch->weight_y[i] == expected->weight_y[i]);
        REQUIRE(batch->weight_xx[i] == expected->weight_xx[i]);
        REQUIRE(batch->weight_xy[i] == expected->weight_xy[i]);
        REQUIRE(batch->weight_yy[i] == expected->weight_yy[i]);
      }
    }
  }
}
