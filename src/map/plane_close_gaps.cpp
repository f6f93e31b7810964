// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "map/plane_raster.hpp"
#include "straightedge/rounding.hpp"

namespace straightedge {
namespace {

/// What a cell makes of another one when `value` spreads; of 64 cells at once.
std::uint64_t spread(bool value, std::uint64_t a, std::uint64_t b) {
  return value ? a | b : a & b;
}

/// to[i] = spread(a[i], b[i]); `to` may be `a`.
void spread(bool value, const std::uint64_t* a, const std::uint64_t* b, std::uint64_t* to,
            std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) to[i] = spread(value, a[i], b[i]);
}

/// The 64 bits from bit n on, where bits behind the end are 0.
std::uint64_t bits_from(const std::vector<std::uint64_t>& words, std::size_t n) {
  const std::size_t word = n / 64, bit = n % 64;
  const std::uint64_t low = word < words.size() ? words[word] : 0;
  const std::uint64_t high = word + 1 < words.size() ? words[word + 1] : 0;
  return low >> bit | high << 1U << (63 - bit);
}

/// Every bit gets the value where the one `distance` bits later has it.
void spread_bits(std::vector<std::uint64_t>& words, std::size_t distance, bool value) {
  if (distance / 64 + 1 >= words.size() || distance % 64 == 0) {
    for (std::size_t i = 0; i < words.size(); ++i)
      words[i] = spread(value, words[i], bits_from(words, 64 * i + distance));
    return;
  }
  const std::size_t ahead = distance / 64, bit = distance % 64, inner = words.size() - ahead - 1;
  std::uint64_t* const to = words.data();
  for (std::size_t i = 0; i < inner; ++i)
    to[i] = spread(value, to[i], to[i + ahead] >> bit | to[i + ahead + 1] << (64 - bit));
  for (std::size_t i = inner; i < words.size(); ++i)
    words[i] = spread(value, words[i], bits_from(words, 64 * i + distance));
}

/// A cell gets the value when one within `reach` on its row has it. All rows are one string of bits: where
/// one ends and the next begins nothing is covered as far as that reaches. Windows of a power of two first,
/// two of which then overlap.
void grow_rows(Raster& raster, std::size_t reach, bool value) {
  const std::size_t window = 2 * reach + 1;
  std::size_t width = 1;
  for (; 2 * width <= window; width *= 2) spread_bits(raster.words, width, value);
  spread_bits(raster.words, window - width, value);
  std::vector<std::uint64_t> moved(raster.words.size() + reach / 64 + 1);
  const std::size_t words = reach / 64, bit = reach % 64;
  for (std::size_t i = 0; i < raster.words.size(); ++i) {
    moved[i + words] |= raster.words[i] << bit;
    moved[i + words + 1] = raster.words[i] >> 1U >> (63 - bit);
  }
  std::copy_n(moved.begin(), raster.words.size(), raster.words.begin());
}

/// The same on columns, 64 of them at once.
void grow_columns(Raster& raster, std::size_t reach, bool value) {
  const auto lines = static_cast<std::size_t>(raster.height);
  const std::size_t length = raster.pitch, window = 2 * reach + 1;
  std::vector<std::uint64_t> cells((lines + 2 * reach) * length);
  std::copy(raster.words.begin(), raster.words.end(),
            cells.begin() + static_cast<std::ptrdiff_t>(reach * length));
  std::size_t width = 1;
  for (; 2 * width <= window; width *= 2) {
    const std::size_t left = (lines + window - 2 * width) * length;
    spread(value, cells.data(), cells.data() + width * length, cells.data(), left);
  }
  spread(value, cells.data(), cells.data() + (window - width) * length, raster.words.data(), lines * length);
}

}  // namespace

void close_gaps(Raster& raster, double max_gap) {
  const std::int64_t cells = round_half_even(max_gap / 2 / raster.cell);
  if (cells < 1) return;
  const auto reach =
      static_cast<std::size_t>(std::min<std::int64_t>(cells, std::max(raster.width, raster.height)));
  for (const bool value : {true, false}) {
    grow_rows(raster, reach, value);
    grow_columns(raster, reach, value);
  }
}

}  // namespace straightedge
