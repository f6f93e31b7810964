// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/depth_kernels.hpp"

#include "base/kernel_set.hpp"
#include "depth_cell_kernels.hpp"

namespace straightedge {
namespace STRAIGHTEDGE_KERNEL_SET {
namespace {

constexpr std::int32_t pixels = DepthChoice::side * DepthChoice::side;

void invert(const std::uint16_t* raw, std::int32_t width, float scale, float* inverse) noexcept {
  for (std::int32_t x = 0; x < width; ++x) {
    // 0/1 where there is no reading: a division without a branch around it goes many at a time.
    const std::int32_t units = raw[x];
    const std::int32_t missing = units == 0 ? 1 : 0;
    inverse[x] = scale * static_cast<float>(1 - missing) / static_cast<float>(units + missing);
  }
}

/// Whether a reading of the row is not the plane's.
bool label_row(const float* q, std::int32_t width, float first, float slope, float limit, std::uint16_t label,
               std::uint16_t* __restrict out) noexcept {
  std::int32_t missed = 0;
  for (std::int32_t x = 0; x < width; ++x) {
    const float r = q[x] - (first + slope * static_cast<float>(x));
    const bool reads = q[x] > 0, near = (r < limit) & (r > -limit);
    out[x] = (near & reads) ? label : std::uint16_t{0};
    missed |= (reads & !near) ? 1 : 0;
  }
  return missed != 0;
}

std::uint32_t label_block(const DepthBlock& block, std::uint16_t* labels, std::ptrdiff_t stride) noexcept {
  std::uint32_t missed = 0;
  const float slope = static_cast<float>(block.along);
  for (std::int32_t y = 0; y < block.height; ++y) {
    const float* q = block.rows.first + y * block.rows.stride;
    const float first = static_cast<float>(block.at + block.down * y);
    const bool some = label_row(q, block.width, first, slope, block.limit, block.label, labels + y * stride);
    missed |= (some ? 1U : 0U) << static_cast<std::uint32_t>(y);
  }
  return missed;
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

/// A number for each of the 4x4 pixels.
struct Lanes {
  float of[pixels];
};

struct Nearest {
  Lanes distance, next;
  std::int32_t chosen[pixels];
};

/// u and v from the corner.
void nearest(const DepthChoice& pixel, const Lanes& u, const Lanes& v, const Lanes& q,
             Nearest& best) noexcept {
  for (std::int32_t i = 0; i < pixels; ++i) {
    best.distance.of[i] = best.next.of[i] = 1e30F;
    best.chosen[i] = 0;
  }
  for (std::int32_t k = 0; k < pixel.planes; ++k) {
    const float at = pixel.at[k], along = pixel.along[k], down = pixel.down[k];
    for (std::int32_t i = 0; i < pixels; ++i) {
      const float r = q.of[i] - ((at + along * u.of[i]) + down * v.of[i]);
      const float distance = r < 0 ? -r : r;
      const float before = best.distance.of[i], next = best.next.of[i];
      const float further = distance < before ? before : distance;
      best.next.of[i] = further < next ? further : next;
      best.distance.of[i] = distance < before ? distance : before;
      const std::int32_t nearer = static_cast<std::int32_t>(distance < before);
      best.chosen[i] += nearer * (k + 1 - best.chosen[i]);
    }
  }
}

/// The mean of the 3x3 pixels around each one that lie on its surface.
void average(const DepthChoice& pixel, const Lanes& limit, Lanes& u, Lanes& v, Lanes& q) noexcept {
  Lanes n{}, right{}, down{}, sum{};
  for (std::int32_t j = 0; j < 3; ++j) {
    for (std::int32_t i = 0; i < 3; ++i) {
      Lanes other;
      for (std::int32_t y = 0; y < DepthChoice::side; ++y) {
        const float* row = pixel.around + (y + j) * DepthChoice::stride + i;
        for (std::int32_t x = 0; x < DepthChoice::side; ++x) other.of[y * DepthChoice::side + x] = row[x];
      }
      const float dx = static_cast<float>(i - 1), dy = static_cast<float>(j - 1);
      for (std::int32_t k = 0; k < pixels; ++k) {
        const float r = other.of[k] - q.of[k];
        const bool counts = (other.of[k] > 0) & (r <= limit.of[k]) & (r >= -limit.of[k]);
        const float one = static_cast<float>(static_cast<std::int32_t>(counts));
        n.of[k] += one;
        right.of[k] += dx * one;
        down.of[k] += dy * one;
        sum.of[k] += one * other.of[k];
      }
    }
  }
  for (std::int32_t k = 0; k < pixels; ++k) {
    const float count = n.of[k] > 1 ? n.of[k] : 1.0F;
    u.of[k] += right.of[k] / count;
    v.of[k] += down.of[k] / count;
    q.of[k] = sum.of[k] / count;
  }
}

void choose(const DepthChoice& pixel, std::int32_t* chosen) noexcept {
  constexpr float beyond_doubt = 4, same_surface = 8;
  Lanes u, v, q, noise, limit;
  for (std::int32_t y = 0; y < DepthChoice::side; ++y) {
    const float* row = pixel.around + (y + 1) * DepthChoice::stride + 1;
    for (std::int32_t x = 0; x < DepthChoice::side; ++x) {
      u.of[y * DepthChoice::side + x] = static_cast<float>(x);
      v.of[y * DepthChoice::side + x] = static_cast<float>(y);
      q.of[y * DepthChoice::side + x] = row[x];
    }
  }
  std::int32_t reads[pixels];
  for (std::int32_t i = 0; i < pixels; ++i) {
    const float of_square = pixel.noise_of_square * (q.of[i] * q.of[i]);
    noise.of[i] = of_square > pixel.noise ? of_square : pixel.noise;
    limit.of[i] = same_surface * noise.of[i];
    reads[i] = q.of[i] > 0 ? 1 : 0;
  }
  Nearest found;
  nearest(pixel, u, v, q, found);
  std::int32_t doubts = 0;
  std::int32_t doubt[pixels];
  for (std::int32_t i = 0; i < pixels; ++i) {
    const float ahead = found.next.of[i] - found.distance.of[i];
    doubt[i] = ahead < beyond_doubt * noise.of[i] ? reads[i] : 0;
    doubts += doubt[i];
  }
  Lanes distance = found.distance;
  for (std::int32_t i = 0; i < pixels; ++i) chosen[i] = found.chosen[i];
  if (doubts > 0) {
    average(pixel, limit, u, v, q);
    nearest(pixel, u, v, q, found);
    for (std::int32_t i = 0; i < pixels; ++i) {
      chosen[i] = doubt[i] != 0 ? found.chosen[i] : chosen[i];
      distance.of[i] = doubt[i] != 0 ? found.distance.of[i] : distance.of[i];
    }
  }
  for (std::int32_t i = 0; i < pixels; ++i) {
    chosen[i] = distance.of[i] < pixel.sigmas * noise.of[i] ? chosen[i] * reads[i] : 0;
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
    .label_block = STRAIGHTEDGE_KERNEL_SET::label_block,
    .look_around = STRAIGHTEDGE_KERNEL_SET::look_around,
    .choose = STRAIGHTEDGE_KERNEL_SET::choose,
};

}  // namespace straightedge
