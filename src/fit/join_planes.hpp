// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "straightedge/frame_planes.hpp"

namespace straightedge::detail {

inline constexpr std::uint16_t gone = 0xFFFF;

/// Step 4 of frame_planes.hpp: joins planes that are one. `moments` are those of the planes' own pixels,
/// about the picture's origin. `becomes[k]` is k for a plane that is there, or `gone`; a plane that is joined
/// into an earlier one gets that one's index.
void join_planes(std::span<ProposedPlane> planes, std::span<InverseDepthMoments> moments,
                 const FramePlanesOptions& options, std::span<std::uint16_t> becomes) noexcept;

}  // namespace straightedge::detail
