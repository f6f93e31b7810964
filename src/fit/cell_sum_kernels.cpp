// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "base/lanes.hpp"
#include "depth_cell_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

// That are summed at once: their sums lie on the stack, which is small where one lane is all there is.
constexpr std::int32_t columns = lanes > 1 ? 64 : 32;
constexpr std::int32_t band = 4;  // rows or columns that are summed before they meet others

// As many floats and doubles at once as the registers hold of doubles.
#if STRAIGHTEDGE_LANES > 1
constexpr std::int32_t at_once = lanes / 2;
using Floats [[gnu::vector_size(STRAIGHTEDGE_LANES * 2)]] = float;
using Doubles [[gnu::vector_size(STRAIGHTEDGE_LANES * 4)]] = double;
#else
constexpr std::int32_t at_once = 1;
using Floats = float;
using Doubles = double;
#endif

inline Doubles in_doubles(const Floats& x) noexcept {
#if STRAIGHTEDGE_LANES == 16
  // One by one: GCC 12 turns this into one instruction, but not the builtin for vectors as long as these.
  const auto at = [&](int i) noexcept { return static_cast<double>(x[i]); };
  return Doubles{at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7)};
#elif STRAIGHTEDGE_LANES > 1
  return __builtin_convertvector(x, Doubles);
#else
  return static_cast<double>(x);
#endif
}

inline Floats in_floats(const Doubles& x) noexcept {
#if STRAIGHTEDGE_LANES > 1
  return __builtin_convertvector(x, Floats);
#else
  return static_cast<float>(x);
#endif
}

struct ColumnSums {
  double q[columns], qq[columns];
  double below[columns];  ///< row v counts side − v times
  float seen[columns];    ///< 2^v for each reading

  /// Of the columns from x on.
  template <std::int32_t side>
  void sum(const float* first, std::ptrdiff_t stride, std::int32_t x) noexcept {
    const Floats none{};
    Floats reads = none, bit = none + 1.0F;
    Doubles sum{}, sum_below{}, squares{};
    for (std::int32_t v = 0; v < side; v += band) {
      Doubles square[band];
      for (std::int32_t i = 0; i < band; ++i) {
        Floats read;
        std::memcpy(&read, first + (v + i) * stride, sizeof read);
        const auto good = read > none;
        const Doubles reading = in_doubles(good ? read : none);
        reads += good ? bit : none;
        bit += bit;
        sum += reading;
        sum_below += sum;
        square[i] = reading * reading;
      }
      squares += (square[0] + square[1]) + (square[2] + square[3]);
    }
    std::memcpy(q + x, &sum, sizeof sum);
    std::memcpy(qq + x, &squares, sizeof squares);
    std::memcpy(below + x, &sum_below, sizeof sum_below);
    std::memcpy(seen + x, &reads, sizeof reads);
  }
  /// The first columns; those that are left over hold nothing.
  template <std::int32_t side>
  void sum_all(const float* first, std::ptrdiff_t stride, std::int32_t count) noexcept {
    std::int32_t x = 0;
    for (; x + at_once <= count; x += at_once) sum<side>(first + x, stride, x);
    float rest[side * at_once] = {};
    for (; x < columns; x += at_once) {
      for (std::int32_t v = 0; v < side; ++v) {
        for (std::int32_t i = 0; i < at_once; ++i) {
          rest[v * at_once + i] = x + i < count ? first[v * stride + x + i] : 0.0F;
        }
      }
      sum<side>(rest, at_once, x);
    }
  }
};

/// Sums of four columns beside one another each.
struct BandSums {
  static constexpr std::int32_t most = columns / band;
  double q[most], uq[most], qq[most], below[most];
  float seen[most];

