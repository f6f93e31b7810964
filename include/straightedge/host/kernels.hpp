// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

#include "straightedge/canny_row_kernels.hpp"
#include "straightedge/host/result.hpp"

/// Which tables of kernels this machine can run. All give the same bits; they differ in time.
namespace straightedge {

/// Registering of depth frames into a plane map, step 1 to 3 of PlaneMapBuilder.
struct PlaneRowKernels;
extern const PlaneRowKernels plain_plane_row_kernels;
#if defined(__x86_64__)
extern const PlaneRowKernels avx2_plane_row_kernels;
extern const PlaneRowKernels avx512_plane_row_kernels;
#endif

/// The tables made for one instruction set.
struct KernelSet {
  std::string_view name;  ///< "plain", "sse2", "avx2" or "avx512"
  const CannyRowKernels* canny_rows = nullptr;
  const PlaneRowKernels* plane_rows = nullptr;
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
