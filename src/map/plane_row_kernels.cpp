// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "base/kernel_set.hpp"
#include "map/plane_bundle.hpp"
#include "map/plane_row.hpp"
#include "map/plane_run_search.hpp"

namespace straightedge {
namespace STRAIGHTEDGE_KERNEL_SET {
namespace {

constexpr std::int32_t side = PlaneRow::side;
constexpr std::int32_t squares_at_once = 8;

/// The lowest and the highest label of each square, 0 where it has none.
struct SquareLabels {
  std::uint16_t lowest[PlaneRow::most_squares], highest[PlaneRow::most_squares];
  /// 1: the square and the one before have the same one label, or none; else 0, and so are eight behind the
  /// last.
  std::uint8_t goes_on[PlaneRow::most_squares + 8];
};

struct ColumnLabels {
  std::uint16_t least[PlaneRow::most_columns];  ///< less 1, so that no label is the highest of all
  std::uint16_t most[PlaneRow::most_columns];
};

/// How many readings with a label there are: at most 4 in each of 640 columns.
inline std::uint16_t find_in_columns(const PlaneRow& row, ColumnLabels& labels) noexcept {
  constexpr std::uint16_t one = 1;
  std::uint16_t labelled = 0;
  for (std::int32_t x = 0; x < row.columns; ++x) {
    std::uint16_t low = 0xFFFF, high = 0, readings = 0;
    for (std::int32_t y = 0; y < side; ++y) {
      const std::uint16_t label = row.labels[y][x], raw = row.raw[y][x];
      const auto less = static_cast<std::uint16_t>(label - 1);
      low = less < low ? less : low;
      high = label > high ? label : high;
      const std::uint16_t both = label < raw ? label : raw;  // above 0 where both are
      readings = static_cast<std::uint16_t>(readings + (both < one ? both : one));
    }
    labels.least[x] = low;
    labels.most[x] = high;
    labelled = static_cast<std::uint16_t>(labelled + readings);
  }
  return labelled;
}

inline void find_labels(const PlaneRow& row, SquareLabels& labels, PlaneRowCounts& counts) noexcept {
  ColumnLabels columns;
  counts.labelled += find_in_columns(row, columns);
  std::uint16_t largest = 0;
  for (std::int32_t s = 0; s < row.columns / side; ++s) {
    const std::uint16_t* const least = columns.least + side * s;
    const std::uint16_t* const most = columns.most + side * s;
    const std::uint16_t low[2] = {least[0] < least[1] ? least[0] : least[1],
                                  least[2] < least[3] ? least[2] : least[3]};
    const std::uint16_t high[2] = {most[0] > most[1] ? most[0] : most[1],
                                   most[2] > most[3] ? most[2] : most[3]};
    labels.lowest[s] = static_cast<std::uint16_t>((low[0] < low[1] ? low[0] : low[1]) + 1);
    labels.highest[s] = high[0] > high[1] ? high[0] : high[1];
    largest = labels.highest[s] > largest ? labels.highest[s] : largest;
  }
  counts.largest_label = largest > counts.largest_label ? largest : counts.largest_label;
  labels.goes_on[0] = 0;
  for (std::int32_t s = 1; s < row.columns / side; ++s) {
    const std::uint32_t here = labels.lowest[s] ^ labels.highest[s],
                        before = labels.lowest[s - 1] ^ labels.highest[s - 1],
                        both = labels.lowest[s] ^ labels.lowest[s - 1];
    labels.goes_on[s] = (here | before | both) == 0 ? 1 : 0;
  }
  for (std::int32_t s = 0; s < 8; ++s) labels.goes_on[row.columns / side + s] = 0;
}

/// The next higher label in the square; 0: none.
inline std::uint32_t label_after(const PlaneRow& row, const SquareLabels& labels, std::int32_t square,
                                 std::uint32_t label) noexcept {
  constexpr std::uint16_t none = 0xFFFF;
  if (label >= labels.highest[square]) return 0;
  std::uint16_t next[side] = {none, none, none, none};
  for (const auto& line : row.labels) {
    for (std::int32_t x = 0; x < side; ++x) {
      const std::uint16_t here = line[side * square + x], higher = here > label ? here : none;
      next[x] = higher < next[x] ? higher : next[x];
    }
  }
  const std::uint16_t left = next[0] < next[1] ? next[0] : next[1],
                      right = next[2] < next[3] ? next[2] : next[3];
  return left < right ? left : right;
}

inline bool holds(const PlaneRow& row, const SquareLabels& labels, std::int32_t square,
                  std::uint32_t label) noexcept {
  const std::uint32_t low = labels.lowest[square], high = labels.highest[square];
  if (label == low || label == high) return true;
  return label > low && label < high && label_after(row, labels, square, label - 1) == label;
}

/// The first square from this one on that does not go on what the one before has.
inline std::int32_t next_change(const SquareLabels& labels, std::int32_t square) noexcept {
  constexpr std::uint64_t eight_go_on = 0x0101010101010101U;
  for (;; square += 8) {
    std::uint64_t eight;
    __builtin_memcpy(&eight, labels.goes_on + square, sizeof eight);
    if (eight != eight_go_on) return square + __builtin_ctzll(eight ^ eight_go_on) / 8;
  }
}

/// Neighbouring squares with readings of one plane.
struct Span {
  std::uint32_t label;
  std::int32_t begin, end;
};

inline std::int32_t bits_of(float number) noexcept {
  return __builtin_bit_cast(std::int32_t, number);
}

/// Step 1.
inline void sum_columns(const PlaneRow& row, const PixelPlane& plane, const Span& span,
                        PlaneColumns& sums) noexcept {
  constexpr std::int32_t at_once = PlaneRow::at_once;
  const double scale = row.metres_per_unit * plane.distance;
  const auto distance = static_cast<float>(plane.distance);
  const auto step = static_cast<float>(plane.by_u * scale);
  const auto label = static_cast<std::int32_t>(span.label);
  const std::int32_t far_off = bits_of(static_cast<float>(plane.far_off));
  double down[side];
  for (std::int32_t y = 0; y < side; ++y) down[y] = plane.by_v * (row.v + y) + plane.constant;
  for (std::int32_t x = side * span.begin / at_once * at_once; x < side * span.end; x += at_once) {
    const double along = plane.by_u * (row.u + x);
    float first[side];  // beyond = raw · (first + step · lane) − distance
    for (std::int32_t y = 0; y < side; ++y) first[y] = static_cast<float>((along + down[y]) * scale);
    for (std::int32_t lane = 0; lane < at_once; ++lane) {
      std::int32_t readings = 0;
      float residual = 0;
      for (std::int32_t y = side - 1; y >= 0; --y) {
        const float per_unit = first[y] + step * static_cast<float>(lane);
        const float beyond = static_cast<float>(row.raw[y][x + lane]) * per_unit - distance;
        // Numbers without their sign are ordered as their bits are, and what is no number comes last.
        const std::int32_t near =
            (row.labels[y][x + lane] == label ? -1 : 0) & ((bits_of(beyond) & INT32_MAX) <= far_off ? -1 : 0);
        const float kept = __builtin_bit_cast(float, bits_of(beyond) & near);
        readings += near & (1 + PlaneColumns::place * y);
        residual += kept * kept;
      }
      sums.readings[x + lane] = readings;
      sums.residual[x + lane] = residual;
    }
  }
}

/// Bundles of eight squares: a place with its readings.
struct Bundles {
  std::int32_t at[squares_at_once][4];  ///< i, j, k (quanta), and what makes BundleSums count
  std::int32_t readings[squares_at_once];
  float residual[squares_at_once];
};

/// Steps 1 and 2 from a square on.
inline void place(const PlaneRow& row, const PixelPlane& plane, const PlaneColumns& sums, std::int32_t square,
                  Bundles& bundles) noexcept {
  double u[squares_at_once], v[squares_at_once];
  for (std::int32_t lane = 0; lane < squares_at_once; ++lane) {
    const std::int32_t x = side * (square + lane);
    const std::int32_t* const n = sums.readings + x;
    const float* const r = sums.residual + x;
    constexpr std::int32_t number = PlaneColumns::place - 1;
    const std::int32_t sum = (n[0] + n[1]) + (n[2] + n[3]), along = n[1] + 2 * n[2] + 3 * n[3];
    const std::int32_t readings = sum & number;
    const float share = 1.0F / static_cast<float>(readings > 1 ? readings : 1);
    u[lane] = row.u + x + static_cast<double>(share * static_cast<float>(along & number));
    v[lane] = row.v + static_cast<double>(share * static_cast<float>(sum >> PlaneColumns::place_bits));
    bundles.readings[lane] = readings;
    bundles.residual[lane] = (r[0] + r[1]) + (r[2] + r[3]);
  }
  const GridCamera& g = row.grid;
  constexpr double end = plane_row::grid_end;
  for (std::int32_t lane = 0; lane < squares_at_once; ++lane) {
    const double z = 1 / (plane.by_u * u[lane] + (plane.by_v * v[lane] + plane.constant));
    const auto along = [&](int axis) {
      return z * (u[lane] * g.along_u[axis] + (v[lane] * g.along_v[axis] + g.corner[axis])) + g.origin[axis];
    };
    bundles.at[lane][0] = static_cast<std::int32_t>(bounded(along(0), end));
    bundles.at[lane][1] = static_cast<std::int32_t>(bounded(along(1), end));
    bundles.at[lane][2] = static_cast<std::int32_t>(bounded(along(2), end));
    bundles.at[lane][3] = BundleSums::one;
  }
}

inline bool on_grid(const std::int32_t (&at)[4]) noexcept {
  return static_cast<std::uint32_t>(at[0] | at[1] | at[2]) < static_cast<std::uint32_t>(plane_row::grid_end);
}

/// Step 3, for the first `count` of the bundles: neighbours in one leaf together.
inline void add_bundles(const Bundles& b, std::int32_t count, std::uint32_t label,
                        detail::PlaneRunTable& runs, PlaneRowCounts& counts) noexcept {
  for (std::int32_t n = 0; n < count;) {
    const std::int32_t(&at)[4] = b.at[n];
    BundleSums sums;
    do {
      sums.add(place_of(b.at[n]), b.readings[n], static_cast<std::int64_t>(b.residual[n]));
      ++n;
    } while (n < count && in_one_leaf(place_of(b.at[n]), place_of(at)));
    const std::int32_t readings = sums.readings();
    if (readings == 0) continue;
    counts.near_plane += static_cast<std::uint64_t>(readings);
    if (on_grid(at)) {
      sums.add_to(run_for(runs, run_leaf(at[0], at[1], at[2]), label, readings));
    } else {
      counts.out_of_range += static_cast<std::uint64_t>(readings);
    }
  }
}

/// Asks memory for what lies below eight squares: a line of the cache in each row.
inline void expect_below(const PlaneRow& row, std::int32_t square) noexcept {
  for (const std::uint16_t* next : row.next) __builtin_prefetch(next + side * square);
}

/// Every plane's spans, those that begin first first.
template <class Visit>
inline void for_each_span(const PlaneRow& row, const SquareLabels& labels, Visit visit) noexcept {
  const std::int32_t squares = row.columns / side;
  for (std::int32_t s = 0; s < squares; s = next_change(labels, s + 1)) {
    for (std::uint32_t label = labels.lowest[s]; label != 0; label = label_after(row, labels, s, label)) {
      if (s > 0 && holds(row, labels, s - 1, label)) continue;
      std::int32_t end = next_change(labels, s + 1);
      while (end < squares && holds(row, labels, end, label)) end = next_change(labels, end + 1);
      visit(Span{label, s, end});
    }
  }
}

void add(const PlaneRow& row, PlaneColumns& columns, detail::PlaneRunTable& table,
         PlaneRowCounts& all) noexcept {
  static_assert(PlaneColumns::size == PlaneRow::most_columns + side * squares_at_once);
  PlaneRowCounts counts = all;  // copies of its own stay in registers
  detail::PlaneRunTable runs = table;
  SquareLabels labels;
  find_labels(row, labels, counts);
  if (counts.largest_label <= row.plane_count) {
    for_each_span(row, labels, [&](const Span& span) {
      const PixelPlane& plane = row.planes[span.label - 1];
      sum_columns(row, plane, span, columns);
      for (std::int32_t s = span.begin; s < span.end; s += squares_at_once) {
        expect_below(row, s);
        Bundles bundles;
        place(row, plane, columns, s, bundles);
        const std::int32_t left = span.end - s;
        add_bundles(bundles, left < squares_at_once ? left : squares_at_once, span.label, runs, counts);
      }
    });
  }
  all = counts;
  table = runs;
}

}  // namespace
}  // namespace STRAIGHTEDGE_KERNEL_SET

extern const PlaneRowKernels STRAIGHTEDGE_OF_SET(_plane_row_kernels);
constinit const PlaneRowKernels STRAIGHTEDGE_OF_SET(_plane_row_kernels) = {
    STRAIGHTEDGE_KERNEL_SET::add,
};

}  // namespace straightedge