  explicit BandSums(const ColumnSums& of) noexcept {
    for (std::int32_t i = 0; i < most; ++i) {
      const double* x = of.q + band * i;
      q[i] = (x[0] + x[1]) + (x[2] + x[3]);
      uq[i] = (x[1] + 2 * x[2]) + 3 * x[3];
    }
    for (std::int32_t i = 0; i < most; ++i) {
      const double* x = of.qq + band * i;
      qq[i] = (x[0] + x[1]) + (x[2] + x[3]);
    }
    for (std::int32_t i = 0; i < most; ++i) {
      const double* x = of.below + band * i;
      below[i] = (x[0] + x[1]) + (x[2] + x[3]);
    }
    for (std::int32_t i = 0; i < most; ++i) {
      const float* x = of.seen + band * i;
      seen[i] = (x[0] + x[1]) + (x[2] + x[3]);
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
  double q[most], uq[most], vq[most], qq[most];
  double n[most], mean_u[most], mean_v[most];  ///< of the readings' places
  double uu[most], uv[most], vv[most];         ///< sums of products of their deviations from these
  float seen[most];

  template <std::int32_t side>
  void join(const BandSums& of) noexcept {
    constexpr std::int32_t bands = side / band;
    for (std::int32_t i = 0; i < most / bands; ++i) {
      double sum = 0, u_sum = 0, below = 0, squares = 0;
      float reads = 0;
      for (std::int32_t k = 0; k < bands; ++k) {
        const std::int32_t at = bands * i + k;
        u_sum += (band * k) * of.q[at] + of.uq[at];
        sum += of.q[at];
        below += of.below[at];
        squares += of.qq[at];
        reads += of.seen[at];
      }
      q[i] = sum;
      uq[i] = u_sum;
      vq[i] = side * sum - below;
      qq[i] = squares;
      seen[i] = reads;
    }
  }
  template <std::int32_t side>
  void count_places(const ColumnSums& of, std::int32_t count) noexcept {
    constexpr double pixels = side * side, middle = 0.5 * (side - 1), spread = pixels * (pixels - 1) / 12;
    for (std::int32_t i = 0; i < most; ++i) {
      n[i] = pixels;
      mean_u[i] = mean_v[i] = middle;
      uu[i] = vv[i] = spread;
      uv[i] = 0;
    }
    constexpr float whole = side * ((1 << side) - 1);
    for (std::int32_t i = 0; i < count; ++i) {
      if (seen[i] != whole) count_some<side>(of.seen + i * side, i);
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
    n[i] = of_n;
    mean_u[i] = u;
    mean_v[i] = v;
    uu[i] = (2 * Places::count(triangle) - of_u) - u * of_u;
    uv[i] = Places::sum(along) - u * of_v;
    vv[i] = Places::squares(once) - v * of_v;
  }
};

/// Cells as DepthCell holds them, a row of numbers for each kind.
struct CellWriter {
  const DepthCellRows& out;
  std::int32_t count;

  void put(std::ptrdiff_t kind, std::int32_t i, const Doubles& x) const noexcept {
    const Floats rounded = in_floats(x);
    float* to = out.first + kind * out.apart + i;
    if (i + at_once <= count) {
      std::memcpy(to, &rounded, sizeof rounded);
      return;
    }
    float some[at_once];
    std::memcpy(some, &rounded, sizeof rounded);
    for (std::int32_t k = 0; i + k < count; ++k) to[k] = some[k];
  }
  static Doubles load(const double* from) noexcept {
    Doubles x;
    std::memcpy(&x, from, sizeof x);
    return x;
  }
  /// The first cell's corner is at (left, top).
  void write(const CellSums& sums, std::int32_t side, double left, double top,
             std::uint8_t* counts) const noexcept {
    double lefts[CellSums::most];
    for (std::int32_t i = 0; i < CellSums::most; ++i) lefts[i] = left + side * i;
    for (std::int32_t i = 0; i < count; i += at_once) {
      const Doubles n = load(sums.n + i), one = Doubles{} + 1.0, readings = n > Doubles{} ? n : one;
      const Doubles u = load(sums.mean_u + i), v = load(sums.mean_v + i);
      const Doubles q = load(sums.q + i), mean_q = q / readings;
      put(0, i, n);
      put(1, i, u + load(lefts + i));
      put(2, i, v + top);
      put(3, i, mean_q);
      put(4, i, load(sums.uu + i));
      put(5, i, load(sums.uv + i));
      put(6, i, load(sums.vv + i));
      put(7, i, load(sums.uq + i) - u * q);
      put(8, i, load(sums.vq + i) - v * q);
      put(9, i, load(sums.qq + i) - mean_q * q);
    }
    for (std::int32_t i = 0; i < count; ++i) {
      counts[i] = static_cast<std::uint8_t>(sums.n[i] < 255 ? sums.n[i] : 255.0);
    }
  }
};

template <std::int32_t side>
void sum_some(const DepthRows& corner, std::int32_t count, ColumnSums& of_columns, CellSums& sums) noexcept {
  of_columns.sum_all<side>(corner.first, corner.stride, count * side);
  sums.join<side>(BandSums(of_columns));
  sums.count_places<side>(of_columns, count);
}

}  // namespace

void build_cells(const DepthRows& corner, std::int32_t side, std::int32_t cells, double left, double top,
                 const DepthCellRows& out, std::uint8_t* counts) noexcept {
  const std::int32_t most = columns / side;
  ColumnSums of_columns;
  CellSums sums;
  for (std::int32_t first = 0; first < cells; first += most) {
    const std::int32_t rest = cells - first, count = rest < most ? rest : most;
    const DepthRows pixels{corner.first + first * side, corner.stride};
    if (side == 4) {
      sum_some<4>(pixels, count, of_columns, sums);
    } else if (side == 8) {
      sum_some<8>(pixels, count, of_columns, sums);
    } else {
      sum_some<16>(pixels, count, of_columns, sums);
    }
    const DepthCellRows to{out.first + first, out.apart};
    CellWriter{to, count}.write(sums, side, left + side * first, top, counts + first);
  }
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
