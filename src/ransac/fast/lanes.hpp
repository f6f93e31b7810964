// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

// A register of floats of one instruction set, under a name that all sets share, so that a kernel is written
// once and compiled for each. `count` says how many. A comparison gives a Mask.
//
// Whatever is compiled here lies in a namespace of its instruction set, and includes nothing whose functions
// others share: the linker might keep a copy that not every machine can run.
#if defined(__AVX512BW__)
#include "ransac/fast/lanes_avx512.hpp"
#else
#include "ransac/fast/lanes_avx2.hpp"
#endif
