// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "fit/label_squares.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

#include "straightedge/random.hpp"
#include "support/catch.hpp"

using namespace straightedge;
using detail::LabelSquare;
using detail::LabelSquares;

namespace {

constexpr std::uint16_t mark = 0x8000;

/// Cells of a picture without readings, and labels for the finest of them.
struct Cells {
  DepthCells cells;
  std::vector<std::byte> memory;
  std::vector<std::uint16_t> labels;

  Cells(Size picture, int finest) {
    Arena counting = Arena::measure();
    cells.take(counting, picture, finest);
    memory.resize(counting.used() + alignof(std::max_align_t));
    Arena arena(memory);
    cells.take(arena, picture, finest);
    labels.resize(DepthCells::cell_count(size()));
  }
  Size size() const { return cells.size(cells.finest()); }
  std::uint16_t& at(std::int32_t x, std::int32_t y) {
    return labels[static_cast<std::size_t>(y * size().width + x)];
  }
  std::vector<LabelSquare> squares(std::uint16_t wanted, bool in_pairs) {
    std::vector<LabelSquare> found;
    LabelSquares(cells, {labels.data(), size()}, wanted, in_pairs).for_each([&](const LabelSquare& square) {
      found.push_back(square);
    });
    return found;
  }
};

/// Rectangles of few labels, some of them marked.
void label_by_chance(Pcg32& random, Cells& c) {
  const Size size = c.size();
  for (int k = 0; k < 12; ++k) {
    const auto below = [&](std::int32_t end) {
      return static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(end)));
    };
    const std::int32_t left = below(size.width), top = below(size.height);
    const std::int32_t right = left + 1 + below(size.width - left),
                       bottom = top + 1 + below(size.height - top);
    const auto label = static_cast<std::uint16_t>(below(4) | (below(2) == 0 ? 0 : mark));
    for (std::int32_t y = top; y < bottom; ++y)
      for (std::int32_t x = left; x < right; ++x) c.at(x, y) = label == mark ? std::uint16_t{0} : label;
  }
}

/// By their definition: from the largest squares to the smallest, each cut where its labels differ.
struct ByDefinition {
  Cells& c;
  std::uint16_t wanted;
  bool in_pairs;
  std::vector<std::tuple<int, std::uint32_t, std::uint16_t, int>> found;

  void add(int level, std::int32_t x, std::int32_t y, std::uint16_t label, int second = 0) {
    const std::int32_t place = y * c.cells.size(level).width + x;
    if ((label & wanted) != 0) found.emplace_back(level, static_cast<std::uint32_t>(place), label, second);
  }
  bool same(std::int32_t x, std::int32_t y, std::int32_t side) {
    for (std::int32_t v = y; v < std::min(y + side, c.size().height); ++v)
      for (std::int32_t u = x; u < std::min(x + side, c.size().width); ++u)
        if (c.at(u, v) != c.at(x, y)) return false;
    return true;
  }
  void cut(std::int32_t x, std::int32_t y, int doublings) {
    const std::int32_t side = 1 << doublings;
    const int level = c.cells.finest() + doublings;
    if (x >= c.size().width || y >= c.size().height) return;
    if (level < DepthCells::levels && same(x, y, side)) return add(level, x / side, y / side, c.at(x, y));
    if (doublings == 2) {
      for (const std::int32_t dy : {0, 2})
        for (const std::int32_t dx : {0, 2}) cut(x + dx, y + dy, 1);
      return;
    }
    for (std::int32_t v = y; v < std::min(y + 2, c.size().height); ++v) {
      const bool two = x + 1 < c.size().width;
      const bool together = in_pairs && two && c.at(x, v) == c.at(x + 1, v);
      add(c.cells.finest(), x, v, c.at(x, v), together ? 1 : 0);
      if (two && !together) add(c.cells.finest(), x + 1, v, c.at(x + 1, v));
    }
  }
  void all() {
    for (std::int32_t y = 0; y < c.size().height; y += 4)
      for (std::int32_t x = 0; x < c.size().width; x += 4) cut(x, y, 2);
  }
};

}  // namespace

TEST_CASE("squares of one label are as large as their definition makes them, at every border") {
  Pcg32 random(5, 1);
  std::size_t larger = 0, pairs = 0;
  for (int k = 0; k < 400; ++k) {
    const int finest = k % 3;
    const auto side = static_cast<std::uint32_t>(DepthCells::side_of(finest));
    Cells c({static_cast<std::int32_t>(1 + random.below(20 * side)),
             static_cast<std::int32_t>(1 + random.below(14 * side))},
            finest);
    label_by_chance(random, c);
    const std::uint16_t wanted = k % 2 == 0 ? mark : std::uint16_t{0xFFFF};
    const bool in_pairs = k % 4 < 2;
    ByDefinition expected{c, wanted, in_pairs, {}};
    expected.all();
    const std::vector<LabelSquare> found = c.squares(wanted, in_pairs);
    REQUIRE(found.size() == expected.found.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      const LabelSquare& s = found[i];
      REQUIRE(std::tuple<int, std::uint32_t, std::uint16_t, int>(s.level, s.place, s.label, s.second) ==
              expected.found[i]);
      larger += s.level > finest ? 1 : 0;
      pairs += s.second;
    }
  }
  CHECK(larger > 1000);
  CHECK(pairs > 500);
}

TEST_CASE("a picture of one label has large squares alone, one without labels none") {
  Cells c({640, 480}, 0);
  CHECK(c.squares(0xFFFF, true).empty());
  for (std::uint16_t& label : c.labels) label = 3;
  const std::vector<LabelSquare> squares = c.squares(0xFFFF, true);
  CHECK(squares.size() == 40U * 30U);
  for (const LabelSquare& square : squares) REQUIRE(square.level == 2);
}
