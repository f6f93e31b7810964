// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

namespace straightedge::detail {

/// The arc tangents of 0, 1/8, ... 1: for arc_tangent (trigonometry.hpp) and for kernels that compute many,
/// which may share numbers with it but no functions.
inline constexpr double arc_tangents_of_eighths[] = {0.0,
                                                     0.12435499454676144,
                                                     0.24497866312686414,
                                                     0.35877067027057225,
                                                     0.4636476090008061,
                                                     0.5585993153435624,
                                                     0.6435011087932844,
                                                     0.7188299996216245,
                                                     0.7853981633974483};

}  // namespace straightedge::detail
