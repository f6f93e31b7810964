// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "report.hpp"
#include "straightedge/canny_row_kernels.hpp"

/// The list of cases. Each prints rows named topic.function.options; a row a stage, so that a difference says
/// where it begins.
namespace same_bits {

void number_cases(const Report& report) noexcept;
void canny_stage_cases(const Report& report) noexcept;
void canny_cases(const Report& report) noexcept;
void canny_row_cases(const Report& report, const straightedge::CannyRowKernels& kernels) noexcept;
void hough_line_cases(const Report& report) noexcept;
void line_fit_cases(const Report& report) noexcept;
void plane_fit_cases(const Report& report) noexcept;
void hough_direction_cases(const Report& report) noexcept;
void hough_plane_cases(const Report& report) noexcept;
void hough_patch_cases(const Report& report) noexcept;
void ransac_cases(const Report& report) noexcept;
void ransac_search_cases(const Report& report) noexcept;
void frame_plane_cases(const Report& report) noexcept;
void octree_cases(const Report& report) noexcept;

/// A line "build ..." that says compiler, flags and processor; then all cases, once for each set of kernels,
/// with a line "kernels NAME" before its rows.
void run_cases(Write write) noexcept;

}  // namespace same_bits
