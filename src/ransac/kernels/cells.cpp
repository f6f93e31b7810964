// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "ransac/kernels/lane_sums.hpp"
#include "ransac/kernels/search_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

constexpr std::uint8_t least_neighbours = 3;

// Marks are written for whole groups of cells: loops over bytes are slow with what is left over.
constexpr std::int32_t group = lanes == 1 ? 1 : search_lanes;
static_assert(group <= search_overrun);

#if STRAIGHTEDGE_LANES > 4
/// Marks of as many cells as lanes.
using Some [[gnu::vector_size(STRAIGHTEDGE_LANES)]] = std::uint8_t;
#endif

void mark_row(const SearchReadings& row, std::int32_t count, const SearchPlane& p, float most,
              std::uint8_t* __restrict hit) noexcept {
#if STRAIGHTEDGE_LANES == 16
  const Lanes a = all(p.a), b = all(p.b), c = all(p.c), limit = all(most);
  for (std::int32_t i = 0; i < count; i += lanes) {
    const Lanes e = (load(row.q + i) - ((a * load(row.u + i) + b * load(row.v + i)) + c)) * load(row.w + i);
    const Some marks = __builtin_convertvector(e * e < limit, Some) & 1;
    std::memcpy(hit + i, &marks, sizeof marks);
  }
#else
  for (std::int32_t i = 0; i < count; ++i) {
    const float e = (row.q[i] - ((p.a * row.u[i] + p.b * row.v[i]) + p.c)) * row.w[i];
    hit[i] = e * e < most ? 1 : 0;
  }
#endif
}

/// A group of marks, and as many as a register holds.
#if STRAIGHTEDGE_LANES > 1
using Group [[gnu::vector_size(group)]] = std::uint8_t;
using Register [[gnu::vector_size(4 * STRAIGHTEDGE_LANES)]] = std::uint8_t;
#else
using Group = std::uint8_t;
using Register = std::uint8_t;
#endif

template <class Bytes>
Bytes load_bytes(const std::uint8_t* from) noexcept {
  Bytes x;
  std::memcpy(&x, from, sizeof x);
  return x;
}

/// A mark and those left and right of it.
template <class Bytes>
Bytes three(const std::uint8_t* marks) noexcept {
  return static_cast<Bytes>(load_bytes<Bytes>(marks - 1) + load_bytes<Bytes>(marks) +
                            load_bytes<Bytes>(marks + 1));
}

/// Of a few columns and so many rows, fewer than a byte counts; how many marks each column keeps.
template <class Bytes>
void keep_columns(const std::uint8_t* hit, std::ptrdiff_t stride, std::int32_t rows, std::uint8_t* core,
                  std::uint8_t* counts) noexcept {
  const Bytes none{}, enough = static_cast<Bytes>(none + least_neighbours);
  Bytes above = three<Bytes>(hit - stride), here = three<Bytes>(hit), count = none;
  for (std::int32_t y = 0; y < rows; ++y, hit += stride, core += stride) {
    const Bytes own = load_bytes<Bytes>(hit), below = three<Bytes>(hit + stride);
    const Bytes near = static_cast<Bytes>(above + here + below - own);
    const Bytes kept = near >= enough ? own : none;
    std::memcpy(core, &kept, sizeof kept);
    count = static_cast<Bytes>(count + kept);
    above = here;
    here = below;
  }
  std::memcpy(counts, &count, sizeof count);
}

void keep_rows(const std::uint8_t* hit, std::ptrdiff_t stride, std::int32_t rows, std::int32_t width,
               std::uint8_t* core, std::uint8_t* counts) noexcept {
  constexpr auto wide = static_cast<std::int32_t>(sizeof(Register));
  std::int32_t i = 0;
  for (; i + group < width; i += wide) keep_columns<Register>(hit + i, stride, rows, core + i, counts + i);
  for (; i < width; i += group) keep_columns<Group>(hit + i, stride, rows, core + i, counts + i);
}

/// Adds the counts up.
std::uint32_t collect(const std::uint8_t* __restrict counts, std::int32_t count,
                      std::uint8_t* __restrict columns) noexcept {
  std::uint32_t sum = 0;
  for (std::int32_t i = 0; i < count; ++i) {
    sum += counts[i];
    columns[i] = static_cast<std::uint8_t>(columns[i] | counts[i]);
  }
  return sum;
}

