// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "base/lanes.hpp"
#include "depth_cell_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

// That are summed at once: their sums lie on the stack, which is small where one lane is all there is.
constexpr std::int32_t columns = lanes > 1 ? 64 : 32;

/// Number k counts for `side` lanes, then the next one.
template <std::int32_t side>
Lanes spread(const float* numbers) noexcept {
#if STRAIGHTEDGE_LANES > 1
  constexpr float each[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
  const Lanes lane = load(each);
  Lanes x = all(*numbers);
  for (std::int32_t first = side; first < lanes; first += side) {
    x = lane < static_cast<float>(first) ? x : all(*++numbers);
  }
  return x;
#else
  return *numbers;
#endif
}

/// A number for each column, or for each of so many groups of columns.
template <std::int32_t count>
struct Row {
  float of[count];

  void add_pairs(const Row<2 * count>& parts) noexcept {
    for (std::int32_t i = 0; i < count; ++i) of[i] = parts.of[2 * i] + parts.of[2 * i + 1];
  }
  /// Adds the second ones of pairs so many times.
  void add_seconds(const Row<2 * count>& parts, float times) noexcept {
    for (std::int32_t i = 0; i < count; ++i) of[i] += times * parts.of[2 * i + 1];
  }
};

struct ColumnSums {
  float near[columns / 4];   ///< the number that a cell's readings are counted from
  Row<columns> q, qq;        ///< of what they are above it
  Row<columns> below;        ///< q, where row v counts side − v times
  Row<columns> n;            ///< readings
  Row<columns> n_below;      ///< n, where row v counts side − v times
  Row<columns> n_triangles;  ///< n, where row v counts (side − v)(side − v + 1) / 2 times

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
    const Lanes none = all(0), one = all(1), from = spread<side>(near + x / side);
    Lanes sum = none, sum_below = none, squares = none, count = none, count_below = none, triangles = none;
    for (std::int32_t v = 0; v < side; ++v) {
      const Lanes read = load(first + v * stride);
      const auto good = read > none;
      const Lanes above = good ? read - from : none;
      sum += above;
      sum_below += sum;
      squares += above * above;
      count += good ? one : none;
      count_below += count;
      triangles += count_below;
    }
    store(q.of + x, sum);
    store(qq.of + x, squares);
    store(below.of + x, sum_below);
    store(n.of + x, count);
    store(n_below.of + x, count_below);
    store(n_triangles.of + x, triangles);
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
    for (std::int32_t x = 0; x < count; ++x) missing |= n.of[x] == side ? 0 : 1;
    return missing == 0;
  }
};

/// Sums of columns; u counts from the first one of each group.
template <std::int32_t count>
struct Readings {
  Row<count> q, uq, qq, below;

  explicit Readings(const ColumnSums& of) noexcept {
    q.add_pairs(of.q);
    for (std::int32_t i = 0; i < count; ++i) uq.of[i] = of.q.of[2 * i + 1];
    qq.add_pairs(of.qq);
    below.add_pairs(of.below);
  }
  /// Of pairs of groups, each so many columns wide.
  Readings(const Readings<2 * count>& of, float width) noexcept {
    q.add_pairs(of.q);
    uq.add_pairs(of.uq);
    uq.add_seconds(of.q, width);
    qq.add_pairs(of.qq);
    below.add_pairs(of.below);
  }
};

/// The readings' places in the same way: whole numbers.
template <std::int32_t count>
struct Places {
  Row<count> n, u, uu, v, uv, vv;

  Places(const ColumnSums& of, float side) noexcept {
    for (std::int32_t i = 0; i < count; ++i) {
      const float below[] = {of.n_below.of[2 * i], of.n_below.of[2 * i + 1]};
      const float first = of.n.of[2 * i], second = of.n.of[2 * i + 1];
      const float v_of_second = side * second - below[1], number = first + second,
                  all_below = below[0] + below[1];
      const float triangles = of.n_triangles.of[2 * i] + of.n_triangles.of[2 * i + 1];
      n.of[i] = number;
      u.of[i] = uu.of[i] = second;
      v.of[i] = side * number - all_below;
      uv.of[i] = v_of_second;
      vv.of[i] = (side * side * number - 2 * side * all_below) + (2 * triangles - all_below);
    }
  }
  Places(const Places<2 * count>& of, float width) noexcept {
    n.add_pairs(of.n);
    u.add_pairs(of.u);
    u.add_seconds(of.n, width);
    uu.add_pairs(of.uu);
    uu.add_seconds(of.u, 2 * width);
    uu.add_seconds(of.n, width * width);
    v.add_pairs(of.v);
    uv.add_pairs(of.uv);
    uv.add_seconds(of.v, width);
    vv.add_pairs(of.vv);
  }
};

/// Groups of two columns, joined until each is as wide as a cell.
template <std::int32_t side, template <std::int32_t> class Groups, std::int32_t count>
Groups<columns / side> joined(const Groups<count>& groups) noexcept {
  if constexpr (count == columns / side) {
    return groups;
  } else {
    return joined<side>(Groups<count / 2>(groups, columns / count));
  }
}

/// Cells; u and v count from their corners.
struct CellSums {
  static constexpr std::int32_t most = columns / 4;
  float near[most];
  float q[most], uq[most], vq[most], qq[most];  ///< of what the readings are above it
  float n[most], mean_u[most], mean_v[most];    ///< of the readings' places
  float uu[most], uv[most], vv[most];           ///< sums of products of their deviations from these

  template <std::int32_t side>
  void take_readings(const ColumnSums& sums) noexcept {
    const auto of = joined<side>(Readings<columns / 2>(sums));
    for (std::int32_t i = 0; i < columns / side; ++i) {
      near[i] = sums.near[i];
      q[i] = of.q.of[i];
      uq[i] = of.uq.of[i];
      vq[i] = side * of.q.of[i] - of.below.of[i];
      qq[i] = of.qq.of[i];
    }
  }
  template <std::int32_t side>
  void take_places(const ColumnSums& sums) noexcept {
    const auto of = joined<side>(Places<columns / 2>(sums, side));
    for (std::int32_t i = 0; i < columns / side; ++i) {
      const float readings = of.n.of[i] > 0 ? of.n.of[i] : 1.0F;
      const float u = of.u.of[i] / readings, v = of.v.of[i] / readings;
      n[i] = of.n.of[i];
      mean_u[i] = u;
      mean_v[i] = v;
      uu[i] = of.uu.of[i] - u * of.u.of[i];
      uv[i] = of.uv.of[i] - u * of.v.of[i];
      vv[i] = of.vv.of[i] - v * of.v.of[i];
    }
  }
  /// The same where every pixel has a reading.
  template <std::int32_t side>
  void take_all_places() noexcept {
    constexpr float pixels = side * side, middle = 0.5F * (side - 1), spread = pixels * (pixels - 1) / 12;
    for (std::int32_t i = 0; i < columns / side; ++i) {
      n[i] = pixels;
      mean_u[i] = mean_v[i] = middle;
      uu[i] = vv[i] = spread;
      uv[i] = 0;
    }
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
  sums.take_readings<side>(of_columns);
  if (of_columns.all_read(side, count * side)) {
    sums.take_all_places<side>();
  } else {
    sums.take_places<side>(of_columns);
  }
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
