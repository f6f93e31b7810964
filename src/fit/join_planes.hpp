// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "straightedge/frame_planes.hpp"

namespace straightedge::detail {

/// Step 4 of frame_planes.hpp: joins planes that are one, into the earlier of the two. `moments` are those
/// of the planes' own pixels, about the picture's origin. Returns how many are left; they move up.
std::uint32_t join_planes(std::span<PlaneCandidate> planes, std::span<InverseDepthMoments> moments,
                          const FramePlanesOptions& options) noexcept;

}  // namespace straightedge::detail