std::uint64_t four(const std::uint16_t* labels) noexcept {
  std::uint64_t together = 0;
  std::memcpy(&together, labels, sizeof together);
  return together;
}

#if STRAIGHTEDGE_LANES > 1
/// Four labels for each lane.
using Fours [[gnu::vector_size(STRAIGHTEDGE_LANES * 8)]] = std::uint64_t;
#endif

std::uint64_t eight(const std::uint8_t* bytes) noexcept {
  std::uint64_t together = 0;
  std::memcpy(&together, bytes, sizeof together);
  return together;
}

bool any_in_row(const std::uint8_t* marks, std::int32_t count) noexcept {
  std::uint64_t any = 0;
  for (std::int32_t i = 0; i < count; i += 8) any |= eight(marks + i);
  return any != 0;
}

/// Marks as floats, where lanes are too few to make them of bytes. A single lane needs no row of them.
void spread_marks(const std::uint8_t* core, std::int32_t count, float* __restrict marks) noexcept {
  if constexpr (lanes == 4)
    for (std::int32_t i = 0; i < count; ++i) marks[i] = static_cast<float>(core[i]);
}

Lanes load_marks([[maybe_unused]] const std::uint8_t* core, [[maybe_unused]] const float* marks) noexcept {
#if STRAIGHTEDGE_LANES > 4
  // In single steps, of which compilers know instructions.
  using Shorts [[gnu::vector_size(2 * STRAIGHTEDGE_LANES)]] = std::uint16_t;
  const auto shorts = __builtin_convertvector(load_bytes<Some>(core), Shorts);
  return __builtin_convertvector(__builtin_convertvector(shorts, Marks), Lanes);
#elif STRAIGHTEDGE_LANES > 1
  return load(marks);
#else
  return all(*core);
#endif
}

/// Is there a mark that a slice of lanes adds, whose cells are among the sixteen?
bool any_mark(const std::uint8_t* sixteen, std::int32_t lane) noexcept {
  if constexpr (lanes > 1) return (eight(sixteen) | eight(sixteen + 8)) != 0;
  return sixteen[lane] != 0;
}

SearchReadings moved(const SearchReadings& r, std::ptrdiff_t by) noexcept {
  return {r.u + by, r.v + by, r.q + by, r.w + by};
}

}  // namespace

void take_cells(const SearchCells& cells, std::int32_t count, const SearchGate& gate, float none,
                const SearchOutput& out) noexcept {
  const Lanes zero = all(0), one = all(1), absent = all(none), narrowest = all(gate.least),
              most = all(gate.most_squared);
  for (std::int32_t i = 0; i < count; i += lanes) {
    const auto number = [&](std::int32_t kind) noexcept {
      return load(cells.first + kind * cells.apart + i);
    };
    const Lanes n = number(0), q = number(3);
    const Lanes uu = number(4), uv = number(5), vv = number(6), uq = number(7), vq = number(8);
    // What the best slopes leave of the squares of q. Pixels on a line, or a single one, have none.
    const Lanes determinant = uu * vv - uv * uv;
    const auto solid = determinant > 1e-3F * (uu * vv);
    const Lanes explained =
        (uq * (uq * vv - vq * uv) + vq * (vq * uu - uq * uv)) / (solid ? determinant : one);
    const Lanes wide = gate.per_square * (q * q);
    const Lanes inverse = one / (wide > narrowest ? wide : narrowest);
    const Lanes squares = (number(9) - (solid ? explained : zero)) * (inverse * inverse);
    const auto good = (n > zero) & (q > zero) & (q <= all(1e6F)) & (inverse <= all(1e12F)) &
                      (q * inverse > one) & (squares <= most * n);
    store(out.u + i, number(1) + cells.middle_u);
    store(out.v + i, number(2) + cells.middle_v);
    store(out.q + i, good ? q : absent);
    store(out.w + i, good ? inverse : one);
    store(out.squares + i, squares);
  }
}

