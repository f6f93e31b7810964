// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "straightedge/host/kernels.hpp"

#include <cstddef>
#include <cstdlib>
#include <string>

#include "straightedge/detail/x86_instructions.hpp"

namespace straightedge {
namespace {

// Plain to fastest: a machine that has one of them has all before it. What a set has no table for is plain.
constexpr KernelSet all_sets[] = {
    {.name = "plain"},
#if defined(__x86_64__)
    {.name = "sse2", .canny_rows = &sse2_canny_row_kernels},
    {.name = "avx2",
     .canny_rows = &avx2_canny_row_kernels,
     .ransac = &avx2_ransac_kernels,
     .hough = &avx2_hough_kernels,
     .depth = &avx2_depth_kernels,
     .plane_search = &avx2_plane_search_kernels,
     .octree = &avx2_octree_kernels,
     .plane_rows = &avx2_plane_row_kernels,
     .picture_rows = &avx2_picture_row_kernels},
    {.name = "avx512",
     .canny_rows = &avx512_canny_row_kernels,
     .ransac = &avx512_ransac_kernels,
     .hough = &avx512_hough_kernels,
     .depth = &avx512_depth_kernels,
     .plane_search = &avx512_plane_search_kernels,
     .octree = &avx512_octree_kernels,
     .plane_rows = &avx512_plane_row_kernels,
     .picture_rows = &avx512_picture_row_kernels},
#endif
};

std::size_t count_sets() {
#if defined(__x86_64__)
  return detail::has_avx512() ? 4 : detail::has_avx2() ? 3 : 2;
#else
  return 1;
#endif
}

}  // namespace

std::span<const KernelSet> kernel_sets() {
  static const std::size_t count = count_sets();
  return std::span(all_sets).first(count);
}

const KernelSet& best_kernels() {
  return kernel_sets().back();
}

Result<KernelSet> kernels_by_name(std::string_view name) {
  std::string names;
  for (const KernelSet& set : kernel_sets()) {
    if (set.name == name) return set;
    names += (names.empty() ? "" : ", ") + std::string(set.name);
  }
  return Failure{Problem::bad_option,
                 "this machine has no kernels named \"" + std::string(name) + "\"; it has " + names};
}

Result<KernelSet> kernels_from_environment() {
  const char* const name = std::getenv("STRAIGHTEDGE_KERNELS");
  if (name == nullptr) return best_kernels();
  auto set = kernels_by_name(name);
  if (!set) return Failure{set.failure().problem, "STRAIGHTEDGE_KERNELS: " + set.failure().sentence};
  return set;
}

}  // namespace straightedge
