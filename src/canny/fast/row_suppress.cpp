// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
// Same result as ../row_suppress.cpp; read that first.
#ifdef STRAIGHTEDGE_KERNEL_SET
#include <cstring>

#include "canny/fast/lanes.hpp"
#include "canny/fast/row_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

// Step 3 as one comparison: the pixel must be above the larger neighbour, and one that may be equal counts
// one less. All sectors are computed, and the right one is chosen.
template <class Lanes, class M>
Lanes crest_limit(const MagnitudeRows<M>& rows, std::int32_t x) noexcept {
  const auto load = [x](const M* row, std::int32_t step) { return Lanes::load(row + x + step); };
  const Lanes one = Lanes::all(1);
  const Lanes horizontal = max(load(rows.here, -1), load(rows.here, 1) - one);
  const Lanes vertical = max(load(rows.above, 0), load(rows.below, 0) - one);
  const Lanes falling = max(load(rows.above, -1), load(rows.below, 1));
  const Lanes rising = max(load(rows.above, 1), load(rows.below, -1));

  // Step 2 in as many bits as the gradients have: tan 22.5 degrees is 13573 / 2^15, tan 67.5 is 2 more.
  const Lanes dx = Lanes::load_gradient(rows.dx + x), dy = Lanes::load_gradient(rows.dy + x);
  const Lanes across = dx.magnitude(), down = dy.magnitude();
  const Lanes flat = across.times_high(2 * 13573);
  const Lanes diagonal = select((dx ^ dy).negative(), rising, falling);
  const Lanes steep = select(down > across + across + flat, vertical, diagonal);
  return select(down > flat, steep, horizontal);
}

// One block of pixels; gives back how many are strong. `low` may differ from lane to lane.
template <class Lanes, class M>
std::uint32_t suppress_block(const MagnitudeRows<M>& rows, std::int32_t x, Lanes low, Lanes high,
                             std::uint8_t* classes) noexcept {
  const Lanes m = Lanes::load(rows.here + x);
  const auto kept = m > max(low, crest_limit<Lanes>(rows, x));
  const auto strong = both(kept, m > high);
  store_classes(Lanes{}, kept, strong, classes + x);
  return count_of(Lanes{}, strong);
}

// Where edges are few, none is in most stretches of this many pixels; where they are many, one is in most.
constexpr std::int32_t stretch = 64;

// Of a stretch, lane by lane.
template <class Lanes, class M>
Lanes largest_of(const M* magnitude) noexcept {
  Lanes largest = Lanes::load(magnitude);
  for (std::int32_t i = Lanes::count; i < stretch; i += Lanes::count) {
    largest = max(largest, Lanes::load(magnitude + i));
  }
  return largest;
}

// Thresholds above the largest magnitude are all alike.
std::int32_t limited(std::int32_t threshold, std::int32_t largest) noexcept {
  return threshold < 0 ? 0 : threshold < largest ? threshold : largest;
}

template <class Lanes, class M>
std::uint32_t suppress(const MagnitudeRows<M> rows, MagnitudeThresholds limits, std::int32_t largest,
                       std::uint8_t* classes, std::int32_t width) noexcept {
  const Lanes low = Lanes::all(limited(limits.low, largest));
  const Lanes high = Lanes::all(limited(limits.high, largest));
  std::uint32_t strong = 0;
  std::int32_t x = 0;
  for (; x + stretch <= width; x += stretch) {
    if (!any(largest_of<Lanes>(rows.here + x) > low)) {
      std::memset(classes + x, 0, stretch);
      continue;
    }
    for (std::int32_t i = x; i < x + stretch; i += Lanes::count) {
      strong += suppress_block<Lanes>(rows, i, low, high, classes);
    }
  }
  for (; x + Lanes::count <= width; x += Lanes::count) {
    strong += suppress_block<Lanes>(rows, x, low, high, classes);
  }
  if (x == width) return strong;

  // Nothing beyond the row is kept.
  M lows[Lanes::count];
  for (std::int32_t i = 0; i < Lanes::count; ++i) {
    lows[i] = static_cast<M>(x + i < width ? limited(limits.low, largest) : largest);
  }
  return strong + suppress_block<Lanes>(rows, x, Lanes::load(lows), high, classes);
}

}  // namespace

std::uint32_t suppress_l1(const MagnitudeRows<std::uint16_t>& rows, MagnitudeThresholds limits,
                          std::uint8_t* classes, std::int32_t width) noexcept {
  return suppress<Lanes16>(rows, limits, INT16_MAX, classes, width);
}

std::uint32_t suppress_l2(const MagnitudeRows<std::uint32_t>& rows, MagnitudeThresholds limits,
                          std::uint8_t* classes, std::int32_t width) noexcept {
  return suppress<Lanes32>(rows, limits, INT32_MAX, classes, width);
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
#endif
