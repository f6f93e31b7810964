// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "report.hpp"
#include "straightedge/canny_row_kernels.hpp"
#include "straightedge/depth_kernels.hpp"
#include "straightedge/hough_kernels.hpp"
#include "straightedge/plane_search_kernels.hpp"
#include "straightedge/ransac_kernels.hpp"

/// The list of cases. Each prints rows named topic.function.options; a row a stage, so that a difference says
/// where it begins.
namespace same_bits {

/// The tables of one instruction set, as the host's KernelSet, which small processors have not.
struct Kernels {
  const char* name;
  bool runs_here;
  const straightedge::CannyRowKernels* canny_rows = &straightedge::plain_canny_row_kernels;
  const straightedge::HoughKernels* hough = nullptr;  ///< one pixel at a time
  const straightedge::RansacKernels* ransac = &straightedge::plain_ransac_kernels;
  const straightedge::DepthKernels* depth = &straightedge::plain_depth_kernels;
  const straightedge::PlaneSearchKernels* plane_search = &straightedge::plain_plane_search_kernels;
};

void number_cases(const Report& report) noexcept;
void canny_stage_cases(const Report& report) noexcept;
void canny_cases(const Report& report) noexcept;
void canny_row_cases(const Report& report, const straightedge::CannyRowKernels& kernels) noexcept;
void hough_line_cases(const Report& report, const Kernels& kernels) noexcept;
void line_fit_cases(const Report& report) noexcept;
void plane_fit_cases(const Report& report) noexcept;
void hough_direction_cases(const Report& report) noexcept;
void hough_plane_cases(const Report& report) noexcept;
void hough_patch_cases(const Report& report, const Kernels& kernels) noexcept;
void ransac_cases(const Report& report, const Kernels& kernels) noexcept;
void ransac_search_cases(const Report& report, const Kernels& kernels) noexcept;
void frame_plane_cases(const Report& report, const Kernels& kernels) noexcept;
void octree_cases(const Report& report) noexcept;

/// A line "build ..." that says compiler, flags and processor; then all cases, once for each set of kernels,
/// with a line "kernels NAME" before its rows.
void run_cases(Write write) noexcept;

}  // namespace same_bits
