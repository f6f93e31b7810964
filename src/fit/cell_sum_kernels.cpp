// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "base/lane_pairs.hpp"
#include "base/three_counts.hpp"
#include "depth_cell_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

// Cells, and columns of them, that are summed at once: their sums lie on the stack, which is small where one
// lane is all there is.
template <std::int32_t side>
constexpr std::int32_t columns_of = lanes > 1 ? 16 * side : 32;

/// Number k counts for `side` lanes, then the next one.
template <std::int32_t side>
Lanes spread(const float* numbers) noexcept {
#if STRAIGHTEDGE_LANES > 1
  constexpr float each[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
  const Lanes lane = load(each);
  Lanes x = all(*numbers);
  for (std::int32_t first = side; first < lanes; first += side) {
    x = lane < all(static_cast<float>(first)) ? x : all(*++numbers);
  }
  return x;
#else
  return *numbers;
#endif
}

/// Of n, n_below and n_triangles in a column of up to 16 rows: 16, 136 and 816 at most.
using ColumnCounts = ThreeCounts<5, 13>;

/// What a reading counts for, by its row from the end.
struct ReadingCounts {
  float of[17];

  constexpr ReadingCounts() noexcept : of{} {
    for (std::int32_t rows = 1; rows <= 16; ++rows)
      of[rows] = ColumnCounts::of(1, rows, rows * (rows + 1) / 2);
  }
};
constexpr ReadingCounts counts_of;

template <std::int32_t columns>
struct ColumnSums {
  float near[columns / 4];     ///< the number that a cell's readings are counted from
  float q[columns];            ///< of what they are above it
  float qq[columns];           ///< of its squares
  float below[columns];        ///< of q, where row v counts side − v times
  float n[columns];            ///< readings
  float n_below[columns];      ///< of n, where row v counts side − v times
  float n_triangles[columns];  ///< of n, where row v counts (side − v)(side − v + 1) / 2 times

  /// Some number near the readings of each cell, so that little is lost in sums of 32 bits: the reading in
  /// the middle, or where there is none, what the cell before has.
  template <std::int32_t side>
  void begin(const float* first, std::ptrdiff_t stride, std::int32_t cells, float& before) noexcept {
    const float* middle = first + side / 2 * stride + side / 2;
    for (std::int32_t i = 0; i < columns / side; ++i) {
      const float reading = i < cells ? middle[i * side] : 0.0F;
      before = reading > 0 ? reading : before;
      near[i] = before;
    }
  }
  /// Of the columns from x on.
  template <std::int32_t side>
  void sum(const float* first, std::ptrdiff_t stride, std::int32_t x) noexcept {
    const Lanes none = all(0), from = spread<side>(near + x / side);
    Lanes sum = none, sum_below = none, squares = none, counts = none;
    for (std::int32_t v = 0; v < side; ++v) {
      const Lanes read = load(first + v * stride);
      const auto good = read > none;
      const Lanes above = good ? read - from : none;
      sum += above;
      sum_below += sum;
      squares += above * above;
      counts = good ? counts + all(counts_of.of[side - v]) : counts;
    }
    store(q + x, sum);
    store(qq + x, squares);
    store(below + x, sum_below);
    const ColumnCounts counted(counts);
    store(n + x, in_floats(counted.first()));
    store(n_below + x, in_floats(counted.second()));
    store(n_triangles + x, in_floats(counted.third()));
  }
  /// The first columns; those that are left over hold nothing.
  template <std::int32_t side>
  void sum_all(const float* first, std::ptrdiff_t stride, std::int32_t count) noexcept {
    std::int32_t x = 0;
    for (; x + lanes <= count; x += lanes) sum<side>(first + x, stride, x);
    for (; x < columns; x += lanes) {
      float rest[side * lanes];
      for (std::int32_t v = 0; v < side; ++v) {
        for (std::int32_t i = 0; i < lanes; ++i) {
          rest[v * lanes + i] = x + i < count ? first[v * stride + x + i] : 0.0F;
        }
      }
      sum<side>(rest, lanes, x);
    }
  }
  bool all_read(float side, std::int32_t count) const noexcept {
    std::int32_t missing = 0;
    for (std::int32_t x = 0; x < count; ++x) missing |= n[x] == side ? 0 : 1;
    return missing == 0;
  }
};

/// Sums over groups of columns, u from the first one of each.
template <std::int32_t groups>
struct Readings {
  float q[groups], uq[groups], qq[groups], below[groups];

  /// Groups of two columns.
  explicit Readings(const ColumnSums<2 * groups>& of) noexcept {
    for (std::int32_t i = 0; i < groups; i += lanes) {
      const Pairs of_q(of.q + 2 * i);
      store(q + i, of_q.sum());
      store(uq + i, of_q.second);
      store(qq + i, Pairs(of.qq + 2 * i).sum());
      store(below + i, Pairs(of.below + 2 * i).sum());
    }
  }
  /// Pairs of groups, each so many columns wide.
  Readings(const Readings<2 * groups>& of, float width) noexcept {
    for (std::int32_t i = 0; i < groups; i += lanes) {
      const Pairs of_q(of.q + 2 * i);
      store(q + i, of_q.sum());
      store(uq + i, Pairs(of.uq + 2 * i).sum() + all(width) * of_q.second);
      store(qq + i, Pairs(of.qq + 2 * i).sum());
      store(below + i, Pairs(of.below + 2 * i).sum());
    }
  }
};

/// The readings' places in the same way: whole numbers.
template <std::int32_t groups>
struct Places {
  float n[groups], u[groups], uu[groups], v[groups], uv[groups], vv[groups];

  Places(const ColumnSums<2 * groups>& of, float side) noexcept {
    for (std::int32_t i = 0; i < groups; i += lanes) {
      const Pairs count(of.n + 2 * i), below(of.n_below + 2 * i);
      const Lanes all_below = below.sum(), triangles = Pairs(of.n_triangles + 2 * i).sum();
      const Lanes height = all(side);
      store(n + i, count.sum());
      store(u + i, count.second);
      store(uu + i, count.second);
      store(v + i, height * count.sum() - all_below);
      store(uv + i, height * count.second - below.second);
      // v = side − w: of w and ww there are sums.
      store(vv + i, (height * height * count.sum() - 2 * height * all_below) + (2 * triangles - all_below));
    }
  }
  Places(const Places<2 * groups>& of, float width) noexcept {
    for (std::int32_t i = 0; i < groups; i += lanes) {
      const Lanes across = all(width);
      const Pairs count(of.n + 2 * i), of_u(of.u + 2 * i), of_v(of.v + 2 * i);
      store(n + i, count.sum());
      store(u + i, of_u.sum() + across * count.second);
      store(uu + i, Pairs(of.uu + 2 * i).sum() + across * (2 * of_u.second + across * count.second));
      store(v + i, of_v.sum());
      store(uv + i, Pairs(of.uv + 2 * i).sum() + across * of_v.second);
      store(vv + i, Pairs(of.vv + 2 * i).sum());
    }
  }
};

/// Groups of two columns, joined until there are as many as cells.
template <std::int32_t cells, std::int32_t width, template <std::int32_t> class Groups, std::int32_t groups>
Groups<cells> joined(const Groups<groups>& of) noexcept {
  if constexpr (groups == cells) {
    return of;
  } else {
    return joined<cells, 2 * width>(Groups<groups / 2>(of, width));
  }
}

/// Where the readings of some cells are: means, and sums of products of the deviations from them.
struct Spread {
  Lanes n, u, v, uu, uv, vv;

  /// Every pixel has a reading.
  explicit Spread(float side) noexcept
      : n(all(side * side)),
        u(all(0.5F * (side - 1))),
        v(u),
        uu(all(side * side * (side * side - 1) / 12)),
        uv(all(0)),
        vv(uu) {}
  template <std::int32_t groups>
  Spread(const Places<groups>& of, std::int32_t i) noexcept : n(load(of.n + i)) {
    const Lanes readings = n > all(0) ? n : all(1), of_u = load(of.u + i), of_v = load(of.v + i);
    u = of_u / readings;
    v = of_v / readings;
    uu = load(of.uu + i) - u * of_u;
    uv = load(of.uv + i) - u * of_v;
    vv = load(of.vv + i) - v * of_v;
  }
};

/// Cells as DepthCell holds them, a row of numbers for each kind; the first one's corner is at (left, top).
struct CellWriter {
  const DepthCellRows& out;
  std::uint8_t* counts;
  std::int32_t count, side;
  double left, top;

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
  /// Cells i, i + 1, ...
  template <std::int32_t cells>
  void write(std::int32_t i, const Readings<cells>& of, const float* near, const Spread& at) const noexcept {
    float lefts[lanes], numbers[lanes];
    for (std::int32_t k = 0; k < lanes; ++k) lefts[k] = static_cast<float>(left + side * (i + k));
    const Lanes none = all(0), some = at.n > none ? at.n : all(1);
    const Lanes q = load(of.q + i), mean_q = q / some;
    put(0, i, at.n);
    put(1, i, at.u + load(lefts));
    put(2, i, at.v + all(static_cast<float>(top)));
    put(3, i, (at.n > none ? load(near + i) : none) + mean_q);
    put(4, i, at.uu);
    put(5, i, at.uv);
    put(6, i, at.vv);
    put(7, i, load(of.uq + i) - at.u * q);
    put(8, i, (all(static_cast<float>(side)) * q - load(of.below + i)) - at.v * q);
    put(9, i, load(of.qq + i) - mean_q * q);
    store(numbers, at.n);
    for (std::int32_t k = 0; k < lanes && i + k < count; ++k) {
      counts[i + k] = static_cast<std::uint8_t>(numbers[k] < 255 ? numbers[k] : 255.0F);
    }
  }
};

template <std::int32_t side>
void build_all(const DepthRows& corner, std::int32_t cells, double left, double top, const DepthCellRows& out,
               std::uint8_t* counts) noexcept {
  constexpr std::int32_t columns = columns_of<side>, most = columns / side;
  ColumnSums<columns> sums;
  float near = 0;
  for (std::int32_t first = 0; first < cells; first += most) {
    const std::int32_t rest = cells - first, count = rest < most ? rest : most;
    const float* pixels = corner.first + first * side;
    const DepthCellRows to{out.first + first, out.apart};
    const CellWriter writer{to, counts + first, count, side, left + side * first, top};
    sums.template begin<side>(pixels, corner.stride, count, near);
    sums.template sum_all<side>(pixels, corner.stride, count * side);
    const auto readings = joined<most, 2>(Readings<columns / 2>(sums));
    if (sums.all_read(side, count * side)) {
      for (std::int32_t i = 0; i < count; i += lanes) writer.write(i, readings, sums.near, Spread(side));
    } else {
      const auto places = joined<most, 2>(Places<columns / 2>(sums, side));
      for (std::int32_t i = 0; i < count; i += lanes) writer.write(i, readings, sums.near, Spread(places, i));
    }
  }
}

}  // namespace

void build_cells(const DepthRows& corner, std::int32_t side, std::int32_t cells, double left, double top,
                 const DepthCellRows& out, std::uint8_t* counts) noexcept {
  if (side == 4) {
    build_all<4>(corner, cells, left, top, out, counts);
  } else if (side == 8) {
    build_all<8>(corner, cells, left, top, out, counts);
  } else {
    build_all<16>(corner, cells, left, top, out, counts);
  }
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
