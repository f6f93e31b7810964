// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "canny/bounded_fill.hpp"
#include "canny/class_bits.hpp"
#include "canny/edge_words.hpp"
#include "canny/row_forms.hpp"
#include "canny/word_fill.hpp"
#include "support/catch.hpp"

using namespace row_forms;

namespace {

struct Filled {
  GrayImage edges;
  std::uint32_t reached = 0;
  std::uint32_t rows_swept = 0;
};

// Counts the rows that sweeps begin.
struct CountingBits : ClassBits {
  std::uint32_t* rows_swept = nullptr;
  std::int32_t next_pending(std::int32_t x, std::int32_t y) const noexcept {
    if (x == 0) ++*rows_swept;
    return ClassBits::next_pending(x, y);
  }
};

// 64 pixels at a time, in memory of its own.
Filled fill_by_words(const GrayImage& classes, std::size_t worklist) {
  const Size size = classes.size();
  const int words_in_row = (size.width + 63) / 64;
  Filled filled{GrayImage(size)};
  std::vector<std::uint32_t> waiting(worklist);
  std::vector<std::uint8_t> memory(EdgeWord::bytes * static_cast<std::size_t>(words_in_row * size.height));
  const EdgeWords words{memory.data(), static_cast<std::ptrdiff_t>(EdgeWord::bytes) * words_in_row,
                        words_in_row, size.height};
  const CannyRowKernels& kernels = plain_canny_row_kernels;
  std::vector<std::uint8_t> row(64 * static_cast<std::size_t>(words_in_row));
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      row[static_cast<std::size_t>(x)] = classes.at(x, y);
      if (classes.at(x, y) == strong_edge) --filled.reached;
    }
    kernels.pack_classes(row.data(), words.row(y), size.width);
  }
  WordFill fill(words, waiting);
  for (std::int32_t y = 0; y < words.height; ++y) fill.flow_down(y);
  fill.sweep_up(0, words.height);
  for (int y = 0; y < size.height; ++y) {
    filled.reached += kernels.spread_edges(words.row(y), filled.edges.view().row(y), size.width);
  }
  CHECK(filled.edges.guards_intact());
  return filled;
}

Filled fill_bits(const GrayImage& classes, std::size_t worklist) {
  const Size size = classes.size();
  Filled filled{GrayImage(size)};
  std::vector<std::uint32_t> waiting(worklist), words(detail::class_words_in_all(size));
  const CountingBits states{{words.data(), size.width}, &filled.rows_swept};
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) states.set(x, y, classes.at(x, y));
  }
  filled.reached = BoundedFill<CountingBits>::run(states, size, waiting);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      filled.edges.at(x, y) = ClassBits::get(states.row(y), x) == traced_edge ? 255 : 0;
    }
  }
  return filled;
}

void check_fill(const GrayImage& classes, std::size_t worklist) {
  GrayImage expected(classes.size());
  std::vector<std::uint32_t> stack(hysteresis_stack_size(classes.size()));
  const HysteresisResult result = hysteresis(classes.view(), stack, expected.view());
  const Filled words = fill_by_words(classes, worklist), bits = fill_bits(classes, worklist);
  CHECK(words.edges == expected);
  CHECK(bits.edges == expected);
  CHECK(words.reached == result.edges - result.strong);
  CHECK(bits.reached == words.reached);
  // The stated bound: each sweep but the last traces as many pixels as the worklist holds.
  const auto sweeps = 1 + result.edges / static_cast<std::uint32_t>(worklist);
  CHECK(bits.rows_swept <= sweeps * static_cast<std::uint32_t>(classes.size().height));
}

// One strong pixel in the middle of a square spiral of weak ones, with gaps of one pixel.
GrayImage spiral(int n) {
  GrayImage classes({n, n}, 2);
  int x = n / 2, y = n / 2, length = 2;
  classes.at(x, y) = strong_edge;
  for (int turn = 0;; ++turn) {
    const int dx = turn % 4 == 0 ? 1 : turn % 4 == 2 ? -1 : 0;
    const int dy = turn % 4 == 1 ? 1 : turn % 4 == 3 ? -1 : 0;
    for (int i = 0; i < length; ++i) {
      x += dx;
      y += dy;
      if (!classes.view().contains(x, y)) return classes;
      classes.at(x, y) = weak_edge;
    }
    if (turn % 2 == 1) length += 2;
  }
}

// A comb: corridors of weak pixels that hang on one upright, with crumbs between them.
GrayImage maze(Size size, Pcg32& random) {
  GrayImage classes(size, 2);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const bool corridor = y % 2 == 0 || x == (y / 2 % 2 == 0 ? 0 : size.width - 1);
      classes.at(x, y) = corridor || random.below(10) == 0 ? weak_edge : no_edge;
    }
  }
  classes.at(static_cast<int>(random.below(static_cast<std::uint32_t>(size.width))), size.height - 1) =
      strong_edge;
  return classes;
}

}  // namespace

TEST_CASE("the bounded flood fill reaches the same with any worklist: random classes") {
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    Pcg32 random(seed, 41);
    const Size size{1 + static_cast<int>(random.below(200)), 1 + static_cast<int>(random.below(40))};
    const std::uint32_t weak_percent = random.below(101), strong_per_mille = random.below(30);
    GrayImage classes(size);
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        classes.at(x, y) = random.below(100) < weak_percent ? weak_edge : no_edge;
        if (random.below(1000) < strong_per_mille) classes.at(x, y) = strong_edge;
      }
    }
    CAPTURE(seed, size.width, size.height, weak_percent, strong_per_mille);
    for (const std::size_t worklist : {1U, 2U, 3U, 8U, 100U, 5000U}) check_fill(classes, worklist);
  }
}

TEST_CASE("the bounded flood fill reaches the same with any worklist: spirals and mazes") {
  for (const int n : {3, 15, 16, 17, 33, 64, 65, 130}) {
    for (const std::size_t worklist : {1U, 2U, 5U, 1000U}) {
      CAPTURE(n, worklist);
      check_fill(spiral(n), worklist);
      Pcg32 random(static_cast<std::uint64_t>(n), 42);
      check_fill(maze({n, n + 3}, random), worklist);
    }
  }
}

TEST_CASE("a plane of weak pixels overflows the worklist, and one seed still takes it all") {
  for (const int x : {0, 20, 39}) {
    for (const int y : {0, 15, 29}) {
      GrayImage classes({40, 30}, 2, std::uint8_t{weak_edge});
      classes.at(x, y) = strong_edge;
      for (const std::size_t worklist : {1U, 4U, 64U}) {
        const Filled filled = fill_bits(classes, worklist);
        CHECK(filled.reached == 40 * 30 - 1);
        check_fill(classes, worklist);
      }
    }
  }
}
