// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "base/kernel_set.hpp"
#include "map/plane_row.hpp"
#include "map/plane_row_bits.hpp"
#include "map/plane_run_search.hpp"
#if defined(__AVX2__)
#include "map/fast/label_changes.hpp"
#include "map/fast/piece.hpp"
#include "map/fast/place.hpp"
#else
#include "map/plane_label_changes.hpp"
#include "map/plane_piece.hpp"
#include "map/plane_place.hpp"
#endif

namespace straightedge {
namespace STRAIGHTEDGE_KERNEL_SET {
namespace {

std::uint16_t largest_label(const std::uint16_t* labels, std::int32_t count) noexcept {
  std::uint16_t largest = 0;
  for (std::int32_t n = 0; n < count; ++n) largest = labels[n] > largest ? labels[n] : largest;
  return largest;
}

/// What the pixels of one label need to be placed.
inline PlaneOfRow plane_of_row(const PlaneRowPart& part, const PixelPlane& plane) noexcept {
  const double* const n = plane.normal;
  const double* const r = part.ray;
  return {plane.by_u, (n[0] * r[0] + n[1] * r[1] + n[2] * r[2]) * plane.by_distance, plane.distance,
          plane.far_off};
}

/// Steps 1 and 2 for the pixels from n to end, which have one label.
inline void place_label(const PlaneRowPart& part, std::int32_t n, std::int32_t end,
                        PlaneRowPlaces& places) noexcept {
  if (part.labels[n] == 0) {
    places.i[places.guard + n] = INT32_MIN;
    return;
  }
  const PlaneOfRow plane = plane_of_row(part, part.planes[part.labels[n] - 1]);
  for (; n < end; n += 16) {
    const std::uint16_t* raw = part.raw + n;
    if (n + 16 > part.to_row_end) {
      for (std::int32_t last = n; last < end; ++last) places.raw[last - n] = part.raw[last];
      raw = places.raw;
    }
    std::uint32_t leaf_changes = place(part, plane, raw, n, places);
    if (end - n < 16) leaf_changes &= (1U << static_cast<unsigned>(end - n)) - 1;
    set_bits(places.changes, n, leaf_changes);
  }
}

void leave_out(const PlaneRowPart& part, const PlaneRowPlaces& p, std::int32_t n, std::int32_t end,
               LeftOut& out) noexcept {
  if (part.labels[n] == 0) return;
  const std::int32_t far_off = part.planes[part.labels[n] - 1].far_off;
  for (; n < end; ++n) {
    const std::int32_t r = p.residual[p.guard + n];
    if (r <= far_off && r >= -far_off) {
      ++out.out_of_range;
    } else {
      out.off_plane += part.raw[n] != 0 ? 1 : 0;
    }
  }
}

/// Step 3, for neighbours of one label in one leaf.
inline void add_piece(const PlaneRowPart& part, const PlaneRowPlaces& p, std::int32_t n, std::int32_t end,
                      detail::PlaneRunTable& runs, LeftOut& out) noexcept {
  const std::int32_t at = p.guard + n;
  if (p.i[at] < 0) return leave_out(part, p, n, end, out);
  detail::PlaneRun& run = run_for(runs, run_leaf(p.i[at], p.j[at], p.k[at]), part.labels[n], end - n);
  for (; n < end; n += 16) add_pixels(run, p, n, end - n < 16 ? end - n : 16);
}

template <class Visit>
inline void for_each_piece(const std::uint64_t* changes, std::int32_t count, Visit visit) noexcept {
  std::int32_t begin = 0;
  for (std::int32_t n = 0; n < count; n += 64) {
    for (std::uint64_t word = changes[n / 64]; word != 0; word &= word - 1) {
      const std::int32_t next = n + __builtin_ctzll(word);
      visit(begin, next);
      begin = next;
    }
  }
  visit(begin, count);
}

void add(const PlaneRowPart& part, PlaneRowPlaces& places, detail::PlaneRunTable& table,
         LeftOut& out) noexcept {
  std::uint64_t labels[PlaneRowPart::most / 64 + 2];
  label_changes(part.labels, part.count, labels);
  for (std::int32_t w = 0; w <= part.count / 64; ++w) places.changes[w] = labels[w];
  places.changes[part.count / 64 + 1] = 0;
  for_each_piece(labels, part.count,
                 [&](std::int32_t begin, std::int32_t end) { place_label(part, begin, end, places); });
  places.changes[0] &= ~std::uint64_t{1};
  detail::PlaneRunTable runs = table;  // a copy of its own stays in registers
  for_each_piece(places.changes, part.count, [&](std::int32_t begin, std::int32_t end) {
    add_piece(part, places, begin, end, runs, out);
  });
  table = runs;
}

}  // namespace
}  // namespace STRAIGHTEDGE_KERNEL_SET

extern const PlaneRowKernels STRAIGHTEDGE_OF_SET(_plane_row_kernels);
constinit const PlaneRowKernels STRAIGHTEDGE_OF_SET(_plane_row_kernels) = {
    STRAIGHTEDGE_KERNEL_SET::largest_label,
    STRAIGHTEDGE_KERNEL_SET::add,
};

}  // namespace straightedge
