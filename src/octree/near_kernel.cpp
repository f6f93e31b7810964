// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "octree/near_kernel.hpp"

#include <cstring>
#include <limits>

namespace straightedge::STRAIGHTEDGE_KERNEL_SET {
namespace {

// Four numbers that are treated alike; the bits do not depend on how many a processor takes at once.
using Floats4 = float __attribute__((vector_size(16)));
using Words4 = std::uint32_t __attribute__((vector_size(16)));

Floats4 squares_of(const std::uint32_t* block, const OctreeNearTask& task) noexcept {
  Floats4 x, y, z;
  std::memcpy(&x, block, sizeof(x));
  std::memcpy(&y, block + 4, sizeof(y));
  std::memcpy(&z, block + 8, sizeof(z));
  x -= task.x;
  y -= task.y;
  z -= task.z;
  return x * x + y * y + z * z;
}

float least_of(const Floats4& v) noexcept {
  const float a = v[0] < v[1] ? v[0] : v[1], b = v[2] < v[3] ? v[2] : v[3];
  return a < b ? a : b;
}

}  // namespace

std::uint64_t find_near(const OctreeNearTask& task) noexcept {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  Floats4 squares[OctreeNearTask::most_blocks];
  Floats4 nearest{infinity, infinity, infinity, infinity};
  for (std::uint32_t i = 0; i < task.count; ++i) {
    const Floats4 here = squares_of(task.blocks + 16 * i, task);
    squares[i] = here;
    nearest = here < nearest ? here : nearest;
  }
  const float least = least_of(nearest);
  if (least > task.limit) return 0;
  const float limit = near_limit(task, least);
  std::uint64_t bits = 0;
  for (std::uint32_t i = 0; i < task.count; ++i) {
    const auto near = (squares[i] <= limit) & Words4{1, 2, 4, 8};
    const auto four = static_cast<std::uint64_t>(near[0] | near[1] | near[2] | near[3]);
    bits |= four << (4 * i);
  }
  return bits;
}

}  // namespace straightedge::STRAIGHTEDGE_KERNEL_SET
