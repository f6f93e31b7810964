// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "base/lanes.hpp"
#include "depth_cell_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

// That are summed at once: their sums lie on the stack, which is small where one lane is all there is.
constexpr std::int32_t columns = lanes > 1 ? 64 : 32;
constexpr std::int32_t band = 4;  // rows or columns that are summed before they meet others

struct ColumnSums {
  float near[columns];            ///< its cell's number that the readings are counted from
  float q[columns], qq[columns];  ///< of what they are above it
  float below[columns];           ///< row v counts side − v times
  float seen[columns];            ///< 2^v for each reading

  /// Some number near the readings of each cell, so that little is lost in sums of 32 bits: the reading in
  /// the middle, or where there is none, what the cell before had.
  template <std::int32_t side>
  void begin(const float* first, std::ptrdiff_t stride, std::int32_t cells, float& last) noexcept {
    const float* middle = first + side / 2 * stride + side / 2;
    for (std::int32_t i = 0; i < cells; ++i) {
      const float q_of_middle = middle[i * side];
      last = q_of_middle > 0 ? q_of_middle : last;
      for (std::int32_t k = 0; k < side; ++k) near[i * side + k] = last;
    }
  }
  /// Of the columns from x on.
  template <std::int32_t side>
  void sum(const float* first, std::ptrdiff_t stride, std::int32_t x) noexcept {
    const Lanes none = all(0), from = load(near + x);
    Lanes reads = none, bit = all(1), sum = none, sum_below = none, squares = none;
    for (std::int32_t v = 0; v < side; ++v) {
      const Lanes read = load(first + v * stride);
      const auto good = read > none;
      const Lanes above = good ? read - from : none;
      reads += good ? bit : none;
      bit += bit;
      sum += above;
      sum_below += sum;
      squares += above * above;
    }
    store(q + x, sum);
    store(qq + x, squares);
    store(below + x, sum_below);
    store(seen + x, reads);
  }
  /// The first columns; those that are left over hold nothing.
  template <std::int32_t side>
  void sum_all(const float* first, std::ptrdiff_t stride, std::int32_t count) noexcept {
    std::int32_t x = 0;
    for (; x + lanes <= count; x += lanes) sum<side>(first + x, stride, x);
    float rest[side * lanes] = {};
    for (std::int32_t i = count; i < columns; ++i) near[i] = 0;
    for (; x < columns; x += lanes) {
      for (std::int32_t v = 0; v < side; ++v) {
        for (std::int32_t i = 0; i < lanes; ++i) {
          rest[v * lanes + i] = x + i < count ? first[v * stride + x + i] : 0.0F;
        }
      }
      sum<side>(rest, lanes, x);
    }
  }
};

/// Sums of four columns beside one another each.
struct BandSums {
  static constexpr std::int32_t most = columns / band;
  float q[most], uq[most], qq[most], below[most], seen[most];

  explicit BandSums(const ColumnSums& of) noexcept {
    for (std::int32_t i = 0; i < most; ++i) {
      const float* x = of.q + band * i;
      q[i] = (x[0] + x[1]) + (x[2] + x[3]);
      uq[i] = (x[1] + 2 * x[2]) + 3 * x[3];
    }
    add_up(of.qq, qq);
    add_up(of.below, below);
    add_up(of.seen, seen);
  }
  static void add_up(const float* columns_of, float* __restrict sums) noexcept {
    for (std::int32_t i = 0; i < most; ++i) {
      const float* x = columns_of + band * i;
      sums[i] = (x[0] + x[1]) + (x[2] + x[3]);
    }
  }
};

/// Of pixels above one another, a bit for each reading: how many, and the sums of their places and of the
/// squares of these. All three in one number, so that they are added up at once; four rows in a table.
struct Places {
  static constexpr std::uint32_t field = 20, most_bands = 4;
  std::uint64_t of[most_bands][16];

  static constexpr std::int32_t count(std::uint64_t x) noexcept {
    return static_cast<std::int32_t>(x >> 2 * field);
  }
  static constexpr std::int32_t squares(std::uint64_t x) noexcept {
    return static_cast<std::int32_t>(x >> field & ((1U << field) - 1));
  }
  static constexpr std::int32_t sum(std::uint64_t x) noexcept {
    return static_cast<std::int32_t>(x & ((1U << field) - 1));
  }
};

constexpr Places make_places() noexcept {
  Places places{};
  for (std::uint64_t k = 0; k < Places::most_bands; ++k) {
    for (std::uint64_t bits = 0; bits < 16; ++bits) {
      for (std::uint64_t v = band * k; v < band * k + band; ++v) {
        if ((bits >> (v - band * k) & 1U) == 0) continue;
        places.of[k][bits] += (std::uint64_t{1} << 2 * Places::field) + (v * v << Places::field) + v;
      }
    }
  }
  return places;
}

constexpr Places places = make_places();

/// Cells; u and v count from their corners.
struct CellSums {
  static constexpr std::int32_t most = columns / band;
  float near[most];
  float q[most], uq[most], vq[most], qq[most];  ///< of what the readings are above it
  float n[most], mean_u[most], mean_v[most];    ///< of the readings' places
  float uu[most], uv[most], vv[most];           ///< sums of products of their deviations from these
  float seen[most];

