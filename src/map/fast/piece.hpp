// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

// The same results as plane_piece.hpp; read that first.
#if defined(__AVX512BW__)
#include "map/fast/piece_avx512.hpp"
#elif defined(__AVX2__)
#include "map/fast/piece_avx2.hpp"
#endif
