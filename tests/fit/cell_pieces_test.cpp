// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "fit/cell_pieces.hpp"

#include <cstdint>
#include <vector>

#include "straightedge/random.hpp"
#include "support/catch.hpp"

using namespace straightedge;

namespace {

/// Blobs of few labels: pieces that wind about one another.
std::vector<std::uint16_t> labels_by_chance(Pcg32& random, Size size) {
  std::vector<std::uint16_t> labels(static_cast<std::size_t>(size.width * size.height));
  const std::uint32_t change = 2 + random.below(8);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const std::size_t width = static_cast<std::size_t>(size.width);
    const std::uint16_t like = i % width > 0 && random.below(2) == 0 ? labels[i - 1]
                               : i >= width                          ? labels[i - width]
                                                                     : std::uint16_t{1};
    labels[i] = random.below(change) == 0 ? static_cast<std::uint16_t>(random.below(4)) : like;
  }
  return labels;
}

/// The cells of the piece of each cell, by flooding.
std::vector<std::int32_t> flooded(const std::vector<std::uint16_t>& labels, Size size) {
  std::vector<std::int32_t> cells(labels.size());
  for (std::size_t seed = 0; seed < labels.size(); ++seed) {
    if (labels[seed] == 0 || cells[seed] != 0) continue;
    std::vector<std::size_t> piece{seed};
    cells[seed] = -1;
    const auto visit = [&](std::size_t i) {
      if (labels[i] != labels[seed] || cells[i] != 0) return;
      cells[i] = -1;
      piece.push_back(i);
    };
    const auto width = static_cast<std::size_t>(size.width);
    for (std::size_t k = 0; k < piece.size(); ++k) {
      const std::size_t i = piece[k];
      if (i % width > 0) visit(i - 1);
      if (i % width + 1 < width) visit(i + 1);
      if (i >= width) visit(i - width);
      if (i + width < labels.size()) visit(i + width);
    }
    for (const std::size_t i : piece) cells[i] = static_cast<std::int32_t>(piece.size());
  }
  return cells;
}

}  // namespace

TEST_CASE("rows of any length are one piece") {
  const Size size{200000, 2};
  const std::vector<std::uint16_t> labels(400000, 7);
  std::vector<std::uint16_t> length(labels.size());
  std::vector<std::int32_t> of_run(labels.size());
  const detail::CellPieces pieces{size, labels, length, of_run};
  pieces.find();
  std::int32_t cells = 0;
  pieces.for_runs([&](std::int32_t begin, std::int32_t end, std::uint16_t) {
    CHECK(pieces.cells_of(begin) == 400000);
    cells += end - begin;
  });
  CHECK(cells == 400000);
}

TEST_CASE("runs know the size of their piece, as flooding finds it") {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    INFO("seed " << seed);
    Pcg32 random(seed, 1);
    const Size size{1 + static_cast<std::int32_t>(random.below(60)),
                    1 + static_cast<std::int32_t>(random.below(40))};
    const std::vector<std::uint16_t> labels = labels_by_chance(random, size);
    const std::vector<std::int32_t> expected = flooded(labels, size);
    std::vector<std::uint16_t> length(labels.size());
    std::vector<std::int32_t> of_run(labels.size());
    const detail::CellPieces pieces{size, labels, length, of_run};
    pieces.find();
    std::vector<std::int32_t> found(labels.size());
    pieces.for_runs([&](std::int32_t begin, std::int32_t end, std::uint16_t label) {
      REQUIRE(begin / size.width == (end - 1) / size.width);
      for (std::int32_t i = begin; i < end; ++i) {
        REQUIRE(labels[static_cast<std::size_t>(i)] == label);
        found[static_cast<std::size_t>(i)] = pieces.cells_of(begin);
      }
    });
    CHECK(found == expected);
  }
}
