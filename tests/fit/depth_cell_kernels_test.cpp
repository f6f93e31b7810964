// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "kernel_testing.hpp"
#include "straightedge/depth_cells.hpp"
#include "straightedge/depth_kernels.hpp"
#include "straightedge/random.hpp"
#include "support/catch.hpp"
#include "support/drawing.hpp"

using namespace straightedge;
using support::uniform;
using test::for_sets_and_seeds;

namespace {

constexpr std::ptrdiff_t apart = 450;

using Numbers = std::vector<float>;

bool same_bits(const Numbers& a, const Numbers& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::bit_cast<std::uint32_t>(a[i]) != std::bit_cast<std::uint32_t>(b[i])) return false;
  }
  return a.size() == b.size();
}

/// Some of them no readings.
Numbers pixels_by_chance(Pcg32& random, std::size_t count) {
  constexpr float odd[] = {0, -0.0F, -1, -std::numeric_limits<float>::infinity(),
                           std::numeric_limits<float>::quiet_NaN()};
  const std::uint32_t holes = random.below(4) * 30;
  Numbers pixels(count);
  for (float& q : pixels) {
    q = random.below(100) < holes ? odd[random.below(5)] : static_cast<float>(uniform(random, 0.2, 2));
  }
  return pixels;
}

Numbers room() {
  return Numbers(static_cast<std::size_t>(apart * DepthCellRows::kinds), 4711.0F);
}

/// Cells near surface 0 or 1 or far from all, some of them empty.
Numbers cells_by_chance(Pcg32& random) {
  Numbers cells = room();
  for (std::size_t i = 0; i < static_cast<std::size_t>(apart); ++i) {
    const bool empty = random.below(6) == 0;
    const double off = random.below(3) == 0 ? 0.1 : 0.002;
    const auto number = [&](std::size_t kind, double value) {
      cells[kind * static_cast<std::size_t>(apart) + i] = empty ? 0.0F : static_cast<float>(value);
    };
    number(0, 1 + random.below(16));
    number(1, uniform(random, -320, 320));
    number(2, uniform(random, -240, 240));
    number(3, 0.5 + off * uniform(random, -1, 1));
    number(4, uniform(random, 10, 20));
    number(5, uniform(random, -1, 1));
    number(6, uniform(random, 10, 20));
    number(7, 1e-3 * uniform(random, -1, 1));
    number(8, 1e-3 * uniform(random, -1, 1));
    number(9, 1e-4 * uniform(random, 0, 1));
  }
  return cells;
}

struct Surfaces {
  static constexpr std::int32_t most = 40;
  std::array<std::array<float, most>, 6> of{};
  std::int32_t count;

  explicit Surfaces(Pcg32& random) : count(1 + static_cast<std::int32_t>(random.below(most))) {
    const double sizes[] = {0.004, 1e-6, 1e-6, 1e-9, 1e-9, 1e-9};
    for (std::size_t c = 0; c < of.size(); ++c) {
      for (float& x : of[c]) x = static_cast<float>((c == 0 ? 0.5 : 0) + sizes[c] * uniform(random, -1, 1));
    }
  }
  DepthSurfaces view() {
    return {of[0].data(), of[1].data(), of[2].data(), of[3].data(), of[4].data(), of[5].data()};
  }
  DepthSurface at(std::size_t k) const {
    return {of[0][k], of[1][k], of[2][k], of[3][k], of[4][k], of[5][k]};
  }
};

DepthCellTask task_by_chance(Pcg32& random, Numbers& cells, std::int32_t planes) {
  DepthCellTask task;
  task.at = {cells.data() + random.below(100), apart};
  task.open = random.next() & 0xFFFF & (random.below(2) == 0 ? 0xFFFFU : random.next());
  task.least = static_cast<float>(random.below(6));
  task.planes = random.below(3) == 0 ? 0 : planes;
  task.noise = random.below(4) == 0 ? 0.0F : 1e-3F;
  task.noise_of_square = 4e-3F;
  task.pure_of_asked = 4;
  task.pure = 2;
  while (task.asked < static_cast<std::int32_t>(random.below(5))) {
    task.plane[task.asked] = static_cast<std::uint16_t>(random.below(static_cast<std::uint32_t>(planes)));
    task.of[task.asked++] = static_cast<std::uint16_t>(random.next());
  }
  if (task.asked > 0) task.given = task.of[0] & task.open & random.next();
  for (std::int32_t i = 1; i < task.asked; ++i) {
    task.of[i] = static_cast<std::uint16_t>(task.of[i] & ~task.given);
  }
  return task;
}

bool is_set(std::uint32_t bits, std::uint32_t i) {
  return (bits >> i & 1U) != 0;
}

