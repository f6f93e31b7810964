// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "map/picture.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <utility>
#include <vector>

#include "map/block_medians.hpp"

namespace straightedge {
namespace {

using Histogram = std::array<std::int64_t, 256>;

// ROS's usual threshold: what is darker than 35 % of white is wall. Ground is never that dark.
constexpr int darkest_ground = 90;
// A level is ground when this share of all pixels lies around it.
constexpr double ground_share = 0.06;
constexpr int level_reach = 12;
constexpr int even_reach = 20;
constexpr std::int32_t block = 4;
constexpr int soft_levels = 12;
constexpr int wide_enough = 250;  // levels between black and ground; such a picture need not be stretched
// A lone dark pixel is darker than all its neighbours by this much; specks lie evenly when a tenth of all
// places has at least this share of the usual number.
constexpr int lone_contrast = 80;
constexpr double speckled_evenness = 0.4;

/// Counts grays. Most of a drawn picture is even: pixels of one gray are counted together. Tables in turns:
/// equal neighbours need not wait for one another.
class GrayCounts {
 public:
  explicit GrayCounts(const PictureRowKernels& kernels) : kernels_(kernels) {}

  void add(const std::uint8_t* row, std::int32_t count) {
    constexpr std::int32_t step = 64;
    std::int32_t x = 0;
    while (x + step <= count) {
      const std::int32_t even = kernels_.count_even(row + x, count - x);
      tables_[0][row[x]] += static_cast<std::uint32_t>(even);
      x += even;
      if (x + step > count) break;
      add_eights(row + x, step);
      x += step;
    }
    const std::int32_t eights = (count - x) / 8 * 8;
    add_eights(row + x, eights);
    for (x += eights; x < count; ++x) ++tables_[0][row[x]];
  }

  Histogram histogram(std::int64_t times) const {
    Histogram sums{};
    for (std::size_t v = 0; v < 256; ++v)
      for (const auto& table : tables_) sums[v] += times * table[v];
    return sums;
  }

 private:
  void add_eights(const std::uint8_t* pixels, std::int32_t count) {
    for (std::int32_t i = 0; i < count; i += 8, pixels += 8) {
      std::uint64_t word = 0;
      std::memcpy(&word, pixels, sizeof word);
      if (word == 0x0101010101010101U * pixels[0]) {
        tables_[static_cast<std::size_t>(i / 8 % 4)][pixels[0]] += 8;
      } else {
        for (std::size_t k = 0; k < 8; ++k) ++tables_[k % 4][pixels[k]];
      }
    }
  }

