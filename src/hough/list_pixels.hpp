// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "straightedge/hough_job.hpp"

namespace straightedge::hough {

/// Counts the edge pixels, marks them as waiting, and lists those for which there is room.
std::uint32_t list_pixels(HoughJob& job) noexcept;

}  // namespace straightedge::hough