/// Squared residuals from the cell's own best plane, below 0 where its readings do not settle one.
double roughness(const DepthCell& cell) {
  const auto number = [](float x) { return static_cast<double>(x); };
  const double uu = number(cell.uu), uv = number(cell.uv), vv = number(cell.vv);
  const double uq = number(cell.uq), vq = number(cell.vq), determinant = uu * vv - uv * uv;
  if (determinant <= uu * vv / 64) return -1;
  return number(cell.qq) - (uq * (uq * vv - vq * uv) + vq * (vq * uu - uq * uv)) / determinant;
}

/// Step by step, for cell i; margins of rounding left out by the caller.
std::uint16_t expected_label(const DepthCellTask& task, const Surfaces& surfaces, std::uint32_t i,
                             double& doubt) {
  const auto number = [&](std::ptrdiff_t kind) { return task.at.first[kind * apart + i]; };
  const DepthCell cell{number(0), number(1), number(2), number(3), number(4),
                       number(5), number(6), number(7), number(8), number(9)};
  doubt = 1;
  if (!is_set(task.open, i) || cell.n < task.least) return 0;
  const float noise = std::max(task.noise, task.noise_of_square * cell.q * cell.q);
  const double unit = static_cast<double>(cell.n * noise * noise);
  double best = 1e30;
  std::uint16_t label = 0;
  const auto offer = [&](std::size_t k) {
    const auto found = static_cast<double>(squared_residuals(cell, surfaces.at(k)));
    doubt = std::min(doubt, std::abs(found - best) / (found + 1e-12));
    if (!(found < best)) return;
    best = found;
    label = static_cast<std::uint16_t>(k + 1);
  };
  for (std::int32_t a = 0; a < task.asked; ++a) {
    if (is_set(task.of[a], i)) offer(task.plane[a]);
  }
  doubt = std::min(doubt, std::abs(best - static_cast<double>(task.pure_of_asked) * unit) / (unit + 1e-12));
  if (is_set(task.given, i) || best < static_cast<double>(task.pure_of_asked) * unit) return label;
  if (task.planes == 0) {
    const double limit = static_cast<double>(task.pure_of_asked) * unit;
    doubt = std::min(doubt, std::abs(roughness(cell) - limit) / (unit + 1e-12));
    return roughness(cell) < limit ? DepthCellPlanes::undecided : std::uint16_t{0};
  }
  for (std::size_t k = 0; k < static_cast<std::size_t>(task.planes); ++k) {
    if (label != k + 1) offer(k);
  }
  doubt = std::min(doubt, std::abs(best - static_cast<double>(task.pure) * unit) / (unit + 1e-12));
  return best < static_cast<double>(task.pure) * unit ? label : std::uint16_t{0};
}

}  // namespace

TEST_CASE("every set of kernels makes cells as the plain one, and counts their readings") {
  for_sets_and_seeds(400, [](const DepthKernels& kernels, Pcg32& random, std::uint64_t) {
    constexpr std::ptrdiff_t stride = 403;
    const std::int32_t side = 4 << random.below(3);
    const std::size_t count = 1 + random.below(static_cast<std::uint32_t>(400 / side));
    const std::vector<float> rows = pixels_by_chance(random, static_cast<std::size_t>(side * stride));
    Numbers expected = room(), found = room();
    std::vector<std::uint8_t> expected_counts(count + 2, 77), counts = expected_counts;
    const auto build = [&](const DepthKernels& by, Numbers& cells, std::vector<std::uint8_t>& readings) {
      by.build_cells({rows.data() + 3, stride}, side, static_cast<std::int32_t>(count), -320, 7.5,
                     {cells.data() + 1, apart}, readings.data() + 1);
    };
    build(plain_depth_kernels, expected, expected_counts);
    build(kernels, found, counts);
    CHECK(same_bits(found, expected));
    CHECK(counts == expected_counts);
    CHECK(found[0] == 4711);
    CHECK(found[count + 1] == 4711);
    CHECK(counts.front() == 77);
    CHECK(counts.back() == 77);
    for (std::size_t i = 0; i < count; ++i) {
      std::int32_t readings = 0;
      for (std::ptrdiff_t y = 0; y < side; ++y) {
        const float* row = rows.data() + 3 + y * stride + static_cast<std::ptrdiff_t>(i) * side;
        readings += static_cast<std::int32_t>(std::count_if(row, row + side, [](float q) { return q > 0; }));
      }
      REQUIRE(found[i + 1] == static_cast<float>(readings));
      REQUIRE(counts[i + 1] == std::min(readings, 255));
    }
  });
}

