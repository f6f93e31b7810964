// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "straightedge/detail/x86_instructions.hpp"
#include "straightedge/hough_kernels.hpp"

namespace straightedge::test {

/// Those that this machine can run, the plain one first.
inline std::vector<const HoughKernels*> kernel_tables() {
  std::vector<const HoughKernels*> tables{&plain_hough_kernels};
#if defined(__x86_64__)
  if (detail::has_avx2()) tables.push_back(&avx2_hough_kernels);
  if (detail::has_avx512()) tables.push_back(&avx512_hough_kernels);
#endif
  return tables;
}

}  // namespace straightedge::test
