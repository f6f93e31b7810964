// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "fit/free_cells.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "straightedge/random.hpp"
#include "support/catch.hpp"

using namespace straightedge;

namespace {

constexpr std::uint16_t taken = 0xFFFF;

/// A picture's cells of 4 pixels, most of them read, and their labels, most of them 0.
struct Frame {
  Size picture, size;
  std::vector<std::byte> memory;
  DepthCells cells;
  std::vector<std::uint16_t> labels;

  Frame(Pcg32& random, Size of_picture) : picture(of_picture), size(DepthCells::size_of(of_picture, 0)) {
    Arena measure = Arena::measure();
    cells.take(measure, picture);
    memory.resize(measure.used() + alignof(std::max_align_t));
    Arena arena(memory);
    cells.take(arena, picture);
    labels.resize(DepthCells::cell_count(size));
    for (std::size_t i = 0; i < labels.size(); ++i) {
      labels[i] = static_cast<std::uint16_t>(random.below(8) == 0 ? 1 + random.below(200) : 0);
      cells.counts()[i] =
          static_cast<std::uint8_t>(random.below(16) == 0 ? random.below(8) : 8 + random.below(9));
    }
  }
  std::size_t place(std::int32_t x, std::int32_t y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x);
  }
  bool is_free(std::int32_t x, std::int32_t y) const {
    return x >= 0 && y >= 0 && x < size.width && y < size.height && labels[place(x, y)] == 0 &&
           cells.counts()[place(x, y)] >= 8;
  }
  bool is_middle(std::int32_t x, std::int32_t y) const {
    return is_free(x, y) && is_free(x - 1, y) && is_free(x + 1, y) && is_free(x, y - 1) && is_free(x, y + 1);
  }
  bool is_near_middle(std::int32_t x, std::int32_t y) const {
    bool near = false;
    for (std::int32_t j = -2; j <= 2; ++j)
      for (std::int32_t i = -2; i <= 2; ++i) near = near || is_middle(x + i, y + j);
    return near;
  }
};

}  // namespace

TEST_CASE("cells are free around those that are free with their four neighbours, and so are their pixels") {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    CAPTURE(seed);
    Pcg32 random(seed);
    const Size picture{1 + static_cast<std::int32_t>(random.below(200)),
                       1 + static_cast<std::int32_t>(random.below(60))};
    const Frame frame(random, picture);
    const std::ptrdiff_t apart = picture.width + static_cast<std::ptrdiff_t>(random.below(5));
    std::vector<std::uint16_t> pixels(static_cast<std::size_t>(apart * picture.height), 4711);
    const ImageView<std::uint16_t> labels(pixels.data(), picture, 2 * apart);
    const std::uint32_t found =
        detail::free_cells(frame.cells, frame.labels, detail::marks_in(labels, frame.cells));
    detail::spread_marks(4, labels);
    std::uint32_t middles = 0;
    for (std::int32_t y = 0; y < frame.size.height; ++y)
      for (std::int32_t x = 0; x < frame.size.width; ++x) middles += frame.is_middle(x, y) ? 1U : 0U;
    CHECK(found == middles);
    for (std::int32_t y = 0; y < picture.height; ++y) {
      for (std::int32_t x = 0; x < picture.width; ++x) {
        const bool free = frame.labels[frame.place(x / 4, y / 4)] == 0 && frame.is_near_middle(x / 4, y / 4);
        REQUIRE(labels.at(x, y) == (free ? 0 : taken));
      }
      for (std::ptrdiff_t x = picture.width; x < apart; ++x)
        REQUIRE(pixels[static_cast<std::size_t>(y * apart + x)] == 4711);
    }
  }
}
