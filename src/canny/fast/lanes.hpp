// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

// The vectors of one instruction set, under names that all sets share, so that a kernel is written once and
// compiled for each. Lanes16 are 16-bit numbers, Lanes32 32-bit ones; `count` says how many. A comparison
// gives a Mask, which `select` takes.
//
// Whatever is compiled here lies in a namespace of its instruction set, and includes nothing whose functions
// others share: the linker might keep a copy that not every machine can run.
#if defined(__AVX512BW__)
#include "canny/fast/lanes_avx512.hpp"
#elif defined(__AVX2__)
#include "canny/fast/lanes_avx2.hpp"
#else
#include "canny/fast/lanes_sse2.hpp"
#endif