TEST_CASE("every set of kernels joins cells as the plain one, and no reading is lost") {
  for_sets_and_seeds(100, [](const DepthKernels& kernels, Pcg32& random, std::uint64_t count) {
    Numbers cells = cells_by_chance(random);
    Numbers expected = room(), found = room();
    const auto made = static_cast<std::int32_t>(count);
    const auto below = static_cast<std::ptrdiff_t>(2 * count + random.below(3));
    plain_depth_kernels.join_cells({cells.data(), apart}, below, made, {expected.data(), apart});
    kernels.join_cells({cells.data(), apart}, below, made, {found.data(), apart});
    CHECK(same_bits(found, expected));
    CHECK(found[count] == 4711);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t under = 2 * i + static_cast<std::size_t>(below);
      REQUIRE(found[i] == cells[2 * i] + cells[2 * i + 1] + cells[under] + cells[under + 1]);
    }
  });
}

TEST_CASE("every set of kernels marks the cells that are full and fit their plane, and no others") {
  for_sets_and_seeds(300, [](const DepthKernels& kernels, Pcg32& random, std::uint64_t) {
    Numbers cells = cells_by_chance(random);
    Surfaces surfaces(random);
    DepthWholeCells task{{cells.data() + random.below(100), apart}};
    task.cells = 1 + static_cast<std::int32_t>(random.below(200));
    task.readings = 16;
    task.noise = random.below(4) == 0 ? 0.0F : 1e-3F;
    task.noise_of_square = 4e-3F;
    task.most = static_cast<float>(uniform(random, 1, 10));
    for (std::int32_t i = 0; i < task.cells; ++i) {
      if (random.below(2) == 0) task.at.first[i] = task.readings;
    }
    const auto labels_by_chance = [&] {
      std::vector<std::uint16_t> labels(static_cast<std::size_t>(task.cells) + 1);
      for (std::uint16_t& label : labels)
        label = static_cast<std::uint16_t>(random.below(static_cast<std::uint32_t>(surfaces.count) + 1));
      return labels;
    };
    const std::vector<std::uint16_t> own = labels_by_chance();
    task.own = own.data();
    std::vector<std::uint16_t> before = labels_by_chance();
    for (std::uint16_t& label : before) {
      if (random.below(4) == 0) label = DepthWholeCells::border;
    }
    std::vector<std::uint16_t> plain = before, labels = before;
    kernels.mark_whole(task, surfaces.view(), labels.data());
    plain_depth_kernels.mark_whole(task, surfaces.view(), plain.data());
    CHECK(labels == plain);
    CHECK(labels.back() == before.back());
    for (std::size_t i = 0; i + 1 < labels.size(); ++i) {
      const bool at_border = before[i] == DepthWholeCells::border;
      const std::uint16_t of = at_border ? own[i] : before[i];
      const auto at = static_cast<std::ptrdiff_t>(i);
      const DepthCell cell = cell_at({task.at.first + at, apart});
      if (of == 0 || cell.n != task.readings) {
        REQUIRE(labels[i] == before[i]);
        continue;
      }
      const float noise = std::max(task.noise, task.noise_of_square * cell.q * cell.q);
      const double limit = static_cast<double>(task.most * cell.n * noise * noise);
      const auto squares = static_cast<double>(squared_residuals(cell, surfaces.at(of - 1U)));
      const int marked = at_border ? DepthWholeCells::inner_border : before[i] | DepthWholeCells::mark;
      if (squares < limit * (1 - 1e-4)) REQUIRE(labels[i] == marked);
      if (squares > limit * (1 + 1e-4)) REQUIRE(labels[i] == before[i]);
    }
  });
}

TEST_CASE("every set of kernels chooses planes for cells as the plain one, which goes step by step") {
  std::size_t checked = 0, labelled = 0;
  for_sets_and_seeds(2000, [&](const DepthKernels& kernels, Pcg32& random, std::uint64_t) {
    Numbers cells = cells_by_chance(random);
    Surfaces surfaces(random);
    const DepthCellTask task = task_by_chance(random, cells, surfaces.count);
    DepthCellPlanes expected{}, found{};
    plain_depth_kernels.choose_planes(task, surfaces.view(), expected);
    kernels.choose_planes(task, surfaces.view(), found);
    for (std::uint32_t i = 0; i < 16; ++i) {
      CHECK(found.label[i] == expected.label[i]);
      if (found.label[i] != 0) {
        CHECK(std::bit_cast<std::uint32_t>(found.mean[i]) == std::bit_cast<std::uint32_t>(expected.mean[i]));
      }
      double doubt = 0;
      const std::uint16_t label = expected_label(task, surfaces, i, doubt);
      if (doubt < 1e-3) continue;
      REQUIRE(expected.label[i] == label);
      ++checked;
      labelled += label != 0 ? 1U : 0U;
    }
  });
  CHECK(labelled > checked / 20);
}