  template <std::int32_t side>
  void join(const ColumnSums& of_columns, const BandSums& of) noexcept {
    constexpr std::int32_t bands = side / band;
    for (std::int32_t i = 0; i < most / bands; ++i) {
      float sum = 0, u_sum = 0, below = 0, squares = 0, reads = 0;
      for (std::int32_t k = 0; k < bands; ++k) {
        const std::int32_t at = bands * i + k;
        u_sum += static_cast<float>(band * k) * of.q[at] + of.uq[at];
        sum += of.q[at];
        below += of.below[at];
        squares += of.qq[at];
        reads += of.seen[at];
      }
      near[i] = of_columns.near[side * i];
      q[i] = sum;
      uq[i] = u_sum;
      vq[i] = side * sum - below;
      qq[i] = squares;
      seen[i] = reads;
    }
  }
  template <std::int32_t side>
  void count_places(const ColumnSums& of, std::int32_t count) noexcept {
    constexpr float pixels = side * side, middle = 0.5F * (side - 1), spread = pixels * (pixels - 1) / 12;
    for (std::int32_t i = 0; i < most; ++i) {
      n[i] = pixels;
      mean_u[i] = mean_v[i] = middle;
      uu[i] = vv[i] = spread;
      uv[i] = 0;
    }
    constexpr float all_seen = side * ((1 << side) - 1);
    for (std::int32_t i = 0; i < count; ++i) {
      if (seen[i] != all_seen) count_some<side>(of.seen + i * side, i);
    }
  }
  template <std::int32_t side>
  void count_some(const float* seen_here, std::int32_t i) noexcept {
    // From the last column on: column u is u times in `along`, and u (u + 1) / 2 times in `triangle`.
    std::uint64_t once = 0, along = 0, triangle = 0;
    for (std::int32_t x = side - 1; x >= 0; --x) {
      if (x + 1 < side) {
        along += once;
        triangle += along;
      }
      const auto bits = static_cast<std::uint32_t>(seen_here[x]);
      for (std::uint32_t k = 0; k < side / band; ++k) once += places.of[k][bits >> (band * k) & 15U];
    }
    const std::int32_t of_n = Places::count(once), of_u = Places::count(along), of_v = Places::sum(once);
    const double readings = of_n > 0 ? of_n : 1, u = of_u / readings, v = of_v / readings;
    const auto number = [](double x) noexcept { return static_cast<float>(x); };
    n[i] = number(of_n);
    mean_u[i] = number(u);
    mean_v[i] = number(v);
    uu[i] = number((2 * Places::count(triangle) - of_u) - u * of_u);
    uv[i] = number(Places::sum(along) - u * of_v);
    vv[i] = number(Places::squares(once) - v * of_v);
  }
};

/// Cells as DepthCell holds them, a row of numbers for each kind.
struct CellWriter {
  const DepthCellRows& out;
  std::int32_t count;

  void put(std::ptrdiff_t kind, std::int32_t i, const Lanes& x) const noexcept {
    float* to = out.first + kind * out.apart + i;
    if (i + lanes <= count) {
      store(to, x);
      return;
    }
    float some[lanes];
    store(some, x);
    for (std::int32_t k = 0; i + k < count; ++k) to[k] = some[k];
  }
  /// The first cell's corner is at (left, top).
  void write(const CellSums& sums, std::int32_t side, double left, double top,
             std::uint8_t* counts) const noexcept {
    float lefts[CellSums::most];
    for (std::int32_t i = 0; i < CellSums::most; ++i) lefts[i] = static_cast<float>(left + side * i);
    const auto at_top = static_cast<float>(top);
    for (std::int32_t i = 0; i < count; i += lanes) {
      const Lanes n = load(sums.n + i), readings = n > all(0) ? n : all(1);
      const Lanes u = load(sums.mean_u + i), v = load(sums.mean_v + i);
      const Lanes q = load(sums.q + i), mean_q = q / readings;
      const Lanes near = n > all(0) ? load(sums.near + i) : all(0);
      put(0, i, n);
      put(1, i, u + load(lefts + i));
      put(2, i, v + at_top);
      put(3, i, near + mean_q);
      put(4, i, load(sums.uu + i));
      put(5, i, load(sums.uv + i));
      put(6, i, load(sums.vv + i));
      put(7, i, load(sums.uq + i) - u * q);
      put(8, i, load(sums.vq + i) - v * q);
      put(9, i, load(sums.qq + i) - mean_q * q);
    }
    for (std::int32_t i = 0; i < count; ++i) {
      counts[i] = static_cast<std::uint8_t>(sums.n[i] < 255 ? sums.n[i] : 255.0F);
    }
  }
};

template <std::int32_t side>
void sum_some(const DepthRows& corner, std::int32_t count, float& near, ColumnSums& of_columns,
              CellSums& sums) noexcept {
  of_columns.begin<side>(corner.first, corner.stride, count, near);
  of_columns.sum_all<side>(corner.first, corner.stride, count * side);
  sums.join<side>(of_columns, BandSums(of_columns));
  sums.count_places<side>(of_columns, count);
}

}  // namespace

void build_cells(const DepthRows& corner, std::int32_t side, std::int32_t cells, double left, double top,
                 const DepthCellRows& out, std::uint8_t* counts) noexcept {
  const std::int32_t most = columns / side;
  ColumnSums of_columns;
  CellSums sums;
  float near = 0;
  for (std::int32_t first = 0; first < cells; first += most) {
    const std::int32_t rest = cells - first, count = rest < most ? rest : most;
    const DepthRows pixels{corner.first + first * side, corner.stride};
    if (side == 4) {
      sum_some<4>(pixels, count, near, of_columns, sums);
    } else if (side == 8) {
      sum_some<8>(pixels, count, near, of_columns, sums);
    } else {
      sum_some<16>(pixels, count, near, of_columns, sums);
    }
    const DepthCellRows to{out.first + first, out.apart};
    CellWriter{to, count}.write(sums, side, left + side * first, top, counts + first);
  }
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
