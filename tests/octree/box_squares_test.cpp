// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// Distances from boxes of leaves in whole units, eight at a time, against doubles.
#include <algorithm>
#include <cmath>

#include "octree/near_groups.hpp"
#include "straightedge/random.hpp"
#include "support/catch.hpp"

using namespace straightedge;

namespace {

struct Box {
  unsigned char low[3], high[3];
};

/// Sides from nothing to all of a group.
Box random_box(Pcg32& random) {
  Box box;
  for (int axis = 0; axis < 3; ++axis) {
    const std::uint32_t a = random.below(256), b = random.below(256);
    box.low[axis] = static_cast<unsigned char>(std::min(a, b));
    box.high[axis] = static_cast<unsigned char>(std::max(a, b));
  }
  return box;
}

/// From a position to the box, along an axis; longer than `most` counts as `most`.
double gap(double at, const Box& box, int axis, double most) {
  return std::min(most, std::max({box.low[axis] - at, at - box.high[axis] - 1, 0.0}));
}

}  // namespace

TEST_CASE("squared distances of boxes are at most what they are, and less by less than a unit a side") {
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    INFO("seed " << seed);
    Pcg32 random(seed);
    Box boxes[8];
    unsigned char block[48];
    for (std::size_t lane = 0; lane < 8; ++lane) {
      boxes[lane] = random_box(random);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        block[8 * axis + lane] = boxes[lane].low[axis];
        block[8 * (axis + 3) + lane] = boxes[lane].high[axis];
      }
    }
    double at[3];
    for (double& a : at) a = random.below(513 * 1000) / 1000.0 - 128;
    const auto unit = [&](int axis) {
      return static_cast<std::int16_t>(static_cast<int>(at[axis] + 128) - 128);
    };
    const octree::Shorts8 squares = octree::BoxSquares(unit(0), unit(1), unit(2)).of(block);
    for (std::size_t lane = 0; lane < 8; ++lane) {
      INFO("lane " << lane);
      double most = 0, least = 0;
      for (int axis = 0; axis < 3; ++axis) {
        const double far = gap(at[axis], boxes[lane], axis, 147), near = std::max(0.0, far - 1);
        most += far * far;
        least += near * near;
      }
      const double square = squares[lane] + 32768;
      REQUIRE(square <= most);
      REQUIRE(square >= least);
      REQUIRE(squares[lane] <= octree::BoxSquares::limit_of(most));
    }
  }
}

TEST_CASE("limits of box squares do not overflow, and no leaf is within none") {
  using octree::BoxSquares;
  for (const double squared : {0.0, 0.5, 1.0, 65532.5, 65534.0, 1e9, 1e300, HUGE_VAL}) {
    INFO(squared);
    CHECK(BoxSquares::limit_of(squared) < BoxSquares::none);
    CHECK(BoxSquares::limit_of(squared) >= std::min(squared, 64827.0) - 32768);
  }
}
