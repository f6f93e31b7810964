// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/depth_kernels.hpp"

#include "base/lanes.hpp"
#include "depth_cell_kernels.hpp"
#include "pixel_kernels.hpp"

namespace straightedge {
namespace STRAIGHTEDGE_KERNEL_SET {
namespace {

Lanes in_lanes(const std::uint16_t* from) noexcept {
#if STRAIGHTEDGE_LANES > 1
  using Units [[gnu::vector_size(STRAIGHTEDGE_LANES * 2)]] = std::uint16_t;
  Units units;
  std::memcpy(&units, from, sizeof units);
  return __builtin_convertvector(__builtin_convertvector(units, Marks), Lanes);
#else
  return static_cast<float>(*from);
#endif
}

void invert(const std::uint16_t* raw, std::int32_t width, float scale, float* inverse) noexcept {
  std::int32_t x = 0;
  for (; x + lanes <= width; x += lanes) {
    const Lanes units = in_lanes(raw + x);
    store(inverse + x, units > all(0) ? all(scale) / units : all(0));
  }
  for (; x < width; ++x) inverse[x] = raw[x] > 0 ? scale / static_cast<float>(raw[x]) : 0.0F;
}

constexpr std::int32_t cells_at_once = 64;

/// Greatest label of three, and the least but 0, from x − 1 on: without a plane a cell is 0 in the one, 65535
/// in the other.
struct Extremes {
  std::uint16_t greatest[cells_at_once + 2], least[cells_at_once + 2];

  void look(const std::uint16_t* above, const std::uint16_t* here, const std::uint16_t* below,
            std::int32_t first, std::int32_t count) noexcept {
    std::uint16_t *most = greatest + first, *fewest = least + first;
    for (std::int32_t i = 0; i < count; ++i) {
      const std::uint16_t a = above[i], b = here[i], c = below[i], x = a > b ? a : b;
      const auto u = static_cast<std::uint16_t>(a - 1), v = static_cast<std::uint16_t>(b - 1);
      const auto w = static_cast<std::uint16_t>(c - 1);
      const std::uint16_t y = u < v ? u : v;
      most[i] = x > c ? x : c;
      fewest[i] = y < w ? y : w;
    }
  }
};

void judge(const Extremes& e, std::int32_t count, std::uint16_t* __restrict around) noexcept {
  for (std::int32_t i = 0; i < count; ++i) {
    const std::uint16_t a = e.greatest[i], b = e.greatest[i + 1], c = e.greatest[i + 2], x = a > b ? a : b;
    const std::uint16_t u = e.least[i], v = e.least[i + 1], w = e.least[i + 2], y = u < v ? u : v;
    const std::uint16_t greatest = x > c ? x : c, least = y < w ? y : w;
    // Both are one label, or there is none: least is 65535 then, one less than 0.
    around[i] = static_cast<std::uint16_t>(greatest - 1) == least ? greatest : std::uint16_t{0xFFFF};
  }
}

void look_around(const std::uint16_t* above, const std::uint16_t* here, const std::uint16_t* below,
                 std::int32_t width, std::uint16_t* around) noexcept {
  Extremes e;
  for (std::int32_t x = 0; x < width; x += cells_at_once) {
    const std::int32_t left = width - x, count = left < cells_at_once ? left : cells_at_once;
    // Cells x − 1 to x + count, as far as there are any.
    const std::int32_t begin = x > 0 ? x - 1 : 0, end = x + count < width ? x + count + 1 : width;
    e.greatest[0] = e.greatest[count + 1] = 0;
    e.least[0] = e.least[count + 1] = 0xFFFF;
    e.look(above + begin, here + begin, below + begin, begin - (x - 1), end - begin);
    judge(e, count, around + x);
  }
}

}  // namespace
}  // namespace STRAIGHTEDGE_KERNEL_SET

constinit const DepthKernels STRAIGHTEDGE_OF_SET(_depth_kernels) = {
    .invert = STRAIGHTEDGE_KERNEL_SET::invert,
    .keep_readings = STRAIGHTEDGE_KERNEL_SET::keep_readings,
    .build_cells = STRAIGHTEDGE_KERNEL_SET::build_cells,
    .join_cells = STRAIGHTEDGE_KERNEL_SET::join_cells,
    .choose_planes = STRAIGHTEDGE_KERNEL_SET::choose_planes,
    .mark_whole = STRAIGHTEDGE_KERNEL_SET::mark_whole,
    .spread_labels = STRAIGHTEDGE_KERNEL_SET::spread_labels,
    .label_block = STRAIGHTEDGE_KERNEL_SET::label_block,
    .rename_row = STRAIGHTEDGE_KERNEL_SET::rename_row,
    .look_around = STRAIGHTEDGE_KERNEL_SET::look_around,
    .choose = STRAIGHTEDGE_KERNEL_SET::choose,
};

}  // namespace straightedge
