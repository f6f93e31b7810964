// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "base/lanes.hpp"
#include "depth_cell_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

constexpr std::int32_t columns = 64;  // that are summed at once: their sums lie on the stack
constexpr std::int32_t band = 4;      // rows or columns that are summed before they meet others

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
  // GCC 12 takes the builtin's vectors apart where they are as long as this.
  return Doubles{x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7]};
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

/// Of four pixels above one another, a bit for each reading: how many, and the sums of their places and of
/// the squares of these. All three in one number, so that they are added up at once.
struct Places {
  static constexpr std::uint32_t field = 20;
  std::uint64_t of[16];

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
  for (std::uint64_t bits = 0; bits < 16; ++bits) {
    for (std::uint64_t v = 0; v < 4; ++v) {
      if ((bits >> v & 1U) == 0) continue;
      places.of[bits] += (std::uint64_t{1} << 2 * Places::field) + (v * v << Places::field) + v;
    }
  }
  return places;
}

constexpr Places places = make_places();

/// Sums of cells, u and v from their corners.
template <std::int32_t side>
struct CellSums {
  static constexpr std::int32_t most = columns / side, bands = side / band;
  static constexpr std::int32_t room = most > at_once ? most : at_once;
  double q[room], uq[room], vq[room], qq[room];
  double n[room], u[room], v[room], uu[room], uv[room], vv[room];

  CellSums(const BandSums& of, const ColumnSums& pixels, std::int32_t count) noexcept {
    constexpr std::int32_t once = side * (side - 1) / 2, squared = once * (2 * side - 1) / 3;
    for (std::int32_t i = 0; i < room; ++i) {
      q[i] = uq[i] = vq[i] = qq[i] = 0;
      n[i] = side * side;
      u[i] = v[i] = side * once;
      uu[i] = vv[i] = side * squared;
      uv[i] = once * once;
    }
    float seen[most];
    for (std::int32_t i = 0; i < most; ++i) {
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
    constexpr float whole = side * ((1 << side) - 1);
    for (std::int32_t i = 0; i < count; ++i) {
      if (seen[i] != whole) count_places(pixels.seen + i * side, i);
    }
  }
  void count_places(const float* seen, std::int32_t i) noexcept {
    // Each reading once, u times, u² times; row by row of four pixels.
    std::int32_t sum = 0, of_u = 0, of_v = 0, of_uu = 0, of_uv = 0, of_vv = 0;
    for (std::int32_t k = 0; k < bands; ++k) {
      std::uint64_t once = 0, along = 0, squared = 0;
      for (std::int32_t x = 0; x < side; ++x) {
        const std::uint64_t place = places.of[static_cast<std::uint32_t>(seen[x]) >> (band * k) & 15U];
        const auto weight = static_cast<std::uint64_t>(x);
        once += place;
        along += weight * place;
        squared += weight * weight * place;
      }
      const std::int32_t top = band * k, reads = Places::count(once), down = Places::sum(once);
      sum += reads;
      of_u += Places::count(along);
      of_uu += Places::count(squared);
      of_v += top * reads + down;
      of_uv += top * Places::count(along) + Places::sum(along);
      of_vv += top * (top * reads + 2 * down) + Places::squares(once);
    }
    n[i] = sum;
    u[i] = of_u;
    v[i] = of_v;
    uu[i] = of_uu;
    uv[i] = of_uv;
    vv[i] = of_vv;
  }
};

/// Cells as DepthCell holds them, a row of numbers for each kind.
template <std::int32_t side>
struct CellMeans {
  static constexpr std::int32_t room = CellSums<side>::room;
  float of[DepthCellRows::kinds][room];

  /// The first cell's corner is at (left, top).
  CellMeans(const CellSums<side>& sums, double left, double top) noexcept {
    double lefts[room];
    for (std::int32_t i = 0; i < room; ++i) lefts[i] = left + side * i;
    const auto load = [](const double* from) noexcept {
      Doubles x;
      std::memcpy(&x, from, sizeof x);
      return x;
    };
    for (std::int32_t i = 0; i < room; i += at_once) {
      const auto put = [&](std::int32_t kind, const Doubles& x) noexcept {
        const Floats rounded = in_floats(x);
        std::memcpy(of[kind] + i, &rounded, sizeof rounded);
      };
      const Doubles n = load(sums.n + i), one = Doubles{} + 1.0, readings = n > Doubles{} ? n : one;
      const Doubles u = load(sums.u + i), v = load(sums.v + i), q = load(sums.q + i);
      const Doubles mean_u = u / readings, mean_v = v / readings, mean_q = q / readings;
      put(0, n);
      put(1, mean_u + load(lefts + i));
      put(2, mean_v + top);
      put(3, mean_q);
      put(4, load(sums.uu + i) - mean_u * u);
      put(5, load(sums.uv + i) - mean_u * v);
      put(6, load(sums.vv + i) - mean_v * v);
      put(7, load(sums.uq + i) - mean_u * q);
      put(8, load(sums.vq + i) - mean_v * q);
      put(9, load(sums.qq + i) - mean_q * q);
    }
  }
  void write(const DepthCellRows& out, std::uint8_t* counts, std::int32_t count) const noexcept {
    for (std::ptrdiff_t kind = 0; kind < DepthCellRows::kinds; ++kind) {
      float* to = out.first + kind * out.apart;
      for (std::int32_t i = 0; i < count; ++i) to[i] = of[kind][i];
    }
    for (std::int32_t i = 0; i < count; ++i) {
      counts[i] = static_cast<std::uint8_t>(of[0][i] < 255 ? of[0][i] : 255.0F);
    }
  }
};

template <std::int32_t side>
void build_row(const DepthRows& corner, std::int32_t cells, double left, double top, const DepthCellRows& out,
               std::uint8_t* counts) noexcept {
  constexpr std::int32_t most = columns / side;
  for (std::int32_t first = 0; first < cells; first += most) {
    const std::int32_t rest = cells - first, count = rest < most ? rest : most;
    ColumnSums sums;
    sums.sum_all<side>(corner.first + first * side, corner.stride, count * side);
    const CellMeans<side> cells_here({BandSums(sums), sums, count}, left + side * first, top);
    const DepthCellRows to{out.first + first, out.apart};
    if (count == most) {
      cells_here.write(to, counts + first, most);
    } else {
      cells_here.write(to, counts + first, count);
    }
  }
}

}  // namespace

void build_cells(const DepthRows& corner, std::int32_t side, std::int32_t cells, double left, double top,
                 const DepthCellRows& out, std::uint8_t* counts) noexcept {
  if (side == 4) return build_row<4>(corner, cells, left, top, out, counts);
  if (side == 8) return build_row<8>(corner, cells, left, top, out, counts);
  build_row<16>(corner, cells, left, top, out, counts);
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
