// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "straightedge/host/pose.hpp"

namespace straightedge::io {

/// What a file's rotation may be off before it is refused.
inline constexpr double rotation_tolerance = 1e-2;

/// Null and the pose filled, or why there is no such rotation. Entries row by row.
const char* take_rotation(const std::array<double, 9>& matrix, Pose& pose) noexcept;

/// The same from a quaternion with its real part last.
const char* take_rotation(const std::array<double, 4>& quaternion, Pose& pose) noexcept;

}  // namespace straightedge::io
