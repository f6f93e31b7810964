// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

/// Two loops that planes cost most in, compiled for AVX2 with and without fused multiply-add.
#define SPEED_LOOPS_DECLARED                                                           \
  float score_plane(const float* x, const float* y, const float* z, std::size_t count, \
                    const float* plane); /* sum of min(e², 1) */                      \
  void sum_products(const float* x, const float* y, const float* z, std::size_t count, \
                    float* products) /* xx xy xz yy yz zz */

namespace bench::speed::separate {
SPEED_LOOPS_DECLARED;
}
namespace bench::speed::fused {
SPEED_LOOPS_DECLARED;
}
