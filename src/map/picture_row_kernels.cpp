// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstdint>

#include "base/kernel_set.hpp"
#include "map/line_kernels.hpp"

namespace straightedge {
namespace STRAIGHTEDGE_KERNEL_SET {
namespace {

constexpr std::int32_t side = 4;
constexpr std::int32_t area = side * side;
constexpr std::int32_t lanes = 64;  // bytes that are looked at together

/// Rounded: (2 · 255 · above + span) / (2 · span). That is n / span, cut off to a whole number, with
/// n = 255 · above + span / 2, which has sixteen bits as everything here. In steps of 1/256 of a gray it
/// comes out right or one too small.
void stretch(const std::uint8_t* __restrict row, std::int32_t width, GrayStretch rule,
             std::uint8_t* __restrict out) noexcept {
  const auto black = static_cast<std::uint8_t>(rule.black), span = static_cast<std::uint8_t>(rule.span);
  const auto half = static_cast<std::uint16_t>(span / 2),
             slope = static_cast<std::uint16_t>(255 * 256 / span);
  for (std::int32_t x = 0; x < width; ++x) {
    std::uint8_t above = static_cast<std::uint8_t>(row[x] > black ? row[x] - black : 0);
    above = above > span ? span : above;
    const auto n = static_cast<std::uint16_t>(255 * above + half);
    const auto gray = static_cast<std::uint16_t>(static_cast<std::uint16_t>(above * slope + 128) >> 8);
    const auto rest = static_cast<std::uint16_t>(n - gray * span);
    out[x] = static_cast<std::uint8_t>(gray + (rest >= span ? 1 : 0));
  }
}

std::int32_t count_even(const std::uint8_t* row, std::int32_t width) noexcept {
  std::int32_t even = 0;
  const std::uint8_t first = width > 0 ? row[0] : std::uint8_t{0};
  for (; even + lanes <= width; even += lanes) {
    std::uint8_t other = 0;
    for (std::int32_t i = 0; i < lanes; ++i)
      other = static_cast<std::uint8_t>(other | (row[even + i] ^ first));
    if (other != 0) break;
  }
  return even;
}

/// In bytes, no more pixels at once than can be counted in them.
void count_grain(const std::uint8_t* row, std::int32_t width, GrainCount& count) noexcept {
  constexpr std::int32_t most = 3 * lanes;
  for (std::int32_t first = 1; first < width; first += most) {
    const std::int32_t some = width - first < most ? width - first : most;
    std::uint8_t pairs = 0, same = 0;
    for (std::int32_t x = first; x < first + some; ++x) {
      const std::uint8_t between = (row[x] != 0 ? 1 : 0) & (row[x] != 255 ? 1 : 0);
      pairs = static_cast<std::uint8_t>(pairs + between);
      same = static_cast<std::uint8_t>(same + (between & (row[x] == row[x - 1] ? 1 : 0)));
    }
    count.pairs += pairs;
    count.same += same;
  }
}

inline std::uint8_t darker(std::uint8_t a, std::uint8_t b) noexcept {
  return a < b ? a : b;
}

inline std::uint8_t above_or_none(std::uint8_t a, std::uint8_t b) noexcept {
  return static_cast<std::uint8_t>(a > b ? a - b : 0);
}

/// Whether one of `count` pixels is darker than both its neighbours in the row, by more than `least`.
inline bool any_low(const std::uint8_t* here, std::int32_t count, std::uint8_t least) noexcept {
  std::uint8_t any = 0;
  for (std::int32_t x = 0; x < count; ++x) {
    const std::uint8_t lighter = above_or_none(darker(here[x - 1], here[x + 1]), here[x]);
    any = static_cast<std::uint8_t>(any | (lighter > least ? 1 : 0));
  }
  return any != 0;
}

/// Whether a row has such a pixel: without specks that is rare. The last ones are looked at together with
/// some before them: compilers make single steps of what is left over.
bool may_have_lone(const std::uint8_t* here, std::int32_t width, std::uint8_t least) noexcept {
  const std::int32_t end = width - 1, inner = width - 2;
  if (inner < lanes) return any_low(here + 1, inner, least);
  for (std::int32_t x = 1; x + lanes <= end; x += lanes)
    if (any_low(here + x, lanes, least)) return true;
  return any_low(here + end - lanes, lanes, least);
}

bool find_lone(const std::uint8_t* __restrict above, const std::uint8_t* __restrict here,
               const std::uint8_t* __restrict below, std::int32_t width, std::int32_t contrast,
               std::uint8_t* __restrict lone) noexcept {
  const auto least = static_cast<std::uint8_t>(contrast);
  if (!may_have_lone(here, width, least)) return false;
  std::uint8_t any = 0;
  for (std::int32_t x = 1; x + 1 < width; ++x) {
    const std::uint8_t top = darker(darker(above[x - 1], above[x]), above[x + 1]);
    const std::uint8_t bottom = darker(darker(below[x - 1], below[x]), below[x + 1]);
    const std::uint8_t beside = darker(here[x - 1], here[x + 1]);
    const std::uint8_t lighter = above_or_none(darker(darker(top, bottom), beside), here[x]);
    const std::uint8_t is_lone = lighter > least ? 1 : 0;
    lone[x] = is_lone;
    any = static_cast<std::uint8_t>(any | is_lone);
  }
  return any != 0;
}

/// One place of each block.
struct Lane {
  std::uint8_t of[lanes];
};

inline void put_in_order(Lane& low, Lane& high) noexcept {
  for (std::int32_t i = 0; i < lanes; ++i) {
    const std::uint8_t a = low.of[i], b = high.of[i];
    low.of[i] = a < b ? a : b;
    high.of[i] = a < b ? b : a;
  }
}

inline void sort_four(Lane* p) noexcept {
  put_in_order(p[0], p[1]);
  put_in_order(p[2], p[3]);
  put_in_order(p[0], p[2]);
  put_in_order(p[1], p[3]);
  put_in_order(p[1], p[2]);
}

/// Two times four places in order become eight.
inline void merge_fours(Lane* p) noexcept {
  for (std::int32_t i = 0; i < 4; ++i) put_in_order(p[i], p[i + 4]);
  put_in_order(p[2], p[4]);
  put_in_order(p[3], p[5]);
  put_in_order(p[1], p[2]);
  put_in_order(p[3], p[4]);
  put_in_order(p[5], p[6]);
}

/// Batcher's network as far as it is needed for the ninth of sixteen: it compares the same places whatever is
/// there, so that many blocks go through it together. Of two sorted halves, the larger ones of the first and
/// the last, the second and the last but one ... are the upper half of all.
/// K. E. Batcher, "Sorting networks and their applications", 1968, doi:10.1145/1468075.1468121.
inline void take_medians(Lane* places, std::uint8_t* medians) noexcept {
  for (std::int32_t first = 0; first < area; first += 4) sort_four(places + first);
  for (std::int32_t first = 0; first < area; first += 8) merge_fours(places + first);
  for (std::int32_t i = 0; i < lanes; ++i) {
    std::uint8_t least = 255;
    for (std::int32_t k = 0; k < area / 2; ++k) {
      const std::uint8_t a = places[k].of[i], b = places[area - 1 - k].of[i];
      const std::uint8_t larger = a < b ? b : a;
      least = larger < least ? larger : least;
    }
    medians[i] = least;
  }
}

void block_medians(const std::uint8_t* const* rows, std::int32_t count, std::uint8_t* medians) noexcept {
  for (std::int32_t first = 0; first < count; first += lanes) {
    const std::int32_t some = count - first < lanes ? count - first : lanes;
    Lane places[area];
    for (std::int32_t r = 0; r < side; ++r) {
      const std::uint8_t* const row = rows[r] + side * first;
      Lane* const here = places + side * r;
      for (std::int32_t i = 0; i < some; ++i) {
        here[0].of[i] = row[side * i];
        here[1].of[i] = row[side * i + 1];
        here[2].of[i] = row[side * i + 2];
        here[3].of[i] = row[side * i + 3];
      }
      for (std::int32_t i = some; i < lanes; ++i)
        for (std::int32_t c = 0; c < side; ++c) here[c].of[i] = 0;
    }
    std::uint8_t found[lanes];
    take_medians(places, found);
    for (std::int32_t i = 0; i < some; ++i) medians[first + i] = found[i];
  }
}

}  // namespace
}  // namespace STRAIGHTEDGE_KERNEL_SET

constinit const PictureRowKernels STRAIGHTEDGE_OF_SET(_picture_row_kernels){
    .stretch = &STRAIGHTEDGE_KERNEL_SET::stretch,
    .count_even = &STRAIGHTEDGE_KERNEL_SET::count_even,
    .count_grain = &STRAIGHTEDGE_KERNEL_SET::count_grain,
    .find_lone = &STRAIGHTEDGE_KERNEL_SET::find_lone,
    .block_medians = &STRAIGHTEDGE_KERNEL_SET::block_medians,
    .edge_magnitudes = &STRAIGHTEDGE_KERNEL_SET::edge_magnitudes,
    .edge_places = &STRAIGHTEDGE_KERNEL_SET::edge_places,
    .find_inside = &STRAIGHTEDGE_KERNEL_SET::find_inside,
    .sample = &STRAIGHTEDGE_KERNEL_SET::sample,
    .read_nearest = &STRAIGHTEDGE_KERNEL_SET::read_nearest,
};

}  // namespace straightedge
