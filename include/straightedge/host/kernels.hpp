// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

#include "straightedge/canny_row_kernels.hpp"
#include "straightedge/depth_kernels.hpp"
#include "straightedge/host/result.hpp"
#include "straightedge/hough_kernels.hpp"
#include "straightedge/octree_kernels.hpp"
#include "straightedge/plane_search_kernels.hpp"
#include "straightedge/ransac_kernels.hpp"

/// Which of the core's tables of kernels this machine can run. All give the same bits; they differ in time.
namespace straightedge {

/// Registering of depth frames into a plane map, step 1 to 3 of PlaneMapBuilder.
struct PlaneRowKernels;
extern const PlaneRowKernels plain_plane_row_kernels;
#if defined(__x86_64__)
extern const PlaneRowKernels avx2_plane_row_kernels;
extern const PlaneRowKernels avx512_plane_row_kernels;
#endif

/// What build_line_map reads of a picture: its pixels, its edge points, gray along lines.
struct PictureRowKernels;
extern const PictureRowKernels plain_picture_row_kernels;
#if defined(__x86_64__)
extern const PictureRowKernels avx2_picture_row_kernels;
extern const PictureRowKernels avx512_picture_row_kernels;
#endif

/// The tables made for one instruction set.
struct KernelSet {
  std::string_view name;  ///< "plain", "sse2", "avx2" or "avx512"
  const CannyRowKernels* canny_rows = &plain_canny_row_kernels;
  const RansacKernels* ransac = &plain_ransac_kernels;
  const HoughKernels* hough = &plain_hough_kernels;
  const DepthKernels* depth = &plain_depth_kernels;
  const PlaneSearchKernels* plane_search = &plain_plane_search_kernels;
  const OctreeKernels* octree = &plain_octree_kernels;
  const PlaneRowKernels* plane_rows = &plain_plane_row_kernels;
  const PictureRowKernels* picture_rows = &plain_picture_row_kernels;
};

/// Those that the processor has the instructions for: plain first, the fastest last.
std::span<const KernelSet> kernel_sets();

const KernelSet& best_kernels();

/// `bad_option` when this machine has no set of that name.
Result<KernelSet> kernels_by_name(std::string_view name);

/// The set that the environment variable STRAIGHTEDGE_KERNELS names, the best one without it. For programs
/// and tests: the library itself never reads the environment.
Result<KernelSet> kernels_from_environment();

}  // namespace straightedge
