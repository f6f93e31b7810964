// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "ransac/readings.hpp"
#include "straightedge/found_planes.hpp"

namespace straightedge::ransac {

/// What label_nearest and refit_labelled do for clouds, for the pixels of a frame. All labels are 0 before.
std::uint32_t label_nearest_pixels(const Readings& readings, std::span<const FoundPlane> planes,
                                   std::span<std::uint16_t> labels) noexcept;

void refit_labelled_pixels(const Readings& readings, std::span<const std::uint16_t> labels,
                           std::span<FoundPlane> planes) noexcept;

}  // namespace straightedge::ransac