  const PictureRowKernels& kernels_;
  std::array<std::array<std::uint32_t, 256>, 4> tables_{};
};

/// Rows of blocks from one that is counted to the next: of a large picture half of them tell.
std::int32_t rows_apart(GrayView gray) {
  constexpr std::int32_t large = 64 * block;
  return (gray.height < large ? 1 : 2) * block;
}

Histogram histogram_of(GrayView gray, const PictureRowKernels& kernels) {
  GrayCounts counts(kernels);
  for (std::int32_t top = 0; top < gray.height; top += rows_apart(gray)) {
    const std::int32_t bottom = std::min(top + block, gray.height);
    for (std::int32_t y = top; y < bottom; ++y) counts.add(gray.row(y), gray.width);
  }
  return counts.histogram(1);
}

/// Histogram of the medians of 4x4 blocks, scaled to the number of pixels: grain and specks vanish, edges do
/// not make levels of their own, even areas stay.
Histogram block_histogram(GrayView gray, const PictureRowKernels& kernels) {
  GrayCounts counts(kernels);
  const Size side{std::min(block, gray.width), std::min(block, gray.height)};
  std::vector<std::uint8_t> medians(static_cast<std::size_t>(gray.width / side.width));
  for (std::int32_t y = 0; y + side.height <= gray.height; y += rows_apart(gray)) {
    block_medians(gray, y, side, kernels, medians);
    counts.add(medians.data(), static_cast<std::int32_t>(medians.size()));
  }
  return counts.histogram(std::int64_t{side.width} * side.height);
}

std::int64_t mass_between(const Histogram& histogram, int from, int to) {
  std::int64_t sum = 0;
  for (int v = std::max(from, 0); v <= std::min(to, 255); ++v) sum += histogram[static_cast<std::size_t>(v)];
  return sum;
}

/// The levels with much area around them, darkest first: tops of the histogram smoothed over a few levels.
std::vector<int> ground_levels(const Histogram& histogram, int from, std::int64_t pixels) {
  std::vector<int> levels;
  for (int v = from; v < 256; ++v) {
    const std::int64_t here = mass_between(histogram, v - 3, v + 3);
    const std::int64_t around = mass_between(histogram, v - level_reach, v + level_reach);
    if (static_cast<double>(around) < ground_share * static_cast<double>(pixels)) continue;
    bool top = here > 0;
    for (int w = std::max(from, v - level_reach); w <= std::min(255, v + level_reach) && top; ++w) {
      const std::int64_t there = mass_between(histogram, w - 3, w + 3);
      top = there < here || (there == here && w >= v);
    }
    if (!top) continue;
    // The window's top says where about; the fullest level there is the one.
    const auto from_here = histogram.begin() + std::max(v - level_reach / 2, 0);
    const auto to_here = histogram.begin() + std::min(v + level_reach / 2, 255) + 1;
    levels.push_back(static_cast<int>(std::max_element(from_here, to_here) - histogram.begin()));
  }
  return levels;
}

/// Share of the area that lies around the two levels which have most of it.
double evenness(const Histogram& histogram, const std::vector<int>& grounds, std::int64_t pixels) {
  std::int64_t best = 0;
  for (const int a : grounds) {
    const std::int64_t first = mass_between(histogram, a - even_reach, a + even_reach);
    best = std::max(best, first);
    for (const int b : grounds) {
      if (b <= a) continue;
      const int from = std::max(b - even_reach, a + even_reach + 1);
      best = std::max(best, first + mass_between(histogram, from, b + even_reach));
    }
  }
  return static_cast<double>(best) / static_cast<double>(pixels);
}

/// A map has even ground, nearly all of its area; some of it is light, and a little is dark: the walls.
bool looks_like_map(const Histogram& histogram, const Histogram& blocks, const std::vector<int>& grounds,
                    std::int64_t pixels) {
  const double light = static_cast<double>(mass_between(histogram, 200, 255)) / static_cast<double>(pixels);
  const double dark =
      static_cast<double>(mass_between(histogram, 0, darkest_ground - 1)) / static_cast<double>(pixels);
  return evenness(blocks, grounds, pixels) >= 0.75 && light >= 0.05 && dark <= 0.3;
}

int darkest_level(const Histogram& histogram, std::int64_t pixels) {
  std::int64_t sum = 0;
  for (int v = 0; v < 256; ++v) {
    sum += histogram[static_cast<std::size_t>(v)];
    if (static_cast<double>(sum) >= 0.001 * static_cast<double>(pixels)) return v;
  }
  return 0;
}

void stretch(GrayView gray, const GrayStretch& rule, const PictureRowKernels& kernels,
             Image<std::uint8_t>& out) {
  if (out.size() != gray.size()) out = Image<std::uint8_t>::for_overwrite(gray.size());
  for (std::int32_t y = 0; y < gray.height; ++y)
    kernels.stretch(gray.row(y), gray.width, rule, out.view().row(y));
}

/// Whether gray, where it is neither black nor white, changes from pixel to pixel nearly everywhere. Every
/// second row tells, as long as those to come can still make a difference.
bool is_grainy(GrayView gray, const PictureRowKernels& kernels) {
  const std::int64_t pixels = std::int64_t{gray.width} * gray.height;
  GrainCount count;
  for (std::int32_t y = 0; y < gray.height; y += 2) {
    const std::int64_t most = count.pairs + std::int64_t{(gray.height - y + 1) / 2} * (gray.width - 1);
    if (count.same * 3 >= most || most * 20 <= pixels) return false;
    kernels.count_grain(gray.row(y), gray.width, count);
  }
  return count.same * 3 < count.pairs && count.pairs * 20 > pixels;
}

/// Whether lone dark pixels lie all over the picture, as a scanner's or a radio's specks do; clutter in a
/// building lies in heaps. Where more than a tenth of all cells have none, they do not lie all over.
bool is_speckled(GrayView gray, const PictureRowKernels& kernels) {
  constexpr std::int32_t cells = 8;
  std::array<int, cells * cells> specks{};
  constexpr std::int64_t tenth_cell = cells * cells / 10;
  std::vector<std::uint8_t> lone(static_cast<std::size_t>(gray.width));
  for (std::int32_t y = 1; y + 1 < gray.height; ++y) {
    const std::int32_t row = y * cells / gray.height * cells;
    const bool first_of_cells = (y - 1) * cells / gray.height * cells != row;
    if (first_of_cells && std::count(specks.begin(), specks.begin() + row, 0) > tenth_cell) return false;
    if (!kernels.find_lone(gray.row(y - 1), gray.row(y), gray.row(y + 1), gray.width, lone_contrast,
                           lone.data()))
      continue;
    for (auto at = std::find(lone.begin(), lone.end(), 1); at != lone.end();
         at = std::find(at + 1, lone.end(), 1)) {
      const auto x = static_cast<std::int32_t>(at - lone.begin());
      ++specks[static_cast<std::size_t>(row + x * cells / gray.width)];
    }
  }
  std::sort(specks.begin(), specks.end());
  const int tenth = specks[tenth_cell], median = specks[specks.size() / 2];
  return median >= 2 && tenth >= speckled_evenness * median;
}

/// Whether the picture has no gray between wall and ground, as an occupancy grid: then a wall's edge was
/// rounded to the next pixel.
bool is_crisp(const Histogram& histogram, int black, int ground) {
  const int margin = (ground - black) / 10;
  const std::int64_t between = mass_between(histogram, black + margin, ground - margin);
  return between * 5 < mass_between(histogram, 0, black + margin - 1);
}

/// Whether there are many levels of gray between wall and ground, as blur and antialiasing make them.
bool is_soft(const Histogram& histogram, int black, int ground) {
  const int margin = (ground - black) / 10;
  int levels = 0;
  for (int v = black + margin; v <= ground - margin; ++v)
    levels += histogram[static_cast<std::size_t>(v)] > 0 ? 1 : 0;
  return levels >= soft_levels;
}

}  // namespace

void copy_gray(GrayView gray, bool negate, Image<std::uint8_t>& out) {
  const std::uint8_t flip = negate ? 255 : 0;
  const auto width = static_cast<std::size_t>(gray.width);
  if (out.size() != gray.size()) out = Image<std::uint8_t>::for_overwrite(gray.size());
  for (std::int32_t y = 0; y < gray.height; ++y) {
    const std::uint8_t* const from = gray.row(y);
    std::uint8_t* const to = out.view().row(y);
    for (std::size_t x = 0; x < width; ++x) to[x] = from[x] ^ flip;
  }
}

void understand_picture(GrayView gray, PictureKind asked, const std::optional<RosMeaning>& meaning,
                        const PictureRowKernels& kernels, Picture& picture) {
  picture.facts() = PictureFacts{};
  picture.gray = picture.stretched = gray;
  if (meaning && meaning->negate) {
    copy_gray(gray, true, picture.own_gray);
    picture.gray = picture.stretched = picture.own_gray;
  }
  const Histogram histogram = histogram_of(picture.gray, kernels);
  const std::int64_t pixels = mass_between(histogram, 0, 255);
  int first_ground = darkest_ground;
  if (meaning) {
    picture.wall_below = 255.0 * (1 - meaning->occupied_thresh);
    picture.free_above = 255.0 * (1 - meaning->free_thresh);
    first_ground = std::clamp(static_cast<int>(picture.wall_below) + 1, 1, 255);
  }
  const Histogram blocks = block_histogram(picture.gray, kernels);
  const std::vector<int> grounds = ground_levels(blocks, first_ground, pixels);
  const bool map = asked == PictureKind::map || meaning.has_value() ||
                   (asked == PictureKind::automatic && looks_like_map(histogram, blocks, grounds, pixels));
  picture.kind = map ? PictureKind::map : PictureKind::photo;
  if (!map) return;
  const int ground = grounds.empty() ? 255 : grounds.front();
  picture.ground = ground;
  const int black = std::min(darkest_level(histogram, pixels), ground / 2);
  if (ground - black < wide_enough) {
    stretch(picture.gray, {black, std::max(ground - black, 1)}, kernels, picture.own_stretched);
    picture.stretched = picture.own_stretched;
    picture.clipped = mass_between(histogram, 0, black - 1) + mass_between(histogram, ground + 1, 255) > 0;
  }
  picture.noisy = is_grainy(picture.gray, kernels) || is_speckled(picture.gray, kernels);
  picture.crisp = is_crisp(histogram, black, ground);
  picture.soft = is_soft(histogram, black, ground);
  if (!meaning && grounds.size() > 1) picture.free_above = 0.5 * (grounds.front() + grounds.back());
}

Picture understand_picture(GrayView gray, PictureKind asked, const std::optional<RosMeaning>& meaning) {
  Picture picture;
  Image<std::uint8_t> own;
  copy_gray(gray, false, own);
  understand_picture(own, asked, meaning, plain_picture_row_kernels, picture);
  if (picture.gray.data == own.view().data) picture.own_gray = std::move(own);
  return picture;
}

}  // namespace straightedge