void mask_cells(const std::uint16_t* labels, std::ptrdiff_t stride, std::int32_t rows, std::int32_t side,
                std::int32_t count, float none, float* __restrict q) noexcept {
  std::int32_t first = 0;
#if STRAIGHTEDGE_LANES > 1
  for (; side == 4 && first + lanes <= count; first += lanes) {
    Fours any{};
    for (std::int32_t y = 0; y < rows; ++y) {
      Fours row;
      std::memcpy(&row, labels + y * stride + 4 * first, sizeof row);
      any |= row;
    }
    const Marks masked = __builtin_convertvector(any != 0, Marks);
    store(q + first, masked ? all(none) : load(q + first));
  }
#endif
  for (std::int32_t i = first; i < count; ++i) {
    std::uint64_t any = 0;
    for (std::int32_t y = 0; y < rows; ++y)
      for (std::int32_t x = 0; x < side; x += 4) any |= four(labels + y * stride + i * side + x);
    q[i] = any == 0 ? q[i] : none;
  }
}

std::uint32_t count_readings(const float* q, const SearchBox& box) noexcept {
  const Lanes none = all(0), one = all(1);
  float counts[search_lanes];
  for (std::int32_t l = 0; l < search_lanes; l += lanes) {
    Lanes sum = none;
    for (std::int32_t y = 0; y < box.height; ++y)
      for (std::int32_t x = l; x < box.width; x += search_lanes)
        sum += load(q + y * box.stride + x) > none ? one : none;
    store(counts + l, sum);
  }
  return static_cast<std::uint32_t>(fold(counts));
}

void mark_hits(const SearchReadings& readings, const SearchBox& box, const SearchPlane& plane, float most,
               std::uint8_t* hit) noexcept {
  const std::int32_t width = rounded_up(box.width, group);
  const SearchPlane p = plane;
  for (std::int32_t y = 0; y < box.height; ++y)
    mark_row(moved(readings, y * box.stride), width, p, most, hit + y * box.stride);
}

SearchMarks keep_dense(const std::uint8_t* hit, const SearchBox& box, std::uint8_t* core,
                       std::uint8_t* counts, std::uint8_t* columns) noexcept {
  // A byte counts to 255.
  constexpr std::int32_t most_rows = 255;
  const std::int32_t width = rounded_up(box.width, group);
  SearchMarks marks;
  for (std::int32_t i = 0; i < width; ++i) columns[i] = 0;
  for (std::int32_t y = 0; y < box.height; y += most_rows) {
    const std::int32_t left = box.height - y, rows = left < most_rows ? left : most_rows;
    keep_rows(hit + y * box.stride, box.stride, rows, width, core + y * box.stride, counts);
    marks.cells += collect(counts, box.width, columns);
  }
  if (marks.cells == 0) return marks;
  marks.end_row = box.height;
  while (!any_in_row(core + marks.first_row * box.stride, box.width)) ++marks.first_row;
  while (!any_in_row(core + (marks.end_row - 1) * box.stride, box.width)) --marks.end_row;
  return marks;
}

void empty_marked(const std::uint8_t* core, const SearchBox& box, float none, float* __restrict q) noexcept {
  for (std::int32_t y = 0; y < box.height; ++y) {
    const std::uint8_t* marks = core + y * box.stride;
    float* row = q + y * box.stride;
#if STRAIGHTEDGE_LANES == 16
    for (std::int32_t i = 0; i < box.width; i += lanes)
      store(row + i, load_marks(marks + i, nullptr) > all(0) ? all(none) : load(row + i));
#else
    for (std::int32_t i = 0; i < box.width; ++i) row[i] = marks[i] != 0 ? none : row[i];
#endif
  }
}

void sum_marked(const SearchReadings& readings, const std::uint8_t* core, const SearchBox& box,
                const SearchPlane& plane, float u0, float v0, float* marks, SearchSums& sums) noexcept {
  PartialSums partial;
  for (std::int32_t l = 0; l < search_lanes; l += lanes) {
    const Lanes a = all(plane.a), b = all(plane.b), c = all(plane.c), middle_u = all(u0), middle_v = all(v0);
    LaneSums s;
    for (std::int32_t y = 0; y < box.height; ++y) {
      spread_marks(core + y * box.stride, rounded_up(box.width, group), marks);
      for (std::int32_t i = 0; i < box.width; i += search_lanes) {
        const std::ptrdiff_t at = y * box.stride + i;
        if (!any_mark(core + at, l)) continue;
        const SearchReadings r = moved(readings, at + l);
        const Lanes u = load(r.u), v = load(r.v);
        const Lanes residual = load(r.q) - ((a * u + b * v) + c);
        s.add(load_marks(core + at + l, marks + i + l), u - middle_u, v - middle_v, residual, load(r.w));
      }
    }
    s.store_to(partial, l);
  }
  sums = partial.folded();
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
