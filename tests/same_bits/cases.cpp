// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cases.hpp"

#include "inputs.hpp"
#include "straightedge/detail/x86_instructions.hpp"

namespace same_bits {
namespace {

template <class Run>
void for_each_set(Run run) noexcept {
  using namespace straightedge;
  run(Kernels{.name = "plain", .runs_here = true});
#if defined(__x86_64__)
  run(Kernels{.name = "sse2",
              .runs_here = true,
              .canny_rows = &sse2_canny_row_kernels,
              .hough = &plain_hough_kernels});
  run(Kernels{.name = "avx2",
              .runs_here = detail::has_avx2(),
              .canny_rows = &avx2_canny_row_kernels,
              .hough = &avx2_hough_kernels,
              .ransac = &avx2_ransac_kernels,
              .depth = &avx2_depth_kernels,
              .plane_search = &avx2_plane_search_kernels});
  run(Kernels{.name = "avx512",
              .runs_here = detail::has_avx512(),
              .canny_rows = &avx512_canny_row_kernels,
              .hough = &avx512_hough_kernels,
              .ransac = &avx512_ransac_kernels,
              .depth = &avx512_depth_kernels,
              .plane_search = &avx512_plane_search_kernels});
#endif
}

}  // namespace

void run_cases(Write write) noexcept {
  const Report report(write);
  write("build " SAME_BITS_BUILD "\n");
  make_inputs();
  for_each_set([&](const Kernels& kernels) noexcept {
    if (!kernels.runs_here) return;
    write("kernels ");
    write(kernels.name);
    write("\n");
    number_cases(report);
    canny_stage_cases(report);
    canny_cases(report);
    canny_row_cases(report, *kernels.canny_rows);
    hough_line_cases(report, kernels);
    line_fit_cases(report);
    plane_fit_cases(report);
    hough_direction_cases(report);
    hough_plane_cases(report);
    hough_patch_cases(report, kernels);
    ransac_cases(report, kernels);
    ransac_search_cases(report, kernels);
    frame_plane_cases(report, kernels);
    octree_cases(report);
  });
}

}  // namespace same_bits
