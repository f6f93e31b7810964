// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// Flags with which the core would give other bits than everywhere else are refused while it is compiled:
// docs/same-bits.md.
#include <limits>

#ifdef __FAST_MATH__
#error "Straightedge's core must not be compiled with -ffast-math or -Ofast: results would change."
#endif

static_assert(__FLT_EVAL_METHOD__ == 0,
              "floating point must be rounded after every operation; on i686: -msse2 -mfpmath=sse");
static_assert(std::numeric_limits<float>::is_iec559 && std::numeric_limits<double>::is_iec559,
              "floating point must be that of IEEE 754");
