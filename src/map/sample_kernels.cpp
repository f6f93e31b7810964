// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <cstdint>

#include "base/kernel_set.hpp"
#include "map/line_kernels.hpp"

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

constexpr std::int32_t room = 64;  // samples that are made together

struct Samples {
  double right[room], down[room];  // shares of the neighbours
  std::int32_t column[room], row[room];
  std::uint16_t top[room], bottom[room];  // two pixels side by side
};

/// In pictures of two columns and rows or more. The last column (row) is the neighbour of the one before it,
/// with all of the share: the same numbers as if it were its own neighbour.
void find_pixels(const SampleWay& way, const double* __restrict steps, std::int32_t count,
                 Samples& __restrict to) noexcept {
  const double last_x = way.width - 1, last_y = way.height - 1;
  const std::int32_t most_column = way.width - 2, most_row = way.height - 2;
  for (std::int32_t i = 0; i < count; ++i) {
    double x = way.x + steps[i] * way.step_x + way.aside_x;
    double y = way.y + steps[i] * way.step_y + way.aside_y;
    x = x < 0 ? 0 : x;
    x = x > last_x ? last_x : x;
    y = y < 0 ? 0 : y;
    y = y > last_y ? last_y : y;
    std::int32_t c = static_cast<std::int32_t>(x), r = static_cast<std::int32_t>(y);
    c = c > most_column ? most_column : c;
    r = r > most_row ? most_row : r;
    to.column[i] = c;
    to.row[i] = r;
    to.right[i] = x - c;
    to.down[i] = y - r;
  }
}

void read_pixels(const SampleWay& way, std::int32_t count, Samples& __restrict to) noexcept {
  for (std::int32_t i = 0; i < count; ++i) {
    const std::uint8_t* const above = way.pixels + to.row[i] * way.stride + to.column[i];
    const std::uint8_t* const below = above + way.stride;
    to.top[i] = static_cast<std::uint16_t>(above[0] | above[1] << 8);
    to.bottom[i] = static_cast<std::uint16_t>(below[0] | below[1] << 8);
  }
}

void weigh(const Samples& __restrict from, std::int32_t count, double* __restrict gray) noexcept {
  for (std::int32_t i = 0; i < count; ++i) {
    const double fx = from.right[i], fy = from.down[i];
    const double top = (from.top[i] & 255) * (1 - fx) + (from.top[i] >> 8) * fx;
    const double bottom = (from.bottom[i] & 255) * (1 - fx) + (from.bottom[i] >> 8) * fx;
    gray[i] = top * (1 - fy) + bottom * fy;
  }
}

}  // namespace

void sample(const SampleWay& way, const double* steps, std::int32_t count, double* gray) noexcept {
  for (std::int32_t first = 0; first < count; first += room) {
    const std::int32_t some = count - first < room ? count - first : room;
    Samples samples;
    find_pixels(way, steps + first, some, samples);
    read_pixels(way, some, samples);
    weigh(samples, some, gray + first);
  }
}

void read_nearest(const SampleWay& way, std::int32_t count, std::uint8_t* gray) noexcept {
  for (std::int32_t first = 0; first < count; first += room) {
    const std::int32_t some = count - first < room ? count - first : room;
    std::int32_t column[room], row[room];
    for (std::int32_t i = 0; i < some; ++i) {
      const double x = way.x + (first + i) * way.step_x + way.aside_x;
      const double y = way.y + (first + i) * way.step_y + way.aside_y;
      column[i] = x < 0 ? -1 : static_cast<std::int32_t>(x);
      row[i] = y < 0 ? -1 : static_cast<std::int32_t>(y);
    }
    for (std::int32_t i = 0; i < some; ++i) {
      const bool inside = column[i] >= 0 && column[i] < way.width && row[i] >= 0 && row[i] < way.height;
      gray[first + i] = inside ? way.pixels[row[i] * way.stride + column[i]] : std::uint8_t{255};
    }
  }
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
