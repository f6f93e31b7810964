// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include "straightedge/host/image.hpp"

namespace straightedge::io {

inline constexpr Rgb face_colour{0xD6, 0x28, 0x28};    ///< the face of a wall
inline constexpr Rgb axis_colour{0x0B, 0x5F, 0xC4};    ///< the axis of a thin wall, and its width
inline constexpr Rgb free_colour{0x1F, 0x8A, 0x3B};    ///< ticks towards the open floor
inline constexpr Rgb camera_colour{0xC2, 0x41, 0x0C};  ///< the path of a camera
inline constexpr double band_opacity = 0.3;            ///< of the width of a thin wall

}  // namespace straightedge::io
