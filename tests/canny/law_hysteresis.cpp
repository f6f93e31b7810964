// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "canny/stages.hpp"
#include "support/catch.hpp"

using namespace stages;

namespace {

bool touches_edge(const GrayImage& edges, int x, int y) {
  for (int v = y - 1; v <= y + 1; ++v) {
    for (int u = x - 1; u <= x + 1; ++u) {
      if (edges.view().contains(u, v) && edges.at(u, v) == 255) return true;
    }
  }
  return false;
}

// Sweeps over the whole image until nothing changes.
GrayImage by_sweeps(const GrayImage& classes) {
  const Size size = classes.size();
  GrayImage edges(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) edges.at(x, y) = classes.at(x, y) == strong_edge ? 255 : 0;
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        if (classes.at(x, y) == no_edge || edges.at(x, y) == 255 || !touches_edge(edges, x, y)) continue;
        edges.at(x, y) = 255;
        changed = true;
      }
    }
  }
  return edges;
}

bool is_subset(const GrayImage& part, const GrayImage& whole) {
  for (int y = 0; y < part.size().height; ++y) {
    for (int x = 0; x < part.size().width; ++x) {
      if (part.at(x, y) > whole.at(x, y)) return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("the flood fill reaches what sweeps reach") {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Pcg32 random(seed, 2);
    const Size size{1 + static_cast<int>(random.below(40)), 1 + static_cast<int>(random.below(30))};
    const std::uint32_t weak_percent = random.below(70), strong_per_mille = random.below(40);
    GrayImage classes(size);
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        classes.at(x, y) = random.below(100) < weak_percent ? weak_edge : no_edge;
        if (random.below(1000) < strong_per_mille) classes.at(x, y) = strong_edge;
      }
    }
    std::vector<std::uint32_t> stack(hysteresis_stack_size(size));
    GrayImage edges(size, 2);
    REQUIRE(hysteresis(classes.view(), stack, edges.view()).status == Status::ok);
    CAPTURE(seed, size.width, size.height, weak_percent, strong_per_mille);
    REQUIRE(edges == by_sweeps(classes));
    REQUIRE(edges.guards_intact());
  }
}

TEST_CASE("higher thresholds never add an edge") {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Pcg32 random(seed, 3);
    const GrayImage gray = support::random_scene({64, 48}, random, 1 + random.below(40));
    const double low = random.below(200), high = low + random.below(300);
    const auto find = [&](double a, double b) { return edges_of(gray, {.sigma = 1, .low = a, .high = b}); };
    const GrayImage edges = find(low, high);
    CAPTURE(seed, low, high);
    CHECK(is_subset(find(low, high + 50), edges));
    CHECK(is_subset(find(low + (high - low) / 2, high), edges));
  }
}
