// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include "cases.hpp"

#include "inputs.hpp"
#include "straightedge/detail/x86_instructions.hpp"

namespace same_bits {
namespace {

struct KernelSet {
  const char* name;
  const straightedge::CannyRowKernels& canny_rows;
  bool runs_here;
};

template <class Run>
void for_each_set(Run run) noexcept {
  using namespace straightedge;
  run(KernelSet{"plain", plain_canny_row_kernels, true});
#if defined(__x86_64__)
  run(KernelSet{"sse2", sse2_canny_row_kernels, true});
  run(KernelSet{"avx2", avx2_canny_row_kernels, detail::has_avx2()});
  run(KernelSet{"avx512", avx512_canny_row_kernels, detail::has_avx512()});
#endif
}

}  // namespace

void run_cases(Write write) noexcept {
  const Report report(write);
  write("build " SAME_BITS_BUILD "\n");
  make_inputs();
  for_each_set([&](const KernelSet& kernels) noexcept {
    if (!kernels.runs_here) return;
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
  });
}

}  // namespace same_bits
