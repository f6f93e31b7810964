// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/octree_kernels.hpp"

#include "octree/near_kernel.hpp"
#include "octree/run_starts.hpp"

namespace straightedge {
namespace STRAIGHTEDGE_KERNEL_SET {
namespace {

/// The same operations in the same order as OctreeGrid::cell_of. A coordinate that is outside becomes -1
/// before it becomes an integer: not every double has one.
void cells_of_axis(const float* coordinates, std::size_t count, const OctreeAxis& axis,
                   std::int32_t* cells) noexcept {
  const double origin = axis.origin, scale = axis.scale, offset = axis.offset, end = axis.end;
  for (std::size_t i = 0; i < count; ++i) {
    const double at = (static_cast<double>(coordinates[i]) - origin) * scale + offset;
    const double above = at >= 0 ? at : -1;
    cells[i] = static_cast<std::int32_t>(above < end ? above : -1);
  }
}

}  // namespace
}  // namespace STRAIGHTEDGE_KERNEL_SET

extern const OctreeKernels STRAIGHTEDGE_OF_SET(_octree_kernels);
constinit const OctreeKernels STRAIGHTEDGE_OF_SET(_octree_kernels) = {
    STRAIGHTEDGE_KERNEL_SET::cells_of_axis,
    STRAIGHTEDGE_KERNEL_SET::find_run_starts,
    STRAIGHTEDGE_KERNEL_SET::find_near,
};

}  // namespace straightedge
