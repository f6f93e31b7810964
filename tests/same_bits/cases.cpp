// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cases.hpp"

#include "inputs.hpp"

namespace same_bits {
namespace {

struct KernelSet {
  const char* name;
  const straightedge::CannyRowKernels& canny_rows;
};
constexpr KernelSet kernel_sets[] = {{"plain", straightedge::plain_canny_row_kernels}};

}  // namespace

void run_cases(Write write) noexcept {
  const Report report(write);
  write("build " SAME_BITS_BUILD "\n");
  make_inputs();
  for (const KernelSet& kernels : kernel_sets) {
    write("kernels ");
    write(kernels.name);
    write("\n");
    number_cases(report);
    canny_stage_cases(report);
    canny_cases(report);
    canny_row_cases(report, kernels.canny_rows);
    hough_line_cases(report);
    line_fit_cases(report);
    plane_fit_cases(report);
    hough_direction_cases(report);
    hough_plane_cases(report);
    hough_patch_cases(report);
    ransac_cases(report);
    ransac_search_cases(report);
    frame_plane_cases(report);
    octree_cases(report);
  }
}

}  // namespace same_bits
