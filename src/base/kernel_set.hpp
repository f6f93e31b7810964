// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

// Files of kernels are compiled once for each instruction set (kernel_sets.cmake) and put what they define
// into a namespace of its name, so that no copy is taken for another. They include nothing that defines
// inline functions that are not their own: the linker may keep any copy of those.
#ifndef STRAIGHTEDGE_KERNEL_SET
#define STRAIGHTEDGE_KERNEL_SET plain
#endif

#define STRAIGHTEDGE_JOIN_NAMES(set, name) set##name
#define STRAIGHTEDGE_NAME_FOR(set, name) STRAIGHTEDGE_JOIN_NAMES(set, name)

/// The table of the set: STRAIGHTEDGE_OF_SET(_canny_row_kernels) is avx2_canny_row_kernels.
#define STRAIGHTEDGE_OF_SET(name) STRAIGHTEDGE_NAME_FOR(STRAIGHTEDGE_KERNEL_SET, name)
